// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Reads a triangle mesh: OBJ, STL (text or binary), PLY, OFF, glTF or GLB, chosen by the file's extension.
///
/// Coordinates are multiplied by `scale` to become metres; axes stay as in the file. Several meshes in one file are
/// merged, each with the transforms of its nodes; equal points are joined. Points and lines are dropped, with a
/// sentence in `warnings` if given. The surface is as the file has it: `repair` closes and orients it.
///
/// Throws InputError naming the file (and line where it is text) if it is missing, empty, above 512 MB, truncated, not
/// finite, names vertices that do not exist, or is not a solid's size: at least 4 triangles, 1e-9 to 1e3 m across.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file, double scale = 1,
                             std::vector<std::string>* warnings = nullptr);

/// All bytes of a file; throws InputError if it is missing, no regular file, empty, or larger than 512 MB.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);

}  // namespace handhold
