// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cases/model/body.hpp"
#include "realtime/paper/middleware.hpp"

namespace handhold::realtime::paper {

/// A rigid body for the host: just what free motion needs.
struct HostBody {
  double mass{1};                                          ///< [kg]
  Eigen::Matrix3d inertia_O{Eigen::Matrix3d::Identity()};  ///< about the centre of mass [kg m²]
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};       ///< centre of mass in O [m]
  Mobility mobility{Mobility::free};
  BodyMotion motion{};  ///< v is the centre of mass's
};

/// The least of a physics engine: one rigid body, gravity, explicit forces. It stands for the engine behind the
/// middleware in tests of the discrete law; it collides with nothing.
class Host {
 public:
  Host(Middleware middleware, const HostBody& body, const Eigen::Vector3d& gravity, const HostOptions& options = {});

  /// One frame of `dt` [s] with the phalanges at `X_WP` (one pose a patch) and `applied` beside gravity.
  void advance(double dt, std::span<const Pose> X_WP, const Wrench& applied = {});

  [[nodiscard]] const HostBody& body() const { return body_; }
  [[nodiscard]] HostBody& body() { return body_; }
  [[nodiscard]] const Middleware& middleware() const { return middleware_; }
  [[nodiscard]] Middleware& middleware() { return middleware_; }
  [[nodiscard]] double time() const { return t_; }

 private:
  Middleware middleware_;
  HostBody body_;
  Eigen::Vector3d gravity_;
  HostOptions options_;
  BodyMotion old_;
  double t_{};
};

}  // namespace handhold::realtime::paper
