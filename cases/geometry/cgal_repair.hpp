// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cases/geometry/mesh_cleanup.hpp"
#include "cases/model/mesh.hpp"

namespace handhold {

// CGAL's polygon mesh processing behind plain types. What CGAL refuses comes out as InputError; nothing is printed.

/// Whether no edge has more than two faces, none is run along twice the same way, and no two fans meet in one point
/// only.
[[nodiscard]] bool is_manifold(const Mesh& mesh);

/// Turns faces so that neighbours agree; splits points and edges where more than two faces meet.
void orient_soup(Mesh& mesh);

/// Turns the pieces of a closed mesh so that together they bound a volume (cavities inward).
void orient_outward(Mesh& mesh);

/// Fills the holes of an oriented manifold mesh, each with as few and small triangles as its border allows.
[[nodiscard]] HoleFilling fill_holes(Mesh& mesh);

/// Pairs of triangles that pierce or overlap each other (beyond a shared edge or corner).
[[nodiscard]] std::size_t count_self_intersections(const Mesh& mesh);

/// Replaces closed pieces that overlap by the surface of their union. False, and the mesh is left alone, if there are
/// fewer than two pieces or more than 64, if one faces inward or pierces itself, or if their union is no manifold.
[[nodiscard]] bool unite_pieces(Mesh& mesh);

}  // namespace handhold
