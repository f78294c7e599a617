#include <cmath>

#include "cases/closed_form/incline.hpp"
#include "cases/closed_form/pushed_block.hpp"
#include "cases/closed_form/stopping.hpp"
#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

namespace exact = closed_form;

double c01_incline(const Options& options) {
  Worst worst;
  for (const double slope : {0.5, 0.7, 1.2}) {
    const exact::Incline incline{slope, g, {0.5, 0.4}};
    RigidProblem p = block(0.2, incline.friction, exact::time_at(incline, 0.1));
    p.gravity = tilted_gravity(slope);
    const Trajectory t = run(p, options);
    worst.add(t.frames.back().body.X_WO.p.x(), 0.1);
    worst.add(t.frames.back().body.V_WO.v.x(), exact::speed_at(incline, 0.1));
    worst.add_energy(t, 0.1);
  }
  return worst.value();
}

/// The same on a plane that is tilted itself, in an odd direction: nothing is aligned with the axes.
double c01_tilted_plane(const Options& options) {
  const exact::Incline incline{0.6, g, {0.5, 0.4}};
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, z_axis) * Eigen::AngleAxisd(0.6, y_axis));
  RigidProblem p = block(0.2, incline.friction, exact::time_at(incline, 0.1));
  p.supports[0].surface = make_plane({0, 0, 0}, turn * z_axis);
  const Trajectory t = run(p, options);
  Worst worst;
  const Eigen::Vector3d expected = 0.1 * (turn * x_axis);
  for (int i = 0; i < 3; ++i) worst.add(t.frames.back().body.X_WO.p[i], expected[i], 0.1);
  return worst.value();
}

double c02_flick(const Options& options) {
  Worst worst;
  for (const double slope : {0.6, 0.4}) {
    const exact::Flick flick{slope, 1, g, {0.5, 0.4}};
    const double end = exact::stop_time(flick) + (exact::returns(flick) ? exact::return_time(flick) : 0.1);
    RigidProblem p = block(0.2, flick.friction, end);
    p.gravity = tilted_gravity(slope);
    p.V_WB.v = -x_axis;
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 1);
    if (t.events.empty()) continue;
    worst.add(t.events[0].t, exact::stop_time(flick));
    worst.add(t.events[0].after.X_WO.p.x(), -exact::stop_distance(flick));
    worst.require(t.events[0].to == (exact::returns(flick) ? Mode::slip : Mode::stick));
    worst.add(t.frames.back().body.V_WO.v.x(), exact::return_speed(flick), 1);
    if (exact::returns(flick)) worst.add(t.frames.back().body.X_WO.p.x(), 0, 0.05);
  }
  return worst.value();
}

double c03_stopping(const Options& options) {
  Worst worst;
  for (const double palm : {0.0, 0.35}) {  // the palm may move: Galilei
    const exact::Stopping stopping{};
    RigidProblem p = block(0.2, {0.5, stopping.mu_dynamic}, 0.3);
    p.V_WB.v = (palm + stopping.speed) * x_axis;
    p.supports[0].motion = steady(palm * x_axis);
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 1);
    if (t.events.empty()) continue;
    worst.add(t.events[0].t, exact::stop_time(stopping));
    worst.add(t.events[0].after.X_WO.p.x() - palm * t.events[0].t, exact::stop_distance(stopping));
    worst.add(t.frames.back().energy.dissipated, exact::heat(stopping));
    worst.add_energy(t, exact::heat(stopping));
  }
  return worst.value();
}

double c04_load_ramp(const Options& options) {
  const exact::LoadRamp ramp{};
  RigidProblem p = block(ramp.mass, ramp.friction, 1.2);
  p.load = [&](double t, const BodyState&) { return Load{ramp.rate * t * x_axis, {0, 0, 0}}; };
  const Trajectory t = run(p, options);
  Worst worst;
  worst.require(t.events.size() == 1);
  if (t.events.empty()) return worst.value();
  worst.add(t.events[0].t, exact::slip_onset(ramp));
  worst.add(t.frames.back().body.X_WO.p.x(), exact::distance(ramp, 1.2));
  worst.add(t.frames.back().body.V_WO.v.x(), exact::speed(ramp, 1.2));
  worst.add_energy(t, 1);
  return worst.value();
}

