// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace handhold {

/// What a look at a file's bytes promises: the reading library must deliver no less.
struct MeshPrescan {
  std::size_t faces{};      ///< polygons announced or listed; 0 if unknown
  std::size_t triangles{};  ///< at least so many once polygons are split; 0 if unknown
};

/// Checks the bytes of a mesh file before a library sees them, because libraries drop, wrap or crash on what is wrong.
///
/// OBJ and OFF: every number and index, with the line of the first wrong one. STL: size or structure. PLY: header and
/// plausible counts. GLB: header and length. `extension` is lower case with its dot; throws InputError naming `file`.
[[nodiscard]] MeshPrescan prescan_mesh(std::string_view bytes, const std::string& extension, const std::string& file);

}  // namespace handhold
