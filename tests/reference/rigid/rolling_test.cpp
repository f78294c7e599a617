#include "cases/closed_form/rolling.hpp"

#include <cmath>

#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

namespace exact = closed_form;

/// E01 and E02: slides, then rolls.
void sliding_ball(const exact::SlidingBall& b, double mass, const Options& options, Worst& worst) {
  const double roll = exact::roll_time(b), end = roll + 0.1;
  RigidProblem p = ball(mass, b.radius, b.beta, b.mu, end);
  p.V_WB.v.head<2>() = b.velocity;
  p.V_WB.w = b.spin;
  const Trajectory t = run(p, options);
  worst.require(t.events.size() == 1);
  if (t.events.empty()) return;
  worst.add(t.events[0].t, roll);
  const double scale = exact::position(b, roll).norm();
  for (const Frame& f : t.frames)
    for (int i = 0; i < 2; ++i) worst.add(f.body.X_WO.p[i], exact::position(b, f.t)[i], scale);
  const Twist& V = t.frames.back().body.V_WO;
  for (int i = 0; i < 2; ++i) worst.add(V.v[i], exact::roll_velocity(b)[i], 1);
  worst.add(V.w.z(), b.spin.z(), 1);
  worst.add(b.radius * V.w.y(), V.v.x(), 1);
  worst.add(t.frames.back().energy.dissipated, mass * exact::heat_per_mass(b));
  worst.add_energy(t, 0.1);
}

double e01_bowling_ball(const Options& options) {
  Worst worst;
  sliding_ball({0.04, 0.4, 0.3, {1.5, 0}, {0, 0, 0}, g}, 0.3, options, worst);
  sliding_ball({0.04, 0.5, 0.3, {1.5, 0}, {0, -60, 0}, g}, 0.3, options, worst);
  sliding_ball({0.04, 1.0, 0.3, {0.2, 0}, {0, 30, 0}, g}, 0.3, options, worst);
  return worst.value();
}

double e02_masse(const Options& options) {
  Worst worst;
  sliding_ball({0.03, 0.4, 0.25, {1, 0.2}, {40, 10, 5}, g}, 0.17, options, worst);
  sliding_ball({0.05, 0.6, 0.2, {0.4, -0.9}, {12, -25, 3}, g}, 0.3, options, worst);
  return worst.value();
}

/// A ball between the resting plate z = −r and one that presses from above and moves.
RigidProblem between_plates(double mass, double r, double beta, double N, double mu, const RigidPath& upper,
                            const RigidPath& lower, double duration) {
  RigidProblem p = ball(mass, r, beta, mu, duration);
  p.gravity.setZero();
  p.X_WB.p.setZero();
  p.supports[0].surface = make_plane(-r * z_axis, z_axis);
  p.supports[0].motion = lower;
  RigidSupport top = p.supports[0];
  top.surface = make_plane(r * z_axis, -z_axis);
  top.motion = upper;
  top.normal_force = [=](double) { return N; };
  p.supports.push_back(top);
  return p;
}

double e03_rolled_ball(const Options& options) {
  const exact::RolledBall b{};
  const double end = exact::slip_onset(b) + 0.2;
  const RigidPath plate = [=](double t) {
    return PathPoint{b.jerk * t * t * t / 6 * x_axis, b.jerk * t * t / 2 * x_axis, b.jerk * t * x_axis};
  };
  const Trajectory t = run(between_plates(b.mass, b.radius, b.beta, b.normal_force, b.mu, plate, {}, end), options);
  Worst worst;
  worst.require(t.events.size() == 1 && t.events[0].support == 1 && t.events[0].to == Mode::slip);
  if (t.events.empty()) return worst.value();
  worst.add(t.events[0].t, exact::slip_onset(b));
  for (const Frame& f : t.frames) worst.add(f.body.X_WO.p.x(), exact::position(b, f.t), exact::position(b, end));
  const Frame& last = t.frames.back();
  worst.add(b.jerk * end * end * end / 6 - 2 * last.body.X_WO.p.x(), exact::slip(b, end));
  worst.add(b.radius * last.body.V_WO.w.y(), last.body.V_WO.v.x());  // still rolls on the lower one
  const Frame& rolling = t.frames[10];
  worst.add(rolling.supports[1].friction_W.x(), b.mass * b.jerk * rolling.t * (1 + b.beta) / 4);
  worst.add(rolling.supports[0].friction_W.x(), b.mass * b.jerk * rolling.t * (1 - b.beta) / 4);
  worst.add_energy(t, 0.1);
  return worst.value();
}

double e04_carried_ball(const Options& options) {
  Worst worst;
  for (const double lower : {0.0, -0.2, 0.2}) {
    exact::CarriedBall b{};
    b.lower = lower;
    const Trajectory t = run(between_plates(b.mass, b.radius, b.beta, b.normal_force, b.mu, steady(b.upper * x_axis),
                                            steady(lower * x_axis), 0.04),
                             options);
    worst.require(t.events.size() == (lower == 0 ? 1u : 2u));
    for (const Event& e : t.events) {
      worst.add(e.t, exact::roll_time(b));
      worst.require(e.to == Mode::stick);
    }
    const Frame& last = t.frames.back();
    worst.add(last.body.V_WO.v.x(), exact::roll_speed(b), 0.2);
    worst.add(last.body.V_WO.w.y(), exact::roll_spin(b), 10);
    worst.add(last.energy.dissipated, exact::heat(b));
    worst.add_energy(t, 0.01);
  }
  return worst.value();
}

double e05_roll_down(const Options& options) {
  Worst worst;
  for (const exact::RollDown& b : {exact::RollDown{0.03, 0.4, 0.5, 0.3, g}, exact::RollDown{0.03, 0.5, 0.9, 0.3, g}}) {
    RigidProblem p = ball(0.2, b.radius, b.beta, b.mu, exact::time_at(b, 0.2));
    p.gravity = tilted_gravity(b.slope);
    const Trajectory t = run(p, options);
    const Frame& last = t.frames.back();
    worst.require(last.supports[0].mode == (exact::rolls(b) ? Mode::stick : Mode::slip));
    worst.add(last.body.X_WO.p.x(), 0.2);
    worst.add(last.body.V_WO.w.y(), exact::spin_at(b, 0.2));
    worst.add_energy(t, 0.1);
  }
  return worst.value();
}

class OfBalls : public ClosedForm {};

TEST_P(OfBalls, AgreeWithTheirClosedForms) { check(); }

INSTANTIATE_TEST_SUITE_P(L1, OfBalls,
                         at_all_accuracies({{"E01_bowling_ball", e01_bowling_ball},
                                            {"E02_masse", e02_masse},
                                            {"E03_rolled_ball", e03_rolled_ball},
                                            {"E04_carried_ball", e04_carried_ball},
                                            {"E05_roll_down", e05_roll_down}}),
                         case_name);

}  // namespace
}  // namespace handhold::reference::rigid::testing
