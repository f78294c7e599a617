// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/printed_law.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/closed_form/printed_grasp.hpp"
#include "tests/cases/closed_form/expected_json.hpp"

// Every closed form of L3 against the project's list (computed by another program, to 16 digits) and, where it is a sum
// or limit of frames, against plain iteration of the frame.

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::ExpectedSet;

constexpr double rounding = 4e-15;  // relative: some ten operations on either side

/// Skips where the list is absent.
#define FOR_EACH_SET(id, set)                                                       \
  const std::vector<ExpectedSet> sets = expected_sets(id);                          \
  if (sets.empty()) GTEST_SKIP() << "the shared data (expected.json) are not here"; \
  for (const ExpectedSet& set : sets)

void expect_relative(double value, double truth, double tolerance) {
  EXPECT_NEAR(value, truth, tolerance * std::abs(truth));
}

PrintedFace face_of(const ExpectedSet& set) {
  PrintedFace f;
  const auto take = [&](const char* name, double& value) {
    if (set.params.contains(name)) value = set.given(name);
  };
  take("gamma", f.gamma);
  take("mu_s", f.friction.mu_static);
  take("mu_d", f.friction.mu_dynamic);
  take("d", f.depth);
  take("eps", f.offset);
  take("dt", f.frame);
  return f;
}

PrintedPinch pinch_of(const ExpectedSet& set) {
  PrintedPinch p;
  p.face = face_of(set);
  p.samples = 2 * int(set.given("nsamp"));
  if (set.params.contains("m")) p.mass = set.given("m");
  p.gravity = set.given("g");
  return p;
}

TEST(PrintedLaw, L3_01_SignOfEquation1) {
  FOR_EACH_SET("L3-01", set) {
    const SpringFrames s{set.given("m"), set.given("n") * set.given("gamma"), 1e-5};
    expect_relative(spring_rate(s), set.number("rate"), rounding);
    const double d0 = set.given("d0"), t = set.given("t"), x = spring_rate(s) * t;
    expect_relative(d0 * std::cosh(x), set.number("d_printed"), rounding);
    // The frames' map tends to it with (λ dt / 2) tanh(λ t), from cosh(nθ) + sinh(nθ) tanh(θ / 2); the rest is O(dt²).
    const double first_order = spring_rate(s) * s.frame / 2 * std::tanh(x);
    const double discrete = attracted_depth(s, d0, int(std::lround(t / s.frame)));
    EXPECT_NEAR(discrete / set.number("d_printed") - 1, first_order, 10 * s.frame * s.frame * 4000);
    EXPECT_TRUE(set.expected.at("d_fixed").is_null());  // past d = 0: λ t = 3.16 > π / 2
    EXPECT_GT(x, std::numbers::pi / 2);
  }
}

TEST(PrintedLaw, L3_02_SteadySliding) {
  FOR_EACH_SET("L3-02", set) {
    const PrintedFace f = face_of(set);
    const double v = set.given("v"), N = f.gamma * f.depth;
    const double first = steady_slide_force(f, v, FrameOrder::force_first);
    const double second = steady_slide_force(f, v, FrameOrder::anchor_first);
    expect_relative(steady_slide_speed(f), set.number("v_c"), rounding);
    expect_relative(first, set.number("F_O1"), rounding);
    expect_relative(second, set.number("F_O2"), rounding);
    expect_relative(first / N, set.number("mu_eff_O1"), rounding);
    expect_relative(second / N, set.number("mu_eff_O2"), rounding);
  }
}

TEST(PrintedLaw, L3_02_TransientIsTheIteratedFrame) {
  const PrintedFace f;
  double lag = 0.002;  // before the ray: slips
  for (int n = 0; n < 50; ++n) {
    expect_relative(lag, sliding_lag(f, 0.2, 0.002, n), 50 * rounding);  // 50 roundings
    lag = contraction(f) * lag + 0.2 * f.frame;
  }
}

