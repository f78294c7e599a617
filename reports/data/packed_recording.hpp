// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "reports/data/packed_columns.hpp"

namespace handhold::reports {

/// Packs what one engine played of `scene` for the 3D replay, with every body's mesh; returns the recording's name in
/// `blobs`. Header (JSON, version 1): times, bodies, hands (capsules, palm, given patches, when present), contact
/// tracks, events (to 10 us), scales. Columns over the frames, in this order: pose (x y z, then qw qx qy qz kept on one
/// side of the sphere) of each hand's shown phalanges, pose of each body, anchor (body frame) and force (world) of each
/// contact track, the five energies and what does not balance, CPU time of the frame; then a byte a frame for each
/// track: 0 absent, 1 apart, 2 stick, 3 slip. Lengths in m, forces in N, energies in J, times in s. One scale a unit:
/// see `Quantisation` for the bound. An absent contact repeats its last values.
std::string pack_recording(const Scene& scene, const Recording& recording, Blobs& blobs);

/// Packs a mesh: x, y, z of the vertices, each with its own scale, then the triangles' indices: their low, then their
/// high 16 bits.
std::string pack_mesh(const Mesh& mesh, Blobs& blobs);

}  // namespace handhold::reports
