// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "cases/model/mesh.hpp"

namespace handhold {

/// What `repair` found and did.
struct RepairReport {
  bool closed_as_given{};          ///< every edge had two faces once equal points were joined
  bool oriented_as_given{};        ///< neighbours agreed on which side is out, and it was out
  std::size_t points_welded{};     ///< points that equalled another
  std::size_t degenerate_faces{};  ///< dropped: two corners in one point
  std::size_t duplicate_faces{};   ///< dropped: same corners as another
  std::size_t faces_flipped{};     ///< turned around
  std::size_t holes_filled{};
  std::size_t components{};          ///< connected pieces of the result
  std::size_t intersecting_pairs{};  ///< pairs of faces that pierce each other: volume counts their overlap twice
  double volume_uncertainty{};       ///< of the filled holes, as a part of the volume
  std::string method{};              ///< "as given", "oriented", "holes filled", joined by ", "
  std::string confidence{};          ///< one sentence
};

/// Makes a closed, outward-oriented surface of `mesh`: joins equal points, drops degenerate and duplicate faces, makes
/// neighbours agree, turns pieces outward (inner ones inward: cavities), fills small holes, unites pieces that overlap.
/// Of two faces with the same corners that face each other's way none stays if that closes the surface: a fin of two
/// sides, a wall between two solids.
///
/// Filled holes are accepted if their bulge could change the volume by less than 2 %, and if then the volume agrees
/// with a voxel count of the filled mesh within 2 %. Throws InputError if the surface cannot be closed, or if its
/// pieces overlap by more than that and cannot be united, saying why.
RepairReport repair(Mesh& mesh);

}  // namespace handhold
