// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/slider_oscillator.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form/projectile.hpp"
#include "cases/model/input_error.hpp"
#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::integrate_until;
using testing::Point;
using testing::State;

/// The element integrated as what it is: state x, v, stretch q; nothing is assumed of its solution.
class Integrated {
 public:
  explicit Integrated(const SliderOscillator& o) : o_(o) {}

  [[nodiscard]] Point stick(const Point& start, double longest) const {
    const auto rates = [this](double t, const State& y) {
      const double rate = y[1] - o_.base.derivative(t);
      return State{y[1], (other(t, y) - o_.stiffness * y[2] - o_.damping * rate) / o_.mass, rate};
    };
    return integrate_until(
        rates, start,
        [this](double t, const State& y) {
          return std::abs(trial(t, y)) - o_.friction.mu_static * o_.normal_force.value(t);
        },
        longest);
  }

  [[nodiscard]] Point slip(const Point& start, int s, double longest) const {
    const auto rates = [this, s](double t, const State& y) {
      const double f = s * o_.friction.mu_dynamic * o_.normal_force.value(t);
      return State{y[1], (other(t, y) - f) / o_.mass, (f - o_.stiffness * y[2]) / o_.damping};
    };
    const auto over = [this, s](double t, const State& y) {
      return o_.friction.mu_dynamic * o_.normal_force.value(t) - s * trial(t, y);
    };
    return integrate_until(rates, start, over, longest);
  }

  [[nodiscard]] double trial(double t, const State& y) const {
    return o_.stiffness * y[2] + o_.damping * (y[1] - o_.base.derivative(t));
  }

 private:
  [[nodiscard]] double other(double t, const State& y) const {
    return o_.force.value(t) - o_.tether * (y[0] - o_.tether_end.value(t)) -
           o_.tether_damping * (y[1] - o_.tether_end.derivative(t));
  }
  SliderOscillator o_;
};

/// Everything at once: ramp and wave of the normal force, of the load, of both ends; tether and dampers.
SliderOscillator rich() {
  SliderOscillator o{.mass = 0.2, .stiffness = 900, .damping = 5, .friction = {0.6, 0.4}};
  o.normal_force = {.constant = 2, .rate = 0.3, .amplitude = 0.2, .frequency = 11, .phase = 0.4};
  o.force = {.constant = 0.1, .rate = 0.2, .curvature = 0.5, .amplitude = 1.9, .frequency = 9, .phase = 0.2};
  o.base = {.rate = 0.02, .curvature = 0.3, .amplitude = 0.004, .frequency = 13};
  o.tether = 40;
  o.tether_damping = 0.3;
  o.tether_end = {.rate = -0.01, .amplitude = 0.003, .frequency = 5};
  return o;
}

TEST(SliderOscillator, AgreesWithIntegrationOfEveryPhase) {
  const SliderOscillator o = rich();
  const SliderMotion motion(o, 1.2);
  const Integrated check(o);
  ASSERT_GE(motion.events().size(), 4U);
  Point at{0, {o.x, o.v, o.stretch}};
  int direction = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    at = direction == 0 ? check.stick(at, 1) : check.slip(at, direction, 1);
    direction = direction == 0 ? (check.trial(at.t, at.y) > 0 ? 1 : -1) : 0;
    const SliderEvent& e = motion.events()[i];
    // GSL at 1e-13 a step, some thousand steps; the force that decides crosses its limit at 10 N/s and more.
    EXPECT_NEAR(e.t, at.t, 1e-9) << i;
    EXPECT_EQ(e.direction, direction) << i;
    EXPECT_NEAR(e.state.x, at.y[0], 1e-10) << i;
    EXPECT_NEAR(e.state.v, at.y[1], 1e-8) << i;
    EXPECT_NEAR(e.state.stretch, at.y[2], 1e-10) << i;
  }
}

TEST(SliderOscillator, UndampedLagFollowsTheConeAndJumpsOntoItAtBreakaway) {
  SliderOscillator o{.mass = 0.2, .stiffness = 1000, .friction = {0.5, 0.3}};
  o.normal_force.constant = 2;
  o.force.rate = 4;
  const SliderMotion motion(o, 0.5);
  const double t = motion.breakaway().t;
  EXPECT_NEAR(motion.at(t - 1e-9).stretch, 0.5 * 2 / 1000, 1e-9);
  EXPECT_DOUBLE_EQ(motion.at(t).stretch, 0.3 * 2 / 1000);
  EXPECT_DOUBLE_EQ(motion.at(t + 0.01).friction, 0.6);
}

TEST(SliderOscillator, SaysWhatItCannotDo) {
  EXPECT_THROW(SliderMotion({.mass = 0}, 1), InputError);
  EXPECT_THROW(SliderMotion({.tether_damping = 1}, 1), InputError);
  EXPECT_THROW((void)SliderMotion({}, 1).breakaway(), InputError);
}

