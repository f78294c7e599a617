// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/input/mesh/mesh_formats.hpp"
#include "cases/model/mesh.hpp"

namespace handhold {

/// The bytes of a mesh file and of the files it names, read once: what is looked up, read and kept is the same.
struct MeshFile {
  std::filesystem::path path{};
  std::string extension{};  ///< lower case, with its dot
  std::string bytes{};
  GltfBuffers buffers{};
};

/// Reads a mesh file and the external buffers of a glTF, all of them regular files; together at most 512 MiB. Throws
/// InputError for an extension that is no mesh format, and whatever `read_regular_file` refuses.
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& file);

/// Reads a triangle mesh: OBJ, STL (text or binary), PLY, OFF, glTF or GLB, chosen by the file's extension.
///
/// Coordinates are multiplied by `scale` to become metres; axes stay as in the file. Several meshes in one file are
/// merged, each with the transforms of its nodes; equal points are joined. Points and lines are dropped, faces that are
/// not planar cut one way, with a sentence in `warnings` if given. `repair` closes and orients the surface.
///
/// Throws InputError naming the file (and line where it is text) if it is truncated, not finite, names vertices that do
/// not exist, or is not a solid's size: at least 4 triangles, 1e-9 to 1e3 m across.
[[nodiscard]] Mesh read_mesh(const MeshFile& file, double scale = 1, std::vector<std::string>* warnings = nullptr);
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file, double scale = 1,
                             std::vector<std::string>* warnings = nullptr);

}  // namespace handhold
