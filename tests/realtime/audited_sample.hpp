// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A sample in an audited sub-step, and the law of its element written down anew.

#include "tests/realtime/audited_body.hpp"

namespace handhold::realtime::testing {

/// What a step was given for a sample, and what it should have made of it; in W.
struct AuditedSample {
  const AuditedBody* target{};
  const AuditedBody* source{};  // that the sample belongs to; null: a hand
  Scheme scheme{};
  double k{}, c{}, mu{};
  bool slides{false};
  bool touched{false};                                  // in this step
  Vector3d p0{Vector3d::Zero()}, p1{Vector3d::Zero()};  // the sample as the step begins and ends
  Vector3d p{Vector3d::Zero()};                         // where its arm is taken
  Vector3d C{Vector3d::Zero()}, n{Vector3d::Zero()};    // anchor before it slid, and normal there
  Vector3d f{Vector3d::Zero()};                         // force on the target, as the World tells

  [[nodiscard]] double slope() const { return k * scheme.reach() + c; }
  [[nodiscard]] Vector3d share() const { return (p1 - p0) / scheme.h; }
  /// Velocity of the sample in the step.
  [[nodiscard]] Vector3d velocity() const { return source ? source->velocity(p) : share(); }

  /// That of p against the target if no velocity changed: as if both moved on straight.
  [[nodiscard]] Vector3d straight_before() const {
    return (source ? source->velocity_before(p) : share()) - target->velocity_before(p);
  }
  /// The same, but in an Euler step as the target sees it, which turns and goes on as it does.
  [[nodiscard]] Vector3d seen_before() const {
    if (scheme.place() > 0) return straight_before();
    const double h = scheme.h;
    const Vector3d end = source ? source->goes_on(p, h) : p1, moved = target->center + h * target->u0;
    return (target->turn_before(h).conjugate() * (end - moved) - (p - target->center)) / h;
  }
  /// Relative velocity in the step.
  [[nodiscard]] Vector3d relative() const {
    const Vector3d v = seen_before() - target->change(p);
    return source ? Vector3d(v + source->change(p)) : v;
  }

  /// What rounding makes of its force: of positions a metre from the origin, times k [N].
  [[nodiscard]] double rounding() const {
    return 4e-15 * (k * (p1.norm() + target->center.norm()) +
                    slope() * (velocity().norm() + target->velocity(p).norm()) + c / scheme.h * p1.norm());
  }
  /// Velocities are the ends of sums of momenta, so that they are right to a share of the step's largest [N].
  [[nodiscard]] double speed_rounding() const {
    return 1e-15 * slope() * (target->u.norm() + target->w.norm() * (p - target->center).norm());
  }

  /// How far its force is outside its cone; one that pulls is, too [N].
  [[nodiscard]] double outside_cone() const {
    const double N = -f.dot(n);
    return std::max((f + N * n).norm() - mu * N, -N);
  }
  [[nodiscard]] Vector3d tangent() const { return f - f.dot(n) * n; }

  /// Its mean over an Euler step: it turns with the body by half of what that turns, for it is that of the start.
  [[nodiscard]] Vector3d mean_force() const {
    return rotation_by((scheme.place() > 0 ? 0 : 0.5 * scheme.h) * target->w) * f;
  }
  /// What a hand gave with it while its point moved: nothing if it rested, to third order nothing if all was turned.
  [[nodiscard]] double work_of_hand() const { return mean_force().dot(p1 - p0); }
};

/// Spring, damper and slider of a sample at the solution, as linearised.
struct AuditedElement {
  Vector3d v{Vector3d::Zero()};                         // relative velocity
  bool entered{false};                                  // from outside: its damper feels what is inside of its way
  Vector3d r0{Vector3d::Zero()}, r1{Vector3d::Zero()};  // p − C as the step begins and ends
  Vector3d rate{Vector3d::Zero()};                      // of p − C as the damper feels it
  double closing{};                                     // that of d
  Vector3d stretch{Vector3d::Zero()};                   // rate of the lag
  Vector3d slid{Vector3d::Zero()};                      // way of the slider, straight
  Vector3d f{Vector3d::Zero()};                         // force on the target

  explicit AuditedElement(const AuditedSample& s) {
    const double place = s.scheme.place(), reach = s.scheme.reach();
    v = s.relative();
    r0 = s.p - s.C - place * s.seen_before();
    r1 = r0 + s.scheme.h * v;
    entered = s.touched && r0.dot(s.n) > 0;
    const Vector3d r = r0 + reach * v;
    const double d = -r.dot(s.n);
    rate = entered ? Vector3d(r / reach) : v;
    closing = -rate.dot(s.n);
    const double N = s.k * d + s.c * closing;
    const Vector3d lag = r + d * s.n, v_t = rate + closing * s.n, pull = s.k * lag + s.c * v_t;
    stretch = v_t;
    f = pull - N * s.n;
    if (!s.slides) return;
    const Vector3d before = lag - reach * v_t, cap = s.mu * N * pull.normalized();
    f = cap - N * s.n;
    stretch = ((cap + s.c / reach * before) / (s.k + s.c / reach) - before) / reach;
    slid = s.scheme.h * (v_t - stretch);
  }
};

}  // namespace handhold::realtime::testing