TEST(PrintedLaw, L3_03_ChatterMean) {
  FOR_EACH_SET("L3-03", set) {
    const PrintedFace f = face_of(set);
    const double v = set.given("v");
    expect_relative(chatter_friction(f), set.number("mu_eff"), rounding);
    expect_relative(chatter_share(f, v), set.number("frac"), rounding);
    // Iteration over 20 periods, from slip to slip.
    PrintedSlide s;
    double sum = 0;
    long frames = 0, slips = 0;
    while (slips <= 20) {
      s = next_slide(f, s.lag, v, FrameOrder::force_first);
      if (slips > 0) sum += s.force, ++frames;
      if (s.slips) ++slips;
    }
    EXPECT_NEAR(sum / double(frames) / (f.gamma * f.depth), chatter_friction(f),
                chatter_error(f, v) * chatter_friction(f));
    const double share = 20 / double(frames), limit = chatter_share(f, v);
    EXPECT_LE(share, limit / (1 - contraction(f) * limit));
    EXPECT_GE(share, limit / (1 + limit));
  }
}

TEST(PrintedLaw, L3_04_ImpulseIdentity) {
  constexpr int frames = 5000;  // the list gives the mean of so many
  FOR_EACH_SET("L3-04", set) {
    const PrintedFace f = face_of(set);
    const double v = set.given("v");
    PrintedSlide s;
    double sum = 0;
    for (int n = 0; n < frames; ++n) {
      s = next_slide(f, s.lag, v, FrameOrder::force_first);
      if (s.slips) sum += s.force;
    }
    const double identity = slip_impulse(f, v, frames, 0, s.lag);
    expect_relative(sum, identity, 1e-13);  // rounding of 5000 additions, random
    expect_relative(identity / frames, set.number("slipF"), 1e-13);
  }
}

TEST(PrintedLaw, L3_05_TerminalSpeed) {
  FOR_EACH_SET("L3-05", set) {
    PrintedPinch p = pinch_of(set);
    expect_relative(terminal_speed(p), set.number("v_O1"), rounding);
    p.order = FrameOrder::anchor_first;
    expect_relative(terminal_speed(p), set.number("v_O2"), rounding);
    for (const FrameOrder order : {FrameOrder::force_first, FrameOrder::anchor_first}) {
      p.order = order;
      PinchFrame s;
      for (int n = 0; n < 600; ++n) s = next_pinch(p, s);  // |λ|² = q at most: 0.714^300 = 1e-44
      expect_relative(s.speed, terminal_speed(p), 1e-13);
    }
  }
}

TEST(PrintedLaw, L3_06_BistableWindow) {
  FOR_EACH_SET("L3-06", set) {
    PrintedPinch p = pinch_of(set);
    expect_relative(holding_mass(p), set.number("m_static"), rounding);
    expect_relative(sliding_mass(p), set.number("m_slide"), rounding);
    const double K = p.samples * p.face.gamma;
    PinchFrame rest{.lag = p.mass * p.gravity / K};
    PinchFrame kicked{.speed = terminal_speed(p), .lag = p.mass * p.gravity / K / p.face.friction.mu_dynamic};
    for (int n = 0; n < 900; ++n) rest = next_pinch(p, rest), kicked = next_pinch(p, kicked);
    EXPECT_EQ(rest.fall < 1e-12, set.expected.at("rest_holds").get<bool>());
    EXPECT_EQ(kicked.slips, set.expected.at("slide_persists").get<bool>());
    // At 2 % below the limit the slide ends, at 2 % above it lasts.
    for (const double share : {0.98, 1.02}) {
      p.mass = share * sliding_mass(p);
      PinchFrame s{.speed = terminal_speed(p), .lag = p.mass * p.gravity / K / p.face.friction.mu_dynamic};
      bool stuck = false;
      for (int n = 0; n < 900; ++n) s = next_pinch(p, s), stuck |= !s.slips;
      EXPECT_EQ(stuck, share < 1);
    }
  }
}

TEST(PrintedLaw, L3_07_PatchOfOneCentroid) {
  FOR_EACH_SET("L3-07", set) {
    const PrintedFace f = face_of(set);
    const PatchCollapse collapse = patch_collapse(f, set.given("a"));
    expect_relative(collapse.radius, set.number("r_final"), rounding);
    EXPECT_EQ(collapse.frames, set.expected.at("frames").get<int>());
    expect_relative(stick_torque(f.gamma, 8, set.given("a"), set.given("phi")), set.number("torque_persample"),
                    rounding);
    // At these parameters a sample with a point of its own does not stick: its lag 2 a sin(φ/2) is above μ_s d. The
    // list's number is what it would give if it did.
    EXPECT_GT(2 * set.given("a") * std::sin(set.given("phi") / 2), f.friction.mu_static * f.depth);
  }
}

