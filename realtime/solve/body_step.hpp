// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// Which point of a step the forces are taken at: 1, its end (implicit Euler, first order, swallows what it cannot
/// resolve), or 1/2, its middle (implicit midpoint, second order, keeps energy).
struct Scheme {
  double h{};       ///< step [s]
  double theta{1};  ///< 1 or 1/2
  /// Where arms and directions are taken, from the start [s]: the middle of a step for the midpoint rule. For Euler's
  /// its start: what swings then keeps its amplitude (symplectic), and a pair of bodies its angular momentum; the end
  /// would damp every swing.
  [[nodiscard]] double place() const { return theta == 1 ? 0 : theta * h; }
  [[nodiscard]] double reach() const { return theta * h; }         ///< from the start to where forces are taken [s]
  [[nodiscard]] double lead() const { return reach() - place(); }  ///< from `place` to there [s]
};

/// A body in one step: where forces are seen to act, and its momentum balance there.
///
///     (1 + θ h / τ) M (u0 + δ) = P0 + θ h (F + contact forces(δ))       τ only while a support holds it
///
/// with the change δ of velocity as unknown, M at the pose below and the momentum P0 (linear, angular about the
/// centre of mass) at the start. The angular momentum is carried over as it is, so there is no gyroscopic term and a
/// free body keeps it to the last bit but rounding.
struct BodyStep {
  Pose X_WO{};                                              ///< at the start
  Eigen::Matrix3d R{Eigen::Matrix3d::Identity()};           ///< of O in W, at `place`
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};          ///< at `place`, predicted as if it went on as it does, in W
  Eigen::Vector3d arm_O{Eigen::Vector3d::Zero()};           ///< from O's origin to the centre, R center_O
  Eigen::Quaterniond turn{Eigen::Quaterniond::Identity()};  ///< exp(h ω): of the step, if it went on as it does
  Vector6 u0{Vector6::Zero()};                              ///< velocity at the start
  Vector6 momentum{Vector6::Zero()};                        ///< P0
  Vector6 external{Vector6::Zero()};                        ///< F: gravity and load, at θ h [N], [N m]
  Vector6 load{Vector6::Zero()};                            ///< of it the load
  Matrix6 mass{Matrix6::Zero()};                            ///< (1 + θ h / τ) M
  Vector6 rest{Vector6::Zero()};                            ///< P0 + θ h F − mass u0: right side without contacts
  Vector6 change{Vector6::Zero()};                          ///< δ
  double per_arm{};                                         ///< 1 / radius: weighs torques against forces [1/m]
  double drag{};                                            ///< 1 / τ while a support holds the body, else 0
  bool held{false};
  bool turns{false};

  [[nodiscard]] Eigen::Vector3d origin() const { return center - arm_O; }
  [[nodiscard]] Vector6 velocity() const { return u0 + change; }
  /// |v|² of a force and a torque, or of momenta, as forces at the body's farthest point.
  [[nodiscard]] double squared_norm(const Vector6& v) const {
    return v.head<3>().squaredNorm() + per_arm * per_arm * v.tail<3>().squaredNorm();
  }
};

/// The step of a body under `gravity` [m/s²] and `load` [N], [N m] at θ h. A fixed body is predicted to stay. `s` is
/// new, or that of the same body in an earlier step.
void predict(const RigidBody& body, const Scheme& scheme, const Eigen::Vector3d& gravity, const Load& load, bool held,
             BodyStep& s);
[[nodiscard]] inline BodyStep predict(const RigidBody& body, const Scheme& scheme, const Eigen::Vector3d& gravity,
                                      const Load& load, bool held) {
  BodyStep s;
  predict(body, scheme, gravity, load, held, s);
  return s;
}

/// How the velocity would change without contacts: what a resting body would do if nothing held it.
[[nodiscard]] Eigen::Vector3d free_change(const RigidBody& body, const BodyStep& step, const Scheme& scheme);

/// Moves the body by u0 + δ held for h (x += h v, R = exp(h ω) R: exact for constant spin), and gives it the momentum
/// P0 + (P_θ − P0) / θ.
void move(RigidBody& body, const BodyStep& step, const Scheme& scheme);

}  // namespace handhold::realtime
