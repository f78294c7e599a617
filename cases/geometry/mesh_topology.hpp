// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cases/model/mesh.hpp"

namespace handhold {

/// How the triangles of a mesh hang together, from its indices alone (no coordinates).
struct MeshTopology {
  std::size_t open_edges{};          ///< edges with one triangle
  std::size_t non_manifold_edges{};  ///< edges with more than two triangles
  std::size_t clashing_edges{};      ///< edges of two triangles that run along them in the same direction
  std::size_t unbalanced_edges{};    ///< edges run along more often in one direction than in the other
  std::size_t components{};          ///< pieces connected through shared vertices

  /// Every edge is run along as often forth as back: the surface bounds a volume and winding numbers are whole.
  [[nodiscard]] bool closed_and_oriented() const { return unbalanced_edges == 0; }
};

/// Throws InputError if a triangle names a vertex that does not exist.
[[nodiscard]] MeshTopology mesh_topology(const Mesh& mesh);

}  // namespace handhold
