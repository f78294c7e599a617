// SPDX-License-Identifier: GPL-3.0-or-later
// The loggers that applications copy, each in its engine's coordinates: all write the same motion.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "cases/input/log/object_log.hpp"
#include "docs/loggers/handhold_log.hpp"
#include "tests/cases/input/sample_joints.hpp"
#include "tests/cases/input/trace_fixtures.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr int frames = 8;
constexpr double radius = 0.008;
const char* const objects = R"({"cube": {"shape": "shape:box", "mass": 0.2, "friction": 0.5}})";

double time_of(int frame) { return 100 + frame / 72.0; }

/// In our coordinates.
Pose cube_at(int frame) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.3 + 0.1 * frame, Vector3d(1, 2, 3).normalized())),
          Vector3d(0.2, -0.1 * frame, 1 + 0.05 * frame)};
}

/// The joint of the closing hand, which is y up, in our coordinates.
Vector3d joint_at(int joint, int frame) {
  const Vector3d p = test::closing_joint(joint, double(frame) / frames);
  return {p.x(), -p.z(), p.y()};
}

/// As Unreal's vectors and quaternions.
struct UnrealVector {
  double X, Y, Z;
};
struct UnrealQuaternion {
  double X, Y, Z, W;
};

/// cm, y mirrored, also in the object's own frame.
UnrealVector unreal(const Vector3d& p) { return {100 * p.x(), -100 * p.y(), 100 * p.z()}; }
UnrealQuaternion unreal(const Eigen::Quaterniond& R) {
  const Eigen::Matrix3d mirror = Vector3d(1, -1, 1).asDiagonal();
  const Eigen::Quaterniond q(Eigen::Matrix3d(mirror * R.toRotationMatrix() * mirror));
  return {q.x(), q.y(), q.z(), q.w()};
}

std::string unreal_log() {
  std::ostringstream out;
  HandholdLog log(out, objects);
  for (int i = 0; i < frames; ++i) {
    log.begin_frame(time_of(i));
    std::vector<UnrealVector> positions;
    for (const JointSet::Entry& entry : joint_set("openxr").entries)
      positions.push_back(unreal(joint_at(entry.joint, i)));
    log.hand("right", positions, std::vector<double>(positions.size(), 100 * radius));
    log.object("cube", unreal(cube_at(i).p), unreal(cube_at(i).R));
    log.end_frame();
  }
  return out.str();
}

/// y and z change places, as Unity's importer of meshes mirrors their x.
std::string unity_log() {
  Eigen::Matrix3d swap;
  swap << 1, 0, 0, 0, 0, 1, 0, 1, 0;
  std::ostringstream calls;
  calls.precision(9);
  calls << objects << '\n';
  for (int i = 0; i < frames; ++i) {
    calls << "frame " << time_of(i) << '\n';
    for (const JointSet::Entry& entry : joint_set("openxr").entries) {
      calls << "joint " << entry.name << ' ' << (swap * joint_at(entry.joint, i)).transpose() << ' ' << radius << '\n';
    }
    const Eigen::Quaterniond q(
        Eigen::Matrix3d(swap * cube_at(i).R.toRotationMatrix() * Vector3d(-1, 1, 1).asDiagonal()));
    calls << "hand right\nobject cube " << (swap * cube_at(i).p).transpose() << ' ' << q.coeffs().transpose()
          << "\nend\n";
  }
  std::string text = calls.str();
  const test::TemporaryFile input("calls.txt", text), output("unity.jsonl", "");
  const std::string command = HANDHOLD_CSHARP_LOGGER " <'" + input.path() + "' >'" + output.path() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ostringstream written;
  written << std::ifstream(output.path()).rdbuf();
  return written.str();
}

void expect_the_motion(const std::string& text) {
  const test::TemporaryFile file("logger.jsonl", text);
  const ObjectLog log = read_object_log(file.path());
  constexpr double single = 1e-6;  // what the loggers' floats hold of metres
  ASSERT_EQ(log.t.size(), std::size_t(frames));
  ASSERT_TRUE(log.trace.has_value());
  EXPECT_EQ(log.warnings, std::vector<std::string>{});
  const TraceHand& hand = log.trace->hands.at(0);
  EXPECT_EQ(hand.side, Side::right);
  for (int i = 0; i < frames; ++i) {
    EXPECT_NEAR(log.t[std::size_t(i)], time_of(i), single);
    EXPECT_NEAR(log.trace->t[std::size_t(i)], time_of(i), single);
    const Pose& X = *log.objects[0].X_WO[std::size_t(i)];
    EXPECT_LT((X.p - cube_at(i).p).norm(), single);
    EXPECT_LT(X.R.angularDistance(cube_at(i).R), single);
    // The proximal phalanx of the index finger lies in the middle between its joints.
    const Vector3d middle = (joint_at(joint_of(1, 0), i) + joint_at(joint_of(1, 1), i)) / 2;
    EXPECT_LT((hand.samples[std::size_t(i)].X_WP[3].p - middle).norm(), 2e-3);
  }
}

TEST(Loggers, UnrealsWritesTheMotion) { expect_the_motion(unreal_log()); }

TEST(Loggers, UnitysWritesTheMotion) {
  if (std::string(HANDHOLD_CSHARP_LOGGER).empty()) GTEST_SKIP() << "there is no mcs (apt-get install mono-mcs)";
  expect_the_motion(unity_log());
}

}  // namespace
}  // namespace handhold
