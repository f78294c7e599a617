// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/pose.hpp"

namespace handhold::compare::peers {

/// A primitive fixed to a body, in the body's frame.
struct PeerShape {
  enum class Kind { box, capsule };
  Kind kind{Kind::box};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< of a box [m]
  double radius{}, half_length{};                         ///< of a capsule, whose segment lies along z [m]
  Pose X_BS{};
};

enum class Role { fixed, driven, free };

/// A body as rigid-body engines know them. Frame B: the centre of mass, principal axes.
struct PeerBody {
  std::string name{};
  Role role{Role::free};
  std::vector<PeerShape> shapes{};
  double mass{};                                     ///< of a free body [kg]
  Eigen::Vector3d moments{Eigen::Vector3d::Zero()};  ///< principal [kg m²]
  double mu{};                                       ///< of free and fixed bodies; driven ones take their partner's
  Pose X_WB{};                                       ///< at t = 0
  Twist V_WB{};
};

/// A benchmark scene for an engine of boxes and capsules.
///
/// Bodies of the scene come first, in its order, then the phalanges that take part. Where handhold's support carries a
/// body until `held_until`, gravity is switched off until then: the same but for the support's oil.
struct PeerModel {
  std::vector<PeerBody> bodies{};
  std::size_t scene_bodies{};  ///< the first so many are the scene's
  std::vector<catalogue::ActivePhalanx> phalanges{};
  Eigen::Vector3d gravity{Eigen::Vector3d::Zero()};  ///< [m/s²]
  double gravity_from{};                             ///< [s]

  /// Hands move objects, objects move each other; nothing else collides.
  [[nodiscard]] static bool collide(Role a, Role b) { return a == Role::free || b == Role::free; }

  [[nodiscard]] double mu(std::size_t a, std::size_t b) const;
};

/// Throws InputError for a scene that boxes and capsules cannot express: given patches, a body without boxes or with
/// its centre of mass elsewhere, two coefficients of friction.
[[nodiscard]] PeerModel make_peer_model(const catalogue::BenchmarkScene& benchmark);

}  // namespace handhold::compare::peers
