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

/// Force on the object at C and its derivative by v_C: df = −slope dv_C.
struct ElementForce {
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< [N]
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< its tangential part [N]
  Eigen::Matrix3d slope{Eigen::Matrix3d::Zero()};    ///< [N s/m]
  bool coupled{false};                               ///< friction at its limit μ N: slope is not symmetric
};

/// Friction limit while sliding: min(|t*|, μ_d N) along t*.
[[nodiscard]] ElementForce sliding_force(const ElementStep& step, const Trial& trial, double mu_dynamic);

/// Presses as it must and pulls sideways with min(|t*|, cap) along t*, whatever the pressure: the slope of a convex
/// potential. `cap` >= 0 [N].
[[nodiscard]] ElementForce capped_force(const ElementStep& step, const Trial& trial, double cap);

/// The whole t*: no limit while sticking.
[[nodiscard]] ElementForce sticking_force(const ElementStep& step, const Trial& trial);

/// Lag at the end of a step that slid with tangential force f_t, from the lag e0 at its start: the radial return
/// e = (f_t + (c/h) e0) / (k + c/h), from f_t = k e + c (e − e0) / h.
[[nodiscard]] inline Eigen::Vector3d lag_after_sliding(const ElementStep& s, const Eigen::Vector3d& tangent,
                                                       const Eigen::Vector3d& lag_before) {
  const double rate = s.damping / s.h;
  return (tangent + rate * lag_before) / (s.stiffness + rate);
}

}  // namespace handhold::realtime
