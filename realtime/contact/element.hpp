// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace handhold::realtime {

/// The contact element (spring and damper in parallel, in series with a Coulomb slider) over one fully implicit step.
///
/// Everything in W. The anchor is the body's material point at C; `v_C` is its velocity during the step.
struct ElementStep {
  double stiffness{};                              ///< k [N/m]
  double damping{};                                ///< c [N s/m]
  double h{};                                      ///< step [s]
  Eigen::Vector3d n{Eigen::Vector3d::Zero()};      ///< outward normal at C, unit
  Eigen::Vector3d reach{Eigen::Vector3d::Zero()};  ///< p at the end of the step − C at its start [m]
  Eigen::Vector3d v_p{Eigen::Vector3d::Zero()};    ///< velocity of p over the step [m/s]
};

/// Force of the element before friction limits it, at the end of the step.
struct Trial {
  double depth{};                                ///< d = −(p − C)·n [m]
  double N{};                                    ///< k d + c d', may be negative: then the sample is apart [N]
  Eigen::Vector3d lag{Eigen::Vector3d::Zero()};  ///< e = (p − C) + d n if the anchor sticks [m]
  Eigen::Vector3d v_t{Eigen::Vector3d::Zero()};  ///< tangential velocity of p against the object at C [m/s]
  Eigen::Vector3d t{Eigen::Vector3d::Zero()};    ///< t* = k e + c v_t [N]
  double t_norm{};                               ///< |t*|
};

[[nodiscard]] inline Trial trial(const ElementStep& s, const Eigen::Vector3d& v_C) {
  Trial r;
  const Eigen::Vector3d v = s.v_p - v_C;
  const Eigen::Vector3d reach = s.reach - s.h * v_C;
  const double closing = -v.dot(s.n);  // d'
  r.depth = -reach.dot(s.n);
  r.N = s.stiffness * r.depth + s.damping * closing;
  r.lag = reach + r.depth * s.n;
  r.v_t = v + closing * s.n;
  r.t = s.stiffness * r.lag + s.damping * r.v_t;
  r.t_norm = r.t.norm();
  return r;
}

/// `r` of a body that moves at v_C, given that at rest: N and t* only, which are linear, and all that a solve needs.
inline void move_trial(const ElementStep& s, const Trial& at_rest, const Eigen::Vector3d& v_C, Trial& r) {
  const double slope = s.h * s.stiffness + s.damping, along = s.n.dot(v_C);
  r.N = at_rest.N + slope * along;
  r.t = at_rest.t - slope * (v_C - along * s.n);
  r.t_norm = r.t.norm();
}

/// Which part of the element gives way: all that its slope needs to know.
struct Grip {
  bool presses{false};  ///< N is in the force
  bool slips{false};    ///< friction is at its limit
  double share{1};      ///< |f_t| / |t*|
  double mu{0};         ///< of the pressure that friction's limit grows with: then the slope is not symmetric
};

/// Force on the object at C.
struct ElementForce {
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< [N]
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< its tangential part [N]
  Grip grip{};
};

/// The whole t*: no limit while sticking.
[[nodiscard]] inline ElementForce sticking_force(const ElementStep& s, const Trial& trial) {
  return {-trial.N * s.n + trial.t, trial.t, {.presses = true}};
}

/// Friction limit while sliding: min(|t*|, μ_d N) along t*.
[[nodiscard]] inline ElementForce sliding_force(const ElementStep& s, const Trial& trial, double mu_dynamic) {
  const double cap = mu_dynamic * trial.N;
  if (trial.t_norm <= cap) return sticking_force(s, trial);
  const double share = cap / trial.t_norm;
  const Eigen::Vector3d tangent = share * trial.t;
  return {-trial.N * s.n + tangent, tangent, {.presses = true, .slips = true, .share = share, .mu = mu_dynamic}};
}

/// Presses as it must and pulls sideways with min(|t*|, cap) along t*, whatever the pressure: the slope of a convex
/// potential. `cap` >= 0 [N].
[[nodiscard]] inline ElementForce capped_force(const ElementStep& s, const Trial& trial, double cap) {
  ElementForce force{.tangent = trial.t, .grip = {.presses = trial.N > 0, .slips = trial.t_norm > cap}};
  if (force.grip.slips) {
    force.grip.share = cap / trial.t_norm;
    force.tangent *= force.grip.share;
  }
  force.f = force.tangent;
  if (force.grip.presses) force.f -= trial.N * s.n;
  return force;
}

/// How a force falls with v_C: df = −slope dv_C [N s/m].
[[nodiscard]] Eigen::Matrix3d slope_of(const ElementStep& step, const Trial& trial, const Grip& grip);

/// Lag at the end of a step that slid with tangential force f_t, from the lag e0 at its start: the radial return
/// e = (f_t + (c/h) e0) / (k + c/h), from f_t = k e + c (e − e0) / h.
[[nodiscard]] inline Eigen::Vector3d lag_after_sliding(const ElementStep& s, const Eigen::Vector3d& tangent,
                                                       const Eigen::Vector3d& lag_before) {
  const double rate = s.damping / s.h;
  return (tangent + rate * lag_before) / (s.stiffness + rate);
}

}  // namespace handhold::realtime
