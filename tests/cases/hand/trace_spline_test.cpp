// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace_spline.hpp"

#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "cases/hand/trace_builder.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A circle in x and y and a screw about a tilted axis at constant rate: everything has a closed form.
struct Screw {
  double w_circle{5};
  double w_turn{4};
  Vector3d axis{Vector3d(1, 2, 2) / 3};

  [[nodiscard]] Pose pose(double t) const {
    return {Quaterniond(AngleAxisd(w_turn * t, axis)),
            Vector3d(0.1 * std::cos(w_circle * t), 0.1 * std::sin(w_circle * t), 0.3 * t)};
  }
  [[nodiscard]] Vector3d v(double t) const {
    return {-0.1 * w_circle * std::sin(w_circle * t), 0.1 * w_circle * std::cos(w_circle * t), 0.3};
  }
  [[nodiscard]] PoseFunction function() const {
    return [*this](double t) {
      std::array<Pose, phalanx_count> X_WP;
      X_WP.fill(pose(t));
      return X_WP;
    };
  }
};

Trace screw_trace(double rate) {
  return sample_trace("screw", Side::right, anatomical_hand(), Screw{}.function(), -1, 2, rate);
}

struct Errors {
  double p{}, v{}, w{}, angle{};
};

/// Largest errors inside [0, 1]; the trace begins a second earlier and ends one later, where the ends are natural.
Errors errors_at(double rate) {
  const TraceSpline motion(screw_trace(rate), 0);
  Errors e;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    const Pose X = motion.pose(7, t);
    const Twist V = motion.twist(7, t);
    e.p = std::max(e.p, (X.p - Screw{}.pose(t).p).norm());
    e.angle = std::max(e.angle, X.R.angularDistance(Screw{}.pose(t).R));
    e.v = std::max(e.v, (V.v - Screw{}.v(t)).norm());
    e.w = std::max(e.w, (V.w - Screw{}.w_turn * Screw{}.axis).norm());
  }
  return e;
}

// Cubic splines: order 4 in value and 3 in derivative (de Boor 1978, ch. V), to 0.1 between 60, 120 and 240 Hz. The
// rotation gains an order at a constant rate: q = (w/2)^4 q, so the leading error points along q and renormalising
// removes it.
TEST(TraceSpline, ConvergesAtTheOrderOfCubicSplines) {
  const Errors coarse = errors_at(60), middle = errors_at(120), fine = errors_at(240);
  EXPECT_NEAR(std::log2(coarse.p / middle.p), 4, 0.1);
  EXPECT_NEAR(std::log2(middle.p / fine.p), 4, 0.1);
  EXPECT_NEAR(std::log2(middle.angle / fine.angle), 5, 0.1);
  EXPECT_NEAR(std::log2(middle.v / fine.v), 3, 0.1);
  EXPECT_NEAR(std::log2(middle.w / fine.w), 4, 0.1);
}

// |x - s| <= 5/384 h^4 |x''''| for the complete spline (Hall & Meyer 1976); here |x''''| = 0.1 * 5^4, h = 1/120: 3.9e-9
// m.
TEST(TraceSpline, PositionErrorIsWithinTheSharpBound) {
  const double bound = 5.0 / 384 * std::pow(1.0 / 120, 4) * 0.1 * std::pow(5, 4);
  // Away from the knots' ends; the bound is for each coordinate, the error a vector of two.
  EXPECT_LT(errors_at(120).p, std::sqrt(2.0) * bound);
  EXPECT_GT(errors_at(120).p, 0.1 * bound);
}

// The twist is the exact derivative of the interpolant: central differences of it with step s agree within s²/6 |x'''|
// (about 1e-10 * 12.5 / 6 for s = 1e-5 on p, 1e-10 * 64 / 6 on the rotation) and rounding 1e-16 / 1e-5 * (distance 1).
TEST(TraceSpline, TwistIsTheDerivativeOfTheInterpolant) {
  const TraceSpline motion(screw_trace(30), 0);  // coarse: the interpolant itself is well off the screw
  const double s = 1e-5;
  for (int i = 1; i < 100; ++i) {
    const double t = 0.01 * i + 0.0003;
    const Pose before = motion.pose(3, t - s), after = motion.pose(3, t + s);
    const Twist V = motion.twist(3, t);
    EXPECT_LT(((after.p - before.p) / (2 * s) - V.v).norm(), 1e-9);
    const AngleAxisd turn(after.R * before.R.conjugate());
    EXPECT_LT((turn.angle() * turn.axis() / (2 * s) - V.w).norm(), 2e-9);
  }
}