TEST(PrintedLaw, L3_08_Growth) {
  FOR_EACH_SET("L3-08", set) {
    const double K = set.given("n_ph") * set.given("samp") * set.given("gamma");
    const SpringFrames s{set.given("m"), K, set.given("dt")};
    expect_relative(least_stable_mass(K, s.frame), set.number("m_min"), rounding);
    expect_relative(explicit_growth(s), set.number("g_explicit"), rounding);
    expect_relative(held_growth(s, int(set.given("nsub"))), set.number("g_sub"), rounding);
    expect_relative(exact_hold_growth(s), set.number("g_zoh"), rounding);
    expect_relative(delayed_growth(s), set.number("g_delay"), rounding);
  }
}

TEST(PrintedLaw, L3_09_Centroid) {
  FOR_EACH_SET("L3-09", set) {
    const double r = set.given("r_c");
    PrintedPinch p = pinch_of(set);
    EXPECT_EQ(r, set.number("dead"));
    expect_relative(dead_time(r, set.given("V")), set.number("delay"), rounding);
    expect_relative(holding_penetration(p, r), set.number("pen"), rounding);
    const double pull = largest_pull(set.given("gamma"), int(set.given("nsamp")), r);
    expect_relative(pull, set.number("F_adh"), rounding);
    expect_relative(pull / p.gravity, set.number("m_adh"), rounding);
  }
}

TEST(PrintedLaw, L3_10_Release) {
  FOR_EACH_SET("L3-10", set) {
    const PrintedPinch p = pinch_of(set);
    const double K = p.samples * p.face.gamma, lag = p.face.friction.mu_static * p.face.depth;
    const double mass = release_mass(K, p.gravity, lag);
    expect_relative(mass, set.number("m_crit"), rounding);
    expect_relative(mass, holding_mass(p) / 2, rounding);
    // The window of L3-18 ends there: its upper end is below by m_min / (4 m) to first order.
    const auto window = release_window(K, p.face.frame, p.gravity, lag);
    ASSERT_TRUE(window.has_value());
    const double shift = least_stable_mass(K, p.face.frame) / (4 * mass);
    EXPECT_NEAR(window->most / mass, 1 - shift, 10 * shift * shift);
  }
}

TEST(PrintedLaw, L3_11_VoxelNormals) {
  FOR_EACH_SET("L3-11", set) {
    const TiltedPress press = tilted_press(face_of(set), set.given("ph"));
    EXPECT_EQ(press.sticks, set.expected.at("stick").get<bool>());
    expect_relative(press.normal, set.number("normal"), rounding);
    expect_relative(press.tangent, set.number("tang"), rounding);
    expect_relative(press.deviation, set.number("err"), rounding);
  }
}

TEST(PrintedLaw, L3_12_CycleGain) {
  FOR_EACH_SET("L3-12", set) {
    PrintedFace f = face_of(set);
    f.depth = set.given("d1");
    expect_relative(cycle_gain(f, set.given("s")), set.number("W"), rounding);
    EXPECT_LE(set.given("s"), f.friction.mu_static * set.given("d2"));  // pressed to d2 it sticks
  }
}

TEST(PrintedLaw, L3_13_Ball) {
  FOR_EACH_SET("L3-13", set) {
    const double R = set.given("R"), d = set.given("d"), eps = set.given("eps");
    double angle = ball_anchor(R, d, eps, set.given("be"));
    expect_relative(angle, set.number("b1"), rounding);
    for (int n = 1; n < 20; ++n) angle = ball_anchor(R, d, eps, angle);
    expect_relative(angle, set.number("b20"), 20 * rounding);
    // Small angles: the ray's fraction is ε / (d + ε), from x = (R + ε) β: β' / β = (R + ε) d / (R (d + ε)).
    const double small = ball_anchor(R, d, eps, 1e-6) / 1e-6;
    expect_relative(small, (R + eps) * d / (R * (d + eps)), 1e-9);  // the next order is β² = 1e-12 times R / d
  }
}

TEST(PrintedLaw, L3_14_Spin) {
  FOR_EACH_SET("L3-14", set) {
    const PrintedFace f = face_of(set);
    const double a = set.given("a"), w = set.given("w");
    expect_relative(spin_torque(f, 8, a, w), set.number("T"), rounding);
    EXPECT_EQ(spin_lag(f, a, w) > f.friction.mu_static * f.depth, set.expected.at("slips").get<bool>());
  }
}

