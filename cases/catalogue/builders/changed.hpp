// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "cases/model/problem.hpp"

namespace handhold::catalogue {

/// How a problem is changed, in this order: size and weight, mirror image, place and direction, passing by. The
/// defaults change nothing. Gravity keeps its size, so that times go with √length and forces with masses (Froude).
struct Change {
  double length{1}, mass{1};                       ///< lengths and masses by these factors
  bool mirrored{false};                            ///< y to −y, of W and of every body's and phalanx's own frame
  Pose X{};                                        ///< it stands and looks elsewhere
  Eigen::Vector3d boost{Eigen::Vector3d::Zero()};  ///< it passes by [m/s]
  /// Hands, and bones of fingers but the thumb's, are numbered the other way round: sums run in another order.
  bool renumbered{false};
  /// Bodies, given patches, their samples, supports and springs are listed the other way round.
  bool reversed{false};

  [[nodiscard]] int phalanx(int i) const { return renumbered && i >= 3 && i < palm ? palm + 2 - i : i; }
  [[nodiscard]] double time() const { return std::sqrt(length); }

  /// A vector of a body's own frame, or its orientation there, without its size.
  [[nodiscard]] Eigen::Vector3d own(const Eigen::Vector3d& v) const;
  [[nodiscard]] Eigen::Quaterniond own(const Eigen::Quaterniond& q) const;
  /// A vector of W, without its size: polar as a force, or axial as a torque.
  [[nodiscard]] Eigen::Vector3d polar(const Eigen::Vector3d& v) const;
  [[nodiscard]] Eigen::Vector3d axial(const Eigen::Vector3d& v) const;
  /// A velocity of a point.
  [[nodiscard]] Eigen::Vector3d velocity(const Eigen::Vector3d& v) const;
  /// Where a pose of the old problem is at time `t` of the changed one, and how it moves.
  [[nodiscard]] Pose pose(const Pose& Y, double t) const;
  [[nodiscard]] Twist twist(const Twist& V) const;
  /// The other way: what a state of the changed problem at its time `t` is in the old one.
  [[nodiscard]] BodyState old(const BodyState& state, double t) const;
};

/// Nothing is voxelized anew: the changed field has the numbers of the old one, so that what an engine does with it may
/// be compared to the last bit. `length` and `mirrored` count.
[[nodiscard]] std::shared_ptr<const VoxelField> changed(const VoxelField& field, const Change& change);

/// The hand's old motion, seen differently at every instant: poses and twists to rounding.
[[nodiscard]] Hand changed(const Hand& hand, const Change& change);

[[nodiscard]] Scene changed(const Scene& scene, const Change& change);
/// Loads of the changed problem ask the old one, with the body where it was there.
[[nodiscard]] RigidProblem changed(const RigidProblem& problem, const Change& change);
[[nodiscard]] Problem changed(const Problem& problem, const Change& change);

}  // namespace handhold::catalogue
