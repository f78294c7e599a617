// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::realtime::baselines {

/// A body that rests, flies or is carried: all that a kinematic interaction knows of motion. It meets no other body.
class CarriedBody {
 public:
  explicit CarriedBody(const Body& body);

  /// Fixes it to a frame F, given where F is now ("the object is set to kinematic").
  void attach(const Pose& X_WF);
  /// Lets go: it flies on with the velocity it had.
  void detach() { X_FO_.reset(); }
  [[nodiscard]] bool attached() const { return X_FO_.has_value(); }

  /// `dt` seconds later, attached: F is now at X_WF. Velocity is the difference of poses.
  void follow(const Pose& X_WF, double dt);
  /// `dt` seconds later, free: rests while its support holds it (`t` is the time after the step), else flies: parabola
  /// of the centre of mass, exact; constant spin.
  void fly(const Eigen::Vector3d& gravity, double t, double dt);

  [[nodiscard]] const Pose& X_WO() const { return X_WO_; }
  [[nodiscard]] BodyState state() const;
  [[nodiscard]] double kinetic() const;
  [[nodiscard]] double height(const Eigen::Vector3d& gravity) const;  ///< −g · c [m²/s²]: potential energy by mass

 private:
  [[nodiscard]] Eigen::Vector3d center() const { return X_WO_ * inertia_.center; }

  Inertia inertia_;
  bool moves_{true};
  double held_until_{};
  Pose X_WO_{};
  Eigen::Vector3d v_{Eigen::Vector3d::Zero()}, w_{Eigen::Vector3d::Zero()};  // of the centre of mass, in W
  std::optional<Pose> X_FO_{};
};

}  // namespace handhold::realtime::baselines
