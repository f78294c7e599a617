// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/hand_model.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "cases/hand/hand_skeleton.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double exact = 1e-15;  // sums and halves of a few numbers below 1

TEST(HandModel, NamesAreAllDifferentAndFoundAgain) {
  std::set<std::string> names;
  for (int i = 0; i < phalanx_count; ++i) {
    EXPECT_EQ(phalanx_from_name(phalanx_name(i)), i);
    names.emplace(phalanx_name(i));
  }
  EXPECT_EQ(names.size(), 16u);
  EXPECT_EQ(phalanx_name(0), "thumb_metacarpal");
  EXPECT_EQ(phalanx_name(5), "index_distal");
  EXPECT_EQ(phalanx_name(palm), "palm");
}

TEST(HandModel, UnknownNameListsTheNames) {
  try {
    (void)phalanx_from_name("index_metacarpal");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("index_proximal"), std::string::npos);
  }
}

// Buryanov & Kotiuk 2010, Table 2: index proximal phalanx 39.78 mm, distal 15.82 mm and 3.8 mm of soft tip.
TEST(HandModel, AnatomicalLengths) {
  const HandModel hand = anatomical_hand();
  EXPECT_NEAR(2 * hand.capsules[3].half_length, 0.03978, exact);
  // From the joint to the end of the skin.
  EXPECT_NEAR(2 * hand.capsules[5].half_length + hand.capsules[5].radius, 0.01582 + 0.0038, exact);
  EXPECT_NEAR(anatomical_hand(1.1).capsules[7].half_length, 1.1 * 0.02633 / 2, exact);
  EXPECT_TRUE(std::holds_alternative<PalmBox>(hand.shape(palm)));
  EXPECT_TRUE(std::holds_alternative<Capsule>(hand.shape(0)));
}

TEST(HandModel, AFingertipShorterThanItsRadiusIsABall) {
  EXPECT_EQ(capsule_of_fingertip(0.005, 0.009).half_length, 0.0);
}

// A straight finger: its bones lie one behind the other on the palm's z axis.
TEST(ForwardKinematics, StraightFinger) {
  const HandModel hand = anatomical_hand();
  const auto X_WP = forward_kinematics(hand, Side::right, Pose{}, {});
  const Vector3d knuckle = finger_bases(hand, Side::right)[1].p;
  EXPECT_LT((X_WP[3].p - (knuckle + Vector3d(0, 0, 0.03978 / 2))).norm(), exact);
  EXPECT_LT((X_WP[4].p - (knuckle + Vector3d(0, 0, 0.03978 + 0.02238 / 2))).norm(), exact);
}

// Knuckle bent by a right angle: the finger points along -y, to the palm side; then the middle joint by another: back
// along -z.
TEST(ForwardKinematics, RightAngles) {
  constexpr double right_angle = 1.57079632679489662;
  const HandModel hand = anatomical_hand();
  for (const Side side : {Side::left, Side::right}) {
    std::array<FingerPose, 5> fingers{};
    fingers[2].flexion = {right_angle, right_angle, 0};
    const auto X_WP = forward_kinematics(hand, side, Pose{}, fingers);
    const Vector3d knuckle = finger_bases(hand, side)[2].p;
    EXPECT_LT((X_WP[6].p - (knuckle + Vector3d(0, -0.04463 / 2, 0))).norm(), exact);
    EXPECT_LT((X_WP[7].p - (knuckle + Vector3d(0, -0.04463, -0.02633 / 2))).norm(), exact);
    EXPECT_LT((X_WP[6].R * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), exact);  // its back looks forward
  }
}

// A left hand is the mirror image of a right one (x -> -x), thumb and spread included.
TEST(ForwardKinematics, LeftMirrorsRight) {
  const HandModel hand = anatomical_hand();
  std::array<FingerPose, 5> fingers{};
  for (int f = 0; f < 5; ++f) fingers[static_cast<std::size_t>(f)] = curled(f, 0.4 + 0.1 * f);
  fingers[1].spread = 0.2;
  fingers[0].spread = -0.1;
  const auto left = forward_kinematics(hand, Side::left, Pose{}, fingers);
  const auto right = forward_kinematics(hand, Side::right, Pose{}, fingers);
  for (std::size_t i = 0; i < 15; ++i) {
    const Vector3d mirrored(-right[i].p.x(), right[i].p.y(), right[i].p.z());
    EXPECT_LT((left[i].p - mirrored).norm(), exact) << i;
    const Vector3d z = right[i].R * Vector3d::UnitZ();
    EXPECT_LT((left[i].R * Vector3d::UnitZ() - Vector3d(-z.x(), z.y(), z.z())).norm(), 2e-15) << i;
  }
  EXPECT_GT(right[0].p.x(), 0);  // palm down, fingers forward: a right thumb is at +x = y × z
}

TEST(ForwardKinematics, ThumbBendsTowardsTheFingers) {
  const HandModel hand = anatomical_hand();
  std::array<FingerPose, 5> bent{};
  bent[0] = curled(0, 1);
  const auto open = forward_kinematics(hand, Side::right, Pose{}, {});
  const auto closed = forward_kinematics(hand, Side::right, Pose{}, bent);
  EXPECT_LT(closed[2].p.x(), open[2].p.x() - 0.01);
}

}  // namespace
}  // namespace handhold
