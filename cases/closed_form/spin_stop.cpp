// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/spin_stop.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <gsl/gsl_integration.h>

#include "cases/closed_form/pendulum.hpp"
#include "cases/closed_form/pursuit.hpp"

namespace handhold::closed_form {
namespace {

double leash(const SpinStop& s) { return s.friction.mu_dynamic * s.normal_force / s.stiffness; }

double ratio(const SpinStop& s) { return s.radius / leash(s); }

/// Torque of both rings were it tangential: 2 μ_d N a.
double full_torque(const SpinStop& s) { return 2 * s.friction.mu_dynamic * s.normal_force * s.radius; }

/// ψ when friction has slowed the object to `spin`: ∫ T cos ψ dθ = I (ω1² − ω²) / 2.
double pursuit_at(const SpinStop& s, double spin) {
  const double w1 = breakaway_spin(s);
  const double work = s.inertia * (w1 * w1 - spin * spin) / (2 * full_torque(s));
  return pursuit_after_work(ratio(s), breakaway_angle(s) / 2, work);
}

/// An anchor as seen from the axis, the radius to its sample being the first axis: C = p − ρ (sin ψ, cos ψ).
struct AnchorPlace {
  double radius{}, angle{};  ///< `angle`: from it to the sample
};

AnchorPlace final_anchor(const SpinStop& s) {
  const double psi = pursuit_at(s, 0);
  const double outward = s.radius - leash(s) * std::sin(psi), behind = leash(s) * std::cos(psi);
  return {std::hypot(outward, behind), std::atan2(behind, outward)};
}

}  // namespace

double torsional_frequency(const SpinStop& s) { return std::sqrt(2 * s.stiffness * s.radius * s.radius / s.inertia); }

double critical_spin(const SpinStop& s) {
  return s.friction.mu_static * s.normal_force / s.stiffness * torsional_frequency(s) / s.radius;
}

double breakaway_angle(const SpinStop& s) {
  return 2 * std::asin(s.friction.mu_static * s.normal_force / (2 * s.stiffness * s.radius));
}

double breakaway_time(const SpinStop& s) { return time_to_angle(torsional_frequency(s), s.spin, breakaway_angle(s)); }

double breakaway_spin(const SpinStop& s) {
  const double turn = 2 * torsional_frequency(s) * std::sin(breakaway_angle(s) / 2);
  return std::sqrt(s.spin * s.spin - turn * turn);
}

double restick_angle(const SpinStop& s) {
  const double start = breakaway_angle(s);
  return start + pursuit_turn(ratio(s), start / 2, pursuit_at(s, 0));
}

double restick_time(const SpinStop& s) {
  // I dω = −T cos ψ dt: over ω the integrand is smooth up to the stop.
  const auto integrand = [](double spin, void* parameters) {
    const SpinStop& of = *static_cast<const SpinStop*>(parameters);
    return of.inertia / (full_torque(of) * std::cos(pursuit_at(of, spin)));
  };
  SpinStop copy = s;
  gsl_function f{integrand, &copy};
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(
      gsl_integration_workspace_alloc(200), gsl_integration_workspace_free);
  double slide = 0, error = 0;
  gsl_integration_qag(&f, 0, breakaway_spin(s), 0, 1e-13, 200, GSL_INTEG_GAUSS61, space.get(), &slide, &error);
  return breakaway_time(s) + slide;
}

double residual_amplitude(const SpinStop& s) { return final_anchor(s).angle; }

double residual_frequency(const SpinStop& s) {
  return std::sqrt(2 * s.stiffness * s.radius * final_anchor(s).radius / s.inertia);
}

double angle(const SpinStop& s, double t) {
  const bool slips = s.spin > critical_spin(s);
  if (!slips || t < breakaway_time(s)) return swing_from_bottom(torsional_frequency(s), s.spin, t);
  const double tau = t - restick_time(s);
  if (tau < 0) return std::numeric_limits<double>::quiet_NaN();
  const double amplitude = residual_amplitude(s);
  return restick_angle(s) - amplitude + swing_from_rest(residual_frequency(s), amplitude, tau);
}

}  // namespace handhold::closed_form
