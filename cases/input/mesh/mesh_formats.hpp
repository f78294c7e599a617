// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cases/input/mesh/polygon_soup.hpp"

namespace handhold {

// One strict reader a format. Each reads every number, index and count itself, checks it where it stands, and throws
// InputError with `file` and the line or element of the first wrong one. Memory is bounded by the size of `bytes`.

/// Vertices (`v`) and faces (`f`) in either case, of any number of corners, with negative indices, comments and
/// continued lines. Materials, curves and everything else is passed over.
[[nodiscard]] PolygonSoup parse_obj(std::string_view bytes, const std::string& file);

/// Text OFF, also with colours, normals or texture coordinates on its lines, and without its first word.
[[nodiscard]] PolygonSoup parse_off(std::string_view bytes, const std::string& file);

/// Text in either case, or binary. The size decides which, because some binary headers begin with "solid", too.
[[nodiscard]] PolygonSoup parse_stl(std::string_view bytes, const std::string& file);

/// Text or binary of either byte order; elements and properties in any order, those of other names are passed over.
[[nodiscard]] PolygonSoup parse_ply(std::string_view bytes, const std::string& file);

/// The bytes of a glTF's external buffers, by their URI.
using GltfBuffers = std::map<std::string, std::string>;

/// URIs of the buffers that are files of their own.
[[nodiscard]] std::vector<std::string> external_buffers(std::string_view bytes, const std::string& file);

/// glTF 2.0, as JSON or GLB: the triangles of its scene, each mesh as often as a node shows it, with the nodes'
/// transforms. Compressed geometry and every required extension that could change it is refused by name;
/// KHR_mesh_quantization is decoded. At most 2 million triangles.
[[nodiscard]] PolygonSoup parse_gltf(std::string_view bytes, const GltfBuffers& buffers, const std::string& file);

}  // namespace handhold
