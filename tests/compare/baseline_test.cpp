// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handhold::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const GateName onset{.of_case = "C01", .run = "slides", .claim = "slip onset", .engine = "fast"};
const GateName order{.of_case = "C01", .run = "slides", .claim = "slip onset", .engine = "fast", .order = true};

Baseline before() {
  return {{onset, {.truth = 0.5, .value = 0.5001, .limit = 0.01}},
          {order, {.value = 0.02, .limit = 0.2, .uncertainty = 0.01}}};
}

/// `before`, with one gate changed.
Baseline with(const GateName& name, double Measured::*member, double value) {
  Baseline out = before();
  out[name].*member = value;
  return out;
}

std::vector<Movement> movements(const Baseline& now) {
  std::vector<Movement> out;
  for (const Change& change : changes(before(), now)) out.push_back(change.movement);
  return out;
}

TEST(BaselineChanges, AnErrorThatGrowsTenfoldInsideItsLimitIsSeen) {
  const std::vector<Change> found = changes(before(), with(onset, &Measured::value, 0.501));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].movement, Movement::away);
  EXPECT_EQ(sentence(found[0]),
            "C01/slides, slip onset, fast: 0.5001 -> 0.501, 10 times as far from the truth 0.5 (0.01 -> 0.1 of the "
            "limit)");
}

TEST(BaselineChanges, TheSignIsThatOfTheDistance) {
  EXPECT_THAT(movements(with(onset, &Measured::value, 0.49995)), ElementsAre(Movement::towards));
  EXPECT_THAT(movements(with(onset, &Measured::value, 0.4998)), ElementsAre(Movement::away));
}

TEST(BaselineChanges, RoundingIsNone) {  // 1e-5 of the limit, 1e-9 of the value
  EXPECT_THAT(movements(with(onset, &Measured::value, 0.5001 + 0.9e-7)), IsEmpty());
  EXPECT_THAT(movements(with(onset, &Measured::value, 0.5001 + 1.1e-7)), ElementsAre(Movement::away));
  Baseline tight = with(onset, &Measured::limit, 1e-6), moved = tight;
  moved[onset].value += 4e-10;
  EXPECT_THAT(changes(tight, moved), IsEmpty());
  moved[onset].value += 4e-10;
  EXPECT_EQ(changes(tight, moved).size(), 1u);
}

TEST(BaselineChanges, LimitsAndTruthsAreKnown) {
  EXPECT_THAT(movements(with(onset, &Measured::limit, 0.011)), ElementsAre(Movement::looser));
  EXPECT_THAT(movements(with(onset, &Measured::limit, 0.009)), ElementsAre(Movement::tighter));
  EXPECT_THAT(movements(with(onset, &Measured::truth, 0.5000001)), ElementsAre(Movement::other_truth));
}

TEST(BaselineChanges, ARelativeLimitIsAFractionOfTheTruth) {
  Baseline now = before();
  now[onset].relative = true;  // 0.01 of 0.5: half as wide
  EXPECT_THAT(movements(now), ElementsAre(Movement::tighter));
}

TEST(BaselineChanges, WhatIsGoneOrNewIsNamed) {
  Baseline now = before();
  now.erase(onset);
  now[{.of_case = "D01", .run = "holds", .claim = "slip", .engine = "fast"}] = {.truth = 0, .value = 0, .limit = 1};
  const std::vector<Change> found = changes(before(), now);
  EXPECT_THAT(movements(now), ElementsAre(Movement::gone, Movement::added));
  EXPECT_EQ(summary(found), "gates: 1 are gone, 1 are new");
}

TEST(BaselineChanges, AnOrderMovesByMoreThanItsStandardError) {
  EXPECT_THAT(movements(with(order, &Measured::value, 0.029)), IsEmpty());
  EXPECT_THAT(movements(with(order, &Measured::value, 0.031)), ElementsAre(Movement::away));
}

TEST(BaselineChanges, OrdersThatNobodyAskedForAreNotMissing) {
  Baseline now = before();
  now.erase(order);
  EXPECT_THAT(changes(before(), now), IsEmpty());
}

TEST(BaselineChanges, NoNumberIsFartherThanAny) {
  EXPECT_THAT(movements(with(onset, &Measured::value, std::numeric_limits<double>::quiet_NaN())),
              ElementsAre(Movement::away));
  EXPECT_THAT(changes(with(onset, &Measured::value, std::numeric_limits<double>::quiet_NaN()),
                      with(onset, &Measured::value, std::numeric_limits<double>::quiet_NaN())),
              IsEmpty());
}

}  // namespace
}  // namespace handhold::compare