// Across a knot: value, first and second derivative agree from both sides. One-sided second differences of velocity
// with step s differ by s |x'''| = 1e-6 * 100 at most; a C1 spline would jump by h |x'''| = 0.03 * 12.5 = 0.4.
TEST(TraceSpline, IsTwiceContinuouslyDifferentiableAtKnots) {
  const Trace trace = screw_trace(30);
  const TraceSpline motion(trace, 0);
  const double s = 1e-6;
  for (std::size_t i = 20; i < 60; ++i) {
    const double t = trace.t[i];
    const auto v = [&](double at) -> Vector3d { return motion.twist(0, at).v; };
    const auto w = [&](double at) -> Vector3d { return motion.twist(0, at).w; };
    EXPECT_LT((v(t - 1e-12) - v(t + 1e-12)).norm(), 1e-10);
    EXPECT_LT(((v(t) - v(t - s)) / s - (v(t + s) - v(t)) / s).norm(), 1e-3);
    EXPECT_LT(((w(t) - w(t - s)) / s - (w(t + s) - w(t)) / s).norm(), 1e-2);
  }
}

TEST(TraceSpline, PassesThroughItsSamples) {
  const Trace trace = screw_trace(50);
  const TraceSpline motion(trace, 0);
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    const Pose X = motion.pose(9, trace.t[i]);
    EXPECT_LT((X.p - trace.hands[0].samples[i].X_WP[9].p).norm(), 1e-14);
    // angularDistance takes twice an atan2 of rounding errors.
    EXPECT_LT(X.R.angularDistance(trace.hands[0].samples[i].X_WP[9].R), 1e-14);
  }
}

// q and -q are the same rotation: flipping the sign of every other sample changes nothing.
TEST(TraceSpline, QuaternionSignsDoNotMatter) {
  const Trace trace = screw_trace(60);
  Trace flipped = trace;
  for (std::size_t i = 0; i < flipped.t.size(); i += 2) {
    for (Pose& X : flipped.hands[0].samples[i].X_WP) X.R.coeffs() *= -1;
  }
  const TraceSpline a(trace, 0), b(flipped, 0);
  for (double t = 0.001; t < 1; t += 0.013) {
    EXPECT_LT(a.pose(2, t).R.angularDistance(b.pose(2, t).R), 1e-14);
    EXPECT_LT((a.twist(2, t).w - b.twist(2, t).w).norm(), 1e-12);
  }
}

void lose(Trace& trace, double begin, double end) {
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    if (trace.t[i] > begin && trace.t[i] < end) trace.hands[0].samples[i].tracked = false;
  }
}

// 100 Hz from -1 to 2 s. Lost inside (0.1, 0.15): the samples at both ends are 0.05 s apart, bridged. Inside (0.5,
// 0.9): 0.4 s.
TEST(TraceSpline, BridgesShortGapsAndSplitsAtLongOnes) {
  Trace trace = screw_trace(100);
  lose(trace, 0.095, 0.155);
  lose(trace, 0.495, 0.905);
  const TraceSpline motion(trace, 0);
  ASSERT_EQ(motion.presence().size(), 2u);
  EXPECT_NEAR(motion.presence()[0].begin, -1, 1e-12);
  EXPECT_NEAR(motion.presence()[0].end, 0.49, 1e-12);
  EXPECT_NEAR(motion.presence()[1].begin, 0.91, 1e-12);
  EXPECT_NEAR(motion.presence()[1].end, 2, 1e-12);
  ASSERT_EQ(motion.bridged().size(), 1u);
  EXPECT_NEAR(motion.bridged()[0].begin, 0.09, 1e-12);
  EXPECT_NEAR(motion.bridged()[0].end, 0.16, 1e-12);
  EXPECT_TRUE(motion.present(0.12));
  EXPECT_FALSE(motion.present(0.6));
  EXPECT_FALSE(motion.present(2.5));
}

TEST(TraceSpline, OutsidePresenceItRestsAtTheNearestEnd) {
  Trace trace = screw_trace(100);
  lose(trace, 0.495, 0.905);
  const TraceSpline motion(trace, 0);
  const auto expect_rest_at = [&](double t, double end) {
    EXPECT_LT((motion.pose(1, t).p - Screw{}.pose(end).p).norm(), 1e-12) << t;
    EXPECT_EQ(motion.twist(1, t).v.norm(), 0) << t;
    EXPECT_EQ(motion.twist(1, t).w.norm(), 0) << t;
  };
  expect_rest_at(-3, -1);
  expect_rest_at(0.69, 0.49);
  expect_rest_at(0.71, 0.91);
  expect_rest_at(9, 2);
  EXPECT_GT(motion.twist(1, 0.49).v.norm(), 0.1);  // the ends themselves belong to the presence
}

