// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joint_frames.hpp"

#include <gtest/gtest.h>

#include "cases/hand/hand_skeleton.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double rounding = 1e-12;

/// Joints of a hand posed by forward kinematics: where its bones meet, and the wrist at the lower end of the palm.
HandJoints joints_of(const HandModel& model, Side side, const Pose& X_WPalm, const std::array<FingerPose, 5>& fingers) {
  const auto X_WP = forward_kinematics(model, side, X_WPalm, fingers);
  HandJoints joints;
  for (std::size_t i = 0; i < 15; ++i) {
    const double half = model.capsules[i].half_length;
    const std::size_t first = static_cast<std::size_t>(joint_of(static_cast<int>(i) / 3, static_cast<int>(i) % 3));
    joints.joints[first].p_W = X_WP[i] * Vector3d(0, 0, -half);
    joints.joints[first + 1].p_W = X_WP[i] * Vector3d(0, 0, half);
  }
  joints.joints[wrist_joint].p_W = X_WPalm * Vector3d(0, 0, -model.palm_box.half_extents.z());
  return joints;
}

std::array<FingerPose, 5> bent() {
  std::array<FingerPose, 5> fingers{};
  for (int f = 0; f < 5; ++f) fingers[static_cast<std::size_t>(f)] = curled(f, 0.15 + 0.2 * f);
  return fingers;
}

const Pose somewhere{Quaterniond(AngleAxisd(1.1, Vector3d(2, -1, 2) / 3)), {0.2, -0.1, 1.3}};

// Positions alone give back the bones' axes and backs exactly (hinges fixed in the palm), for both sides. The knuckles
// of the built hand are not level with the palm's axis, so the palm found from wrist and knuckles is turned a little
// within its plane: by the angle of the knuckles' middle off the axis, which is what the tolerance of the backs allows
// for.
TEST(HandFromJoints, GivesBackTheBones) {
  const HandModel model = anatomical_hand();
  for (const Side side : {Side::left, Side::right}) {
    std::vector<std::string> warnings;
    const TraceHand hand =
        hand_from_joints(side, {joints_of(model, side, somewhere, bent())}, TipPlace::ball, warnings);
    const auto X_WP = forward_kinematics(model, side, somewhere, bent());
    ASSERT_TRUE(hand.samples[0].tracked);
    for (std::size_t i = 0; i < 15; ++i) {
      const Pose& X = hand.samples[0].X_WP[i];
      EXPECT_LT((X.R * Vector3d::UnitZ() - X_WP[i].R * Vector3d::UnitZ()).norm(), rounding) << i;
      EXPECT_LT((X.R * Vector3d::UnitY() - X_WP[i].R * Vector3d::UnitY()).norm(), 0.05) << i;
      if (i % 3 < 2) {
        EXPECT_LT((X.p - X_WP[i].p).norm(), rounding) << i;
        EXPECT_NEAR(hand.model.capsules[i].half_length, model.capsules[i].half_length, rounding) << i;
      }
    }
    EXPECT_LT(hand.samples[0].X_WP[palm].R.angularDistance(somewhere.R), 0.05);
    EXPECT_TRUE(warnings.empty());
  }
}

TEST(HandFromJoints, PalmReachesFromTheWristToTheKnuckles) {
  const HandModel model = anatomical_hand();
  std::vector<std::string> warnings;
  const TraceHand hand =
      hand_from_joints(Side::right, {joints_of(model, Side::right, somewhere, {})}, TipPlace::ball, warnings);
  // The knuckles' heights average to the palm's length by construction, so length and centre return (to the small
  // turn).
  EXPECT_NEAR(hand.model.palm_box.half_extents.z(), model.palm_box.half_extents.z(), 1e-4);
  EXPECT_LT((hand.samples[0].X_WP[palm].p - somewhere.p).norm(), 2e-3);
  EXPECT_NEAR(hand.model.palm_box.half_extents.x(), model.palm_box.half_extents.x(), 2e-3);
}

TEST(HandFromJoints, OrientationsDecideTheBacks) {
  HandJoints joints = joints_of(anatomical_hand(), Side::right, Pose{}, {});
  const Quaterniond rolled(AngleAxisd(0.4, Vector3d::UnitZ()));  // the index rolled about itself
  joints.joints[static_cast<std::size_t>(joint_of(1, 0))].R_WJ = rolled;
  std::vector<std::string> warnings;
  const TraceHand hand = hand_from_joints(Side::right, {joints}, TipPlace::skin, warnings);
  EXPECT_LT(hand.samples[0].X_WP[3].R.angularDistance(rolled), 1e-7);  // atan2 of a rounding error
}

// Index fingertip, 15.82 mm from joint to tip: where the capsule's skin ends by what the format means by its tip.
TEST(HandFromJoints, TipPlaces) {
  HandJoints joints = joints_of(anatomical_hand(), Side::right, Pose{}, {});
  for (HandJoints::Joint& joint : joints.joints) joint.radius = 0.006;
  const Vector3d dip = joints.p(joint_of(1, 2));
  joints.joints[static_cast<std::size_t>(joint_of(1, 3))].p_W = dip + Vector3d(0, 0, 0.0158);
  const auto skin = [&](TipPlace tip) {
    std::vector<std::string> warnings;
    const Capsule capsule = hand_from_joints(Side::right, {joints}, tip, warnings).model.capsules[5];
    return 2 * capsule.half_length + capsule.radius;
  };
  EXPECT_NEAR(skin(TipPlace::skin), 0.0158, rounding);
  EXPECT_NEAR(skin(TipPlace::ball), 0.0158 + 0.006, rounding);
  EXPECT_GT(skin(TipPlace::bone), 0.0158 + 0.003);  // and the soft tip, scaled to the hand
  EXPECT_LT(skin(TipPlace::bone), 0.0158 + 0.0045);
}