TEST(PrintedLaw, L3_15_VanishingSqueeze) {
  FOR_EACH_SET("L3-15", set) {
    PrintedFace f = face_of(set);
    f.depth = 1e-9;  // the limit is approached as d / ε = 1e-6
    const double v = set.given("v"), N = f.gamma * f.depth;
    expect_relative(steady_slide_force(f, v, FrameOrder::force_first), set.number("F"), 1.01 * f.depth / f.offset);
    expect_relative(steady_slide_force(f, v, FrameOrder::anchor_first) / N, set.number("mu2"), rounding);  // exact
  }
}

double iterated_opening(PrintedPinch p, double rate, double* onset) {
  const double d0 = p.face.depth;
  PinchFrame s{.lag = p.mass * p.gravity / (p.samples * p.face.gamma)};
  for (int k = 0;; ++k) {
    const double t = k * p.face.frame;
    p.face.depth = d0 - rate * t;
    if (p.face.depth <= 0) return s.fall;
    s = next_pinch(p, s);
    if (s.slips && onset && *onset < 0) *onset = t;
  }
}

TEST(PrintedLaw, L3_16_OpeningCreep) {
  FOR_EACH_SET("L3-16", set) {
    PrintedPinch p = pinch_of(set);
    p.face.depth = set.given("d0");
    const double r = set.given("r");
    expect_relative(opening_onset(p, r), set.number("t_s"), rounding);
    expect_relative(opening_creep(p, r), set.number("z"), rounding);
    // The frames approach it as O(r): the error halves with r, and the extrapolation is an order better.
    double onset = -1;
    const double error = iterated_opening(p, r, &onset) / opening_creep(p, r) - 1;
    const double half = iterated_opening(p, r / 2, nullptr) / opening_creep(p, r / 2) - 1;
    EXPECT_GE(onset, opening_onset(p, r) - 1e-12);
    EXPECT_LT(onset, opening_onset(p, r) + p.face.frame);
    EXPECT_LT(std::abs(error), 3e-3);  // the list measured 2.75e-3 at this rate
    EXPECT_NEAR(error / half, 2, 0.2);
    EXPECT_LT(std::abs(2 * half - error), std::abs(error) / 10);
  }
}

TEST(PrintedLaw, L3_17_Drag) {
  FOR_EACH_SET("L3-17", set) {
    const PrintedDrag d{face_of(set), int(set.given("nsamp")), set.given("m"), set.given("mu_t"), set.given("g")};
    EXPECT_EQ(drag_slides(d), set.expected.at("slides").get<bool>());
    expect_relative(drag_lag_speed(d), set.number("lag"), rounding);
  }
}

TEST(PrintedLaw, L3_18_Overshoot) {
  FOR_EACH_SET("L3-18", set) {
    const SpringFrames s{set.given("m"), set.given("K"), set.given("dt")};
    const double g = set.given("g");
    expect_relative(released_lag(s, g, 37), set.number("s37"), 40 * rounding);  // cos(37.5 θ): 40 times θ's rounding
    expect_relative(largest_released_lag(s, g), set.number("sup"), rounding);
    const auto window = release_window(s.stiffness, s.frame, g, set.given("mu_s") * set.given("d"));
    const auto& expected = set.expected.at("window");
    EXPECT_EQ(window.has_value(), expected.at(1).get<double>() > 0);
    if (!window) continue;
    // The list found the ends by bisection (its own deviation there: 1e-9); ours are roots of a quadratic.
    expect_relative(window->least, expected.at(0).get<double>(), 1e-9);
    expect_relative(window->most, expected.at(1).get<double>(), 1e-9);
  }
}

TEST(PrintedLaw, L3_18_WindowEndsAreWhereTheOvershootReachesTheCone) {
  const auto window = release_window(1600, 1.0 / 90, 9.81, 0.00125);
  ASSERT_TRUE(window.has_value());
  for (const double mass : {window->least, window->most})
    expect_relative(largest_released_lag({mass, 1600, 1.0 / 90}, 9.81), 0.00125, 1e-13);
  EXPECT_LT(largest_released_lag({(window->least + window->most) / 2, 1600, 1.0 / 90}, 9.81), 0.00125);
}

}  // namespace
}  // namespace handhold::closed_form