TEST(TraceSpline, ZeroBridgeSplitsAtEveryLostSample) {
  Trace trace = screw_trace(100);
  trace.hands[0].samples[150].tracked = false;
  TraceSplineOptions options;
  options.longest_bridge = 0;
  EXPECT_EQ(TraceSpline(trace, 0, options).presence().size(), 2u);
  EXPECT_EQ(TraceSpline(trace, 0).presence().size(), 1u);
}

// A trace at 5 Hz has ticks longer than the longest bridge: they are no gaps.
TEST(TraceSpline, ASlowTraceIsNotALostOne) {
  const TraceSpline motion(sample_trace("slow", Side::left, anatomical_hand(), Screw{}.function(), 0, 2, 5), 0);
  EXPECT_EQ(motion.presence().size(), 1u);
  EXPECT_EQ(motion.side(), Side::left);
}

TEST(TraceSpline, LonelySamplesAreNoPresence) {
  Trace trace = screw_trace(10);
  for (std::size_t i = 0; i < trace.t.size(); ++i) trace.hands[0].samples[i].tracked = i % 8 == 0;
  const TraceSpline motion(trace, 0);
  EXPECT_TRUE(motion.presence().empty());
  EXPECT_FALSE(motion.present(0));
  EXPECT_EQ(motion.twist(0, 0).v.norm(), 0);
}

TEST(TraceSpline, TwoSamplesMakeAStraightLine) {
  const TraceSpline motion(sample_trace("two", Side::right, anatomical_hand(), Screw{}.function(), 0, 0.1, 10), 0);
  const Vector3d middle = (Screw{}.pose(0).p + Screw{}.pose(0.1).p) / 2;
  EXPECT_LT((motion.pose(0, 0.05).p - middle).norm(), 1e-15);
}

TEST(TraceSpline, RejectsWhatIsNotThere) {
  const Trace trace = screw_trace(10);
  EXPECT_THROW(TraceSpline(trace, 1), InputError);
  TraceSplineOptions options;
  options.longest_bridge = std::nan("");
  EXPECT_THROW(TraceSpline(trace, 0, options), InputError);
}

TEST(SampleTrace, HitsBothEndsExactly) {
  const Trace trace = sample_trace("ends", Side::right, anatomical_hand(), Screw{}.function(), 0.1, 0.7, 90);
  EXPECT_EQ(trace.t.front(), 0.1);
  EXPECT_EQ(trace.t.back(), 0.7);
  EXPECT_EQ(trace.t.size(), 55u);  // 0.6 s at 90 Hz: 54 intervals
}

TEST(SampleTrace, RejectsAStretchThatCannotBeSampled) {
  const auto sample = [](double begin, double end, double rate) {
    return sample_trace("bad", Side::right, anatomical_hand(), Screw{}.function(), begin, end, rate);
  };
  EXPECT_THROW((void)sample(1, 1, 90), InputError);
  EXPECT_THROW((void)sample(0, 1, 0), InputError);
  EXPECT_THROW((void)sample(0, std::nan(""), 90), InputError);
  EXPECT_THROW((void)sample(0, INFINITY, 90), InputError);
}

TEST(ValidateTrace, NamesWhatIsWrong) {
  const Trace good = screw_trace(10);
  EXPECT_NO_THROW(validate(good));
  const auto message = [](const Trace& trace) -> std::string {
    try {
      validate(trace);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  Trace bad = good;
  bad.t[4] = bad.t[3];
  EXPECT_NE(message(bad).find("time stamp 4"), std::string::npos);
  bad = good;
  bad.t[2] = std::nan("");
  EXPECT_NE(message(bad).find("not finite"), std::string::npos);
  bad = good;
  bad.hands[0].samples.pop_back();
  EXPECT_NE(message(bad).find("30 samples for 31"), std::string::npos);
  bad = good;
  bad.hands[0].samples[5].X_WP[5].R.coeffs() *= 1.00001;
  EXPECT_NE(message(bad).find("sample 5, index_distal"), std::string::npos);
  bad.hands[0].samples[5].tracked = false;  // lost: its pose is meaningless
  EXPECT_EQ(message(bad), "accepted");
}

}  // namespace
}  // namespace handhold