/// A lead moves the onset and nothing before it; not below the kinetic limit.
TEST(SliderOscillator, LeadsItsOnsets) {
  SliderOscillator o{.mass = 0.2, .stiffness = 1000, .damping = 10, .friction = {0.5, 0.3}};
  o.normal_force.constant = 2;
  o.force.rate = 4;
  const double onset = SliderMotion(o, 0.5).breakaway().t;
  EXPECT_NEAR(SliderMotion(o, 0.5, 1e-3).breakaway().t, onset - 1e-3, 1e-12);
  o.friction.mu_dynamic = 0.5;
  EXPECT_NEAR(SliderMotion(o, 0.5, 1e-3).breakaway().t, SliderMotion(o, 0.5).breakaway().t, 1e-12);
}

// The limit of a stiff element is rigid friction: the catalogue's L1 numbers, from which L2 differs by O(1/K) or, where
// the stiff spring is let go from rest, by its ringing, O(1/sqrt(K)); damping is critical, so that none lasts.
constexpr double stiff = 1e9;

SliderOscillator rigid(const testing::ExpectedSet& e, double mu_s, double mu_d) {
  const double m = e.given("m");
  SliderOscillator o{.mass = m, .stiffness = stiff, .damping = 2 * std::sqrt(stiff * m), .friction = {mu_s, mu_d}};
  o.normal_force.constant = m * 9.81;
  return o;
}

TEST(SliderOscillator, TendsToRigidFriction) {
  if (expected_sets("C04").empty()) GTEST_SKIP() << "expected.json is absent";
  for (const auto& e : expected_sets("C04")) {
    SliderOscillator o = rigid(e, e.given("mu_s"), e.given("mu_d"));
    o.force.rate = e.given("r");
    const SliderMotion motion(o, e.given("T") + 1e-3);
    EXPECT_NEAR(motion.breakaway().t, e.number("t_s"), 1e-6);
    EXPECT_NEAR(motion.at(e.given("T")).x, e.number("x"), 1e-6);
    EXPECT_NEAR(motion.at(e.given("T")).v, e.number("v"), 1e-5);
  }
  for (const auto& e : expected_sets("C05")) {
    SliderOscillator o = rigid(e, e.given("mu_s"), e.given("mu_d"));
    o.force = {.amplitude = e.given("F0"), .frequency = e.given("w")};
    const SliderMotion motion(o, e.number("t3") + 0.01);
    EXPECT_NEAR(motion.breakaway(1).t, e.number("t1"), 1e-5);
    EXPECT_NEAR(motion.restick(1).t, e.number("t2"), 1e-4);
    EXPECT_NEAR(motion.restick(1).state.x, e.number("slip"), 1e-6);
    EXPECT_NEAR(motion.breakaway(2).t, e.number("t3"), 1e-4);
  }
  for (const auto& e : expected_sets("C06")) {
    SliderOscillator o = rigid(e, e.given("mu_s"), e.given("mu_d"));
    o.tether = e.given("k");
    o.x = e.given("x0");
    o.direction = -1;
    o.stretch = -e.given("mu_d") * o.normal_force.constant / stiff;
    const SliderMotion motion(o, e.number("t") + 0.1);
    EXPECT_NEAR(motion.restick(e.expected.at("nhalf").get<int>()).t, e.number("t"), 1e-3);
    EXPECT_NEAR(motion.at(e.number("t") + 0.1).x, e.number("x"), 1e-5);
  }
  for (const auto& e : expected_sets("D03")) {
    SliderOscillator o = rigid(e, e.given("mu_s"), e.given("mu_d"));
    o.normal_force = {.constant = 2 * e.given("N0"), .rate = 2 * e.given("r")};
    o.force.constant = o.mass * 9.81;
    o.v = e.given("v0");
    o.direction = 1;
    o.stretch = e.given("mu_d") * o.normal_force.constant / stiff;
    const SliderMotion motion(o, 0.6);
    EXPECT_NEAR(motion.restick().t, e.number("t"), 1e-6);
    EXPECT_NEAR(motion.restick().state.x, e.number("slip"), 1e-7);
    EXPECT_EQ(motion.events().size(), 1U);  // holds
  }
}

TEST(Projectile, AgreesWithTheCatalogue) {
  for (const auto& e : expected_sets("A01")) {
    const Projectile p{.speed = e.given("vx"), .climb = e.given("vz"), .gravity = e.given("g")};
    EXPECT_NEAR(distance(p, e.given("T")), e.number("x"), 1e-15);
    EXPECT_NEAR(height(p, e.given("T")), e.number("z"), 1e-15);
    EXPECT_NEAR(apex_time(p), e.number("t_apex"), 1e-15);
    EXPECT_NEAR(apex_height(p), e.number("z_apex"), 1e-15);
  }
}

}  // namespace
}  // namespace handhold::closed_form