TEST(HandFromJoints, LengthsAreMedians) {
  std::vector<std::optional<HandJoints>> frames(5, joints_of(anatomical_hand(), Side::right, Pose{}, {}));
  frames[2]->joints[static_cast<std::size_t>(joint_of(1, 1))].p_W.z() += 1;  // one wild outlier
  std::vector<std::string> warnings;
  const TraceHand hand = hand_from_joints(Side::right, frames, TipPlace::ball, warnings);
  EXPECT_NEAR(hand.model.capsules[3].half_length, 0.03978 / 2, rounding);
}

TEST(HandFromJoints, MissingAndDegenerateFramesAreLostAndCounted) {
  const HandJoints good = joints_of(anatomical_hand(), Side::right, Pose{}, {});
  std::vector<std::optional<HandJoints>> frames(4, good);
  frames[1]->joints[7].p_W.y() = std::numeric_limits<double>::quiet_NaN();
  frames[2]->joints[wrist_joint].p_W =
      (good.p(joint_of(1, 0)) + good.p(joint_of(4, 0))) / 2;  // wrist between the knuckles
  frames[3].reset();
  std::vector<std::string> warnings;
  const TraceHand hand = hand_from_joints(Side::right, frames, TipPlace::ball, warnings);
  EXPECT_TRUE(hand.samples[0].tracked);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(hand.samples[i].tracked) << i;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("2 of 4 frames"), std::string::npos);
}

TEST(HandFromJoints, ABoneWithoutLengthPointsAsTheOneBefore) {
  HandJoints joints = joints_of(anatomical_hand(), Side::right, somewhere, bent());
  joints.joints[7].p_W = joints.joints[6].p_W;  // index tip in its last joint
  std::vector<std::string> warnings;
  const TraceHand hand = hand_from_joints(Side::right, {joints}, TipPlace::ball, warnings);
  ASSERT_TRUE(hand.samples[0].tracked);
  EXPECT_LT(hand.samples[0].X_WP[5].R.angularDistance(hand.samples[0].X_WP[4].R), 1e-7);
}

// A right hand seen as a left one has its palm upside down.
TEST(PalmAxes, SideDecidesWhatIsDorsal) {
  const HandJoints joints = joints_of(anatomical_hand(), Side::right, Pose{}, {});
  EXPECT_GT((palm_axes(Side::right, joints)->R * Vector3d::UnitY()).y(), 0.99);
  EXPECT_LT((palm_axes(Side::left, joints)->R * Vector3d::UnitY()).y(), -0.99);
}

TEST(PalmAxes, SideIsToldByTheIndex) {
  for (const Side side : {Side::left, Side::right}) {
    HandJoints joints = joints_of(anatomical_hand(), side, somewhere, bent());
    joints.joints[palm_joint] = {somewhere.p, somewhere.R, 0};
    EXPECT_EQ(side_of(joints), side);
  }
}

TEST(JointSets, HaveTheSpecifiedSizes) {
  EXPECT_EQ(joint_set("openxr").entries.size(), 26u);  // XR_HAND_JOINT_COUNT_EXT
  EXPECT_EQ(joint_set("webxr").entries.size(), 25u);   // XRHandJoint
  EXPECT_EQ(joint_set("mano").entries.size(), 21u);
  EXPECT_THROW((void)joint_set("kinect"), InputError);
}

// Places in XrHandJointEXT: THUMB_TIP 5, INDEX_PROXIMAL 7, LITTLE_TIP 25 (OpenXR 1.1); WebXR is the same without the
// palm.
TEST(JointSets, OrderIsThatOfTheSpecification) {
  EXPECT_EQ(joint_set("openxr").find("thumb_tip"), 5u);
  EXPECT_EQ(joint_set("openxr").find("index_proximal"), 7u);
  EXPECT_EQ(joint_set("openxr").find("little_tip"), 25u);
  EXPECT_EQ(joint_set("webxr").find("index-finger-phalanx-proximal"), 6u);
  EXPECT_EQ(joint_set("webxr").find("pinky-finger-tip"), 24u);
}

TEST(JointSets, EachJointOfOursOccursOnce) {
  for (const char* name : {"leap", "openxr", "webxr", "mano"}) {
    std::array<int, joint_count> seen{};
    for (const JointSet::Entry& e : joint_set(name).entries) {
      if (e.joint != unused_joint) ++seen[static_cast<std::size_t>(e.joint)];
    }
    for (int joint = 0; joint <= wrist_joint; ++joint)
      EXPECT_EQ(seen[static_cast<std::size_t>(joint)], 1) << name << joint;
  }
}

}  // namespace
}  // namespace handhold
