// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/extrapolation.hpp"

#include <cmath>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/catalogue/scenes/limit_scenes.hpp"
#include "cases/closed_form/moved_pinch.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"

namespace handhold::compare {
namespace {

Extrapolation of(double exponent, double second = 0) {
  const std::vector<double> stiffness{100, 400, 1600};
  std::vector<double> value;
  for (const double k : stiffness) value.push_back(2 + 30 * std::pow(k, -exponent) + second / (k * std::sqrt(k)));
  return extrapolate(stiffness, value);
}

// 2 + 30/K: the leading term is cancelled, so that the limit is exact but for rounding.
TEST(Extrapolate, CancelsTheLeadingTerm) {
  const Extrapolation e = of(1);
  EXPECT_TRUE(e.regular);
  EXPECT_NEAR(e.limit, 2, 1e-14);
  EXPECT_NEAR(e.exponent, 1, 1e-12);
  EXPECT_LT(e.error, 1e-13);
}

// A term K^-3/2, as damping leaves: the error estimate covers what is left, and is not a wild guess.
TEST(Extrapolate, BoundsWhatIsLeft) {
  const Extrapolation e = of(1, 50);
  EXPECT_GT(std::abs(e.limit - 2), 1e-6);
  EXPECT_LT(std::abs(e.limit - 2), e.error);
  EXPECT_LT(e.error, 20 * std::abs(e.limit - 2));
}

TEST(Extrapolate, DoesNotContinueWhatIsNotInLine) {
  EXPECT_FALSE(of(0.2).regular);
  EXPECT_FALSE(of(3).regular);
  const Extrapolation zigzag = extrapolate({1, 4, 16}, {1.0, 3.0, 2.5});
  EXPECT_FALSE(zigzag.regular);
  EXPECT_EQ(zigzag.limit, 2.5);
  EXPECT_EQ(zigzag.error, 4);
  EXPECT_FALSE(extrapolate({1, 4, 16}, {1.0, std::nan(""), 2.5}).regular);
}

TEST(Extrapolate, RefusesWhatTellsNoExponent) {
  EXPECT_THROW((void)extrapolate({1, 4}, {1, 2}), InputError);
  EXPECT_THROW((void)extrapolate({1, 4, 10}, {1, 2, 3}), InputError);
  EXPECT_THROW((void)extrapolate({1, 1, 1}, {1, 2, 3}), InputError);
  EXPECT_THROW((void)extrapolate({1, 4, 16}, {1, 2}), InputError);
}

// Catalogue case D04 at A = 10 mm, 25 rad/s: onset, stop and slip from an independent event-driven integration.
TEST(VerticalShake, IsTheCatalogues) {
  const closed_form::VerticalShake s{.amplitude = 0.01, .frequency = 25, .friction = {0.5, 0.5}};
  EXPECT_NEAR(slip_onset(s), 0.147090, 5e-7);
  EXPECT_NEAR(stop_time(s), 0.277119, 5e-7);
  EXPECT_NEAR(slip(s), -0.012101, 5e-7);
}

/// Accuracy 1e-9 is 1e-8 m, a thousandth of what is looked for; steps of 1 ms are shorter than any event pair.
class Rigid : public ::testing::TestWithParam<std::size_t> {};

// L2 at three stiffnesses gives the closed form of L1: the limit lies within its own error estimate of it, which is
// a hundredth of the quantity or less; 1/K is what is seen.
TEST_P(Rigid, IsReachedFromCompliantRuns) {
  if (engine_names().front() != "reference") GTEST_SKIP() << "a build without Simbody";
  const catalogue::LimitScene& s = catalogue::limit_scenes()[GetParam()];
  EngineOptions options;
  options.accuracy = 1e-9;
  const Extrapolation e = extrapolate_to_rigid(*make_engine("reference"), s.scene, s.measure, s.stiffness, options);
  for (std::size_t i = 0; i < e.value.size(); ++i)
    std::cout << fmt::format("  {:6g} N/m: {:.6e}, off by {:.1e}\n", e.stiffness[i], e.value[i], e.value[i] - s.truth);
  std::cout << fmt::format("  limit {:.6e} +- {:.1e}, L1 {:.6e}, off by {:.1e}, exponent {:.3f}\n", e.limit, e.error,
                           s.truth, e.limit - s.truth, e.exponent);
  EXPECT_TRUE(e.regular);
  EXPECT_NEAR(e.exponent, 1, 0.25);
  EXPECT_LE(std::abs(e.limit - s.truth), e.error);
  EXPECT_LE(e.error, 0.01 * s.truth);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Rigid, ::testing::Values(0, 1));

}  // namespace
}  // namespace handhold::compare