/// Friction turns by 2.1 rad: the direction of sliding is the velocity's in two dimensions, down to the stop.
double oblique_slide(const Options& options) {
  Worst worst;
  for (const double slope : {0.3, 0.7}) {
    const exact::ObliqueSlide slide{slope, 0.45, 1.2, 2.1, g};
    const bool stops = slide.mu > std::tan(slope);
    const exact::ObliquePoint end = exact::at_angle(slide, stops ? 0 : 0.2);
    RigidProblem p = block(0.2, {slide.mu, slide.mu}, stops ? end.t + 0.1 : end.t);
    p.gravity = tilted_gravity(slope);
    p.V_WB.v = slide.speed * Eigen::Vector3d(std::cos(slide.angle), std::sin(slide.angle), 0);
    const Trajectory t = run(p, options);
    worst.add(t.frames.back().body.X_WO.p.x(), end.downhill);
    worst.add(t.frames.back().body.X_WO.p.y(), end.across);
    if (!stops) worst.add(t.frames.back().body.V_WO.v.norm(), end.speed);
    worst.require(t.events.size() == (stops ? 1u : 0u));
    if (stops && !t.events.empty()) worst.add(t.events[0].t, end.t);
  }
  return worst.value();
}

class OfBlocks : public ClosedForm {};

TEST_P(OfBlocks, AgreeWithTheirClosedForms) { check(); }

INSTANTIATE_TEST_SUITE_P(L1, OfBlocks,
                         at_all_accuracies({{"C01_incline", c01_incline},
                                            {"C01_tilted_plane", c01_tilted_plane},
                                            {"C02_flick", c02_flick},
                                            {"C03_stopping", c03_stopping},
                                            {"C04_load_ramp", c04_load_ramp},
                                            {"oblique_slide", oblique_slide}}),
                         case_name);

/// Stiction is exact: over a minute, a block under two thirds of its cone does not move by one bit.
TEST(Stiction, DoesNotCreepInAMinute) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 60);
  p.gravity = tilted_gravity(0.3);
  const Trajectory t = run(p, {1e-10, 1e-2, 1});
  ASSERT_EQ(t.outcome, Outcome::complete) << t.note;
  EXPECT_TRUE(t.events.empty());
  for (const Frame& f : t.frames) {
    EXPECT_EQ(f.body.X_WO.p.x(), 0);
    EXPECT_EQ(f.body.X_WO.p.y(), 0);
    EXPECT_EQ(f.supports[0].mode, Mode::stick);
  }
}

/// Where axes are odd, round-off of the accelerations remains: 1e-16 g, which the equations' own recovery keeps from
/// adding up (velocity error 1e-15/α = 1e-17 m/s, a minute of it 1e-15 m).
TEST(Stiction, KeepsRoundOffAtRoundOffOnAnOddPlane) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, z_axis) * Eigen::AngleAxisd(0.3, y_axis));
  RigidProblem p = block(0.2, {0.5, 0.4}, 60);
  p.supports[0].surface = make_plane({0, 0, 0}, turn * z_axis);
  const Trajectory t = run(p, {1e-10, 1e-2, 1});
  std::printf("[  figure  ] creep on an odd plane in 60 s: %.1e m\n", t.frames.back().body.X_WO.p.norm());
  EXPECT_LE(t.frames.back().body.X_WO.p.norm(), 1e-14);
  EXPECT_EQ(t.frames.back().supports[0].mode, Mode::stick);
}

TEST(Stiction, StopsForGood) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 20);
  p.gravity = tilted_gravity(0.4);
  p.V_WB.v = -x_axis;
  const Trajectory t = run(p, {1e-10, 1e-2, 1});
  ASSERT_EQ(t.events.size(), 1u);
  EXPECT_EQ(t.frames.back().body.X_WO.p.x(), t.events[0].after.X_WO.p.x());
}

}  // namespace
}  // namespace handhold::reference::rigid::testing
