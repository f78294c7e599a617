// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/detection/broad_phase.hpp"

#include <limits>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/realtime/random_grasp.hpp"

// Pairs against those found by asking every box for every other one.

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;
using Pairs = std::set<std::pair<int, int>>;

Pairs pairs_of(BroadPhase& broad_phase) {
  Pairs pairs;
  broad_phase.visit([&](int i, int j) {
    EXPECT_LT(i, j);
    EXPECT_TRUE(pairs.emplace(i, j).second) << i << " and " << j << " twice";
  });
  return pairs;
}

/// As of a hand that is not seen.
Box nowhere() {
  constexpr double far = std::numeric_limits<double>::max();
  return {Vector3d::Constant(far), Vector3d::Constant(-far)};
}

/// Boxes of 1 to 10 cm in a cube of 40 cm, or spread along one axis, of which some rest, some creep, some jump, and
/// some come and go: pairs are asked for only when they are outgrown, and hold whatever meets until then.
TEST(BroadPhase, MissesNoPairUntilItIsOutgrown) {
  constexpr int count = 60, steps = 400;
  for (int axis = -1; axis < 3; ++axis) {
    testing::Random random(std::uint64_t(axis + 2));
    BroadPhase broad_phase;
    broad_phase.resize(count);
    std::vector<Vector3d> middle(count), half(count), v(count);
    for (int i = 0; i < count; ++i) {
      middle[i] = random.in_ball(0.2);
      if (axis >= 0) middle[i][axis] *= 10;
      half[i] = Vector3d::Constant(random.uniform(0.005, 0.05));
      v[i] = i % 3 == 0 ? Vector3d(Vector3d::Zero()) : random.in_ball(i % 3 == 1 ? 1e-6 : 2e-3);
    }
    Pairs pairs;
    int searches = 0;
    for (int step = 0; step < steps; ++step) {
      std::vector<Box> boxes(count);
      for (int i = 0; i < count; ++i) {
        if (random.one_in(50)) v[i] = -v[i];
        middle[i] += v[i];
        const bool seen = i % 10 != 0 || (step / 7) % 2 == 0;
        boxes[i] = seen ? Box{middle[i] - half[i], middle[i] + half[i]} : nowhere();
        broad_phase.place(std::size_t(i), boxes[i], v[i].norm());
      }
      if (broad_phase.outgrown()) {
        pairs = pairs_of(broad_phase);
        ++searches;
        EXPECT_FALSE(broad_phase.outgrown());
      }
      for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
          if (boxes[i].meets(boxes[j])) {
            ASSERT_TRUE(pairs.contains({i, j})) << step << ": " << i << " and " << j;
          }
        }
    }
    EXPECT_LT(searches, steps);  // the rooms are good for something
  }
}

/// Room for twice the motion and 5e-4 of the shortest side: what is farther apart than two rooms is no pair.
TEST(BroadPhase, FindsNoPairOfBoxesThatAreFarApart) {
  BroadPhase broad_phase;
  broad_phase.resize(3);
  const double motion = 1e-3, room = 2 * motion + 5e-4;
  const Box box{Vector3d::Zero(), Vector3d::Ones()};
  const auto right_of = [&](const Box& other, double gap) {
    const Vector3d shift = (other.high.x() + gap) * Vector3d::UnitX();
    return Box{shift, shift + Vector3d::Ones()};
  };
  const Box near = right_of(box, 1.99 * room), far = right_of(near, 2.01 * room);
  broad_phase.place(0, far, motion);
  broad_phase.place(1, box, motion);
  broad_phase.place(2, near, motion);
  EXPECT_EQ(pairs_of(broad_phase), (Pairs{{1, 2}}));
}

TEST(BroadPhase, LooksOnceForWhatRests) {
  BroadPhase broad_phase;
  broad_phase.resize(2);
  const Box box{Vector3d::Zero(), Vector3d::Ones()};
  for (int step = 0; step < 3; ++step) {
    for (std::size_t i = 0; i < 2; ++i) broad_phase.place(i, box, 0);
    EXPECT_EQ(broad_phase.outgrown(), step == 0);
    if (broad_phase.outgrown()) {
      EXPECT_EQ(pairs_of(broad_phase), (Pairs{{0, 1}}));
    }
  }
}

}  // namespace
}  // namespace handhold::realtime
