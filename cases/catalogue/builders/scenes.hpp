// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// A block with exact float distances: edges and voxel size are powers of two (times small integers), so that the
/// planes of the shared voxel field lie where the closed forms have them, to the last bit.
inline constexpr double edge = 1.0 / 16;     ///< of the cube of most cases [m]
inline constexpr double voxel = 1.0 / 2048;  ///< [m]

/// A solid block of `size`, mass `mass` and its own inertia, at rest, centred at the origin of W.
[[nodiscard]] Body block(const Eigen::Vector3d& size, double voxel_size, double mass, const Friction& friction);

/// Where a hand is at time t: a pure translation of all its phalanges from where they are at t = 0.
using Path = std::function<Eigen::Vector3d(double t)>;

/// A sample ring of `count` points and radius `radius` about `center` in the plane normal to `axis`; the first point
/// lies along `first`, the others follow right-handed about `axis`.
[[nodiscard]] std::vector<Eigen::Vector3d> ring(const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                                                const Eigen::Vector3d& first, double radius, int count);

/// Points of one phalanx, as they are at t = 0, with how each starts and the way the phalanx moves.
struct MovingPatch {
  int phalanx{};
  std::vector<Eigen::Vector3d> p_W{};
  std::vector<SampleStart> start{};
  Path path{};
};

/// A hand that has these patches and no other contact; motion sampled at 2 kHz from 0.1 s before to 0.1 s after [0,
/// duration].
[[nodiscard]] Hand hand_of(const std::vector<MovingPatch>& patches, double duration);

/// A palm under the origin, facing up: an eight-sample ring of radius 20 mm in the plane z = 0.
[[nodiscard]] MovingPatch palm_patch(const SampleStart& start, const Path& path);

/// Thumb and index facing each other along y at ±(half_gap − depth): eight-sample rings of radius 4 mm.
/// `inwards(t)` is how far each has moved towards the other since t = 0, `path` their common motion.
[[nodiscard]] std::vector<MovingPatch> pinch_patches(double half_gap, double depth, const SampleStart& start,
                                                     const std::function<double(double)>& inwards, const Path& path);

}  // namespace handhold::catalogue
