// SPDX-License-Identifier: GPL-3.0-or-later
// A hand of a real recording, word for word: a left hand of a headset's emulator, about to pinch. Expected places are
// read off the recording by eye, not through our table of joints.
#include <string>

#include <gtest/gtest.h>

#include "cases/input/trace/joints_reader.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

const std::string joints = R"([
      {"name": "wrist", "position": [0.050864, 1.202146, -0.18298], "orientation": [0.2574, -0.13356, -0.03623, 0.95634], "radius": 0.02146},
      {"name": "thumb-metacarpal", "position": [0.089356, 1.200694, -0.212634], "orientation": [0.32279, -0.31619, -0.66159, 0.59843], "radius": 0.01938},
      {"name": "thumb-phalanx-proximal", "position": [0.115547, 1.199652, -0.23187], "orientation": [0.35255, -0.30992, -0.57898, 0.66666], "radius": 0.01228},
      {"name": "thumb-phalanx-distal", "position": [0.143307, 1.203409, -0.250771], "orientation": [0.29224, -0.27052, -0.67091, 0.62554], "radius": 0.00977},
      {"name": "thumb-tip", "position": [0.162003, 1.20407, -0.266778], "orientation": [0.29224, -0.27052, -0.67091, 0.62554], "radius": 0.00877},
      {"name": "index-finger-metacarpal", "position": [0.079902, 1.208771, -0.213396], "orientation": [0.2574, -0.13356, -0.03623, 0.95634], "radius": 0.02123},
      {"name": "index-finger-phalanx-proximal", "position": [0.099823, 1.2389, -0.260927], "orientation": [0.24091, -0.20666, -0.08487, 0.94449], "radius": 0.0103},
      {"name": "index-finger-phalanx-intermediate", "position": [0.116179, 1.254829, -0.291212], "orientation": [0.12456, -0.19775, -0.08243, 0.96881], "radius": 0.00854},
      {"name": "index-finger-phalanx-distal", "position": [0.125991, 1.259903, -0.312861], "orientation": [0.08691, -0.1719, -0.07048, 0.97874], "radius": 0.00764},
      {"name": "index-finger-tip", "position": [0.133625, 1.264214, -0.333461], "orientation": [0.08691, -0.1719, -0.07048, 0.97874], "radius": 0.00664},
      {"name": "middle-finger-metacarpal", "position": [0.063722, 1.21158, -0.214499], "orientation": [0.2574, -0.13356, -0.03623, 0.95634], "radius": 0.02123},
      {"name": "middle-finger-phalanx-proximal", "position": [0.07874, 1.245873, -0.263408], "orientation": [0.26829, -0.07731, -0.01374, 0.96013], "radius": 0.01117},
      {"name": "middle-finger-phalanx-intermediate", "position": [0.085429, 1.267897, -0.299642], "orientation": [0.11545, -0.07503, -0.01324, 0.99039], "radius": 0.00803},
      {"name": "middle-finger-phalanx-distal", "position": [0.089608, 1.274142, -0.326147], "orientation": [0.09856, -0.07999, 0.03027, 0.99145], "radius": 0.00763},
      {"name": "middle-finger-tip", "position": [0.093028, 1.280242, -0.350142], "orientation": [0.09856, -0.07999, 0.03027, 0.99145], "radius": 0.00663},
      {"name": "ring-finger-metacarpal", "position": [0.045975, 1.215798, -0.218477], "orientation": [0.2574, -0.13356, -0.03623, 0.95634], "radius": 0.01909},
      {"name": "ring-finger-phalanx-proximal", "position": [0.058376, 1.241719, -0.26417], "orientation": [0.30407, -0.03525, 0.04142, 0.9511], "radius": 0.00992},
      {"name": "ring-finger-phalanx-intermediate", "position": [0.060009, 1.264388, -0.295858], "orientation": [0.16787, -0.05339, 0.07047, 0.98184], "radius": 0.00761},
      {"name": "ring-finger-phalanx-distal", "position": [0.062166, 1.273347, -0.320783], "orientation": [0.10549, -0.08812, 0.06941, 0.98807], "radius": 0.00723},
      {"name": "ring-finger-tip", "position": [0.065544, 1.280242, -0.343923], "orientation": [0.10549, -0.08812, 0.06941, 0.98807], "radius": 0.00623},
      {"name": "pinky-finger-metacarpal", "position": [0.038081, 1.21362, -0.221498], "orientation": [0.2091, -0.04771, 0.19661, 0.95674], "radius": 0.01809},
      {"name": "pinky-finger-phalanx-proximal", "position": [0.038498, 1.232741, -0.262949], "orientation": [0.29749, 0.04376, 0.1112, 0.94721], "radius": 0.00848},
      {"name": "pinky-finger-phalanx-intermediate", "position": [0.033918, 1.249756, -0.288114], "orientation": [0.13921, 0.0434, 0.17676, 0.97339], "radius": 0.00676},
      {"name": "pinky-finger-phalanx-distal", "position": [0.031202, 1.254948, -0.307562], "orientation": [0.12071, -0.00927, 0.17004, 0.97797], "radius": 0.00643},
      {"name": "pinky-finger-tip", "position": [0.030525, 1.261385, -0.328544], "orientation": [0.12071, -0.00927, 0.17004, 0.97797], "radius": 0.00543}])";

const std::string hands = R"("hands": {"left": {"joints": )" + joints + "}}}";
const std::string recording =
    R"({"format": "webxr", "frames": [{"t": 0, )" + hands + R"(, {"t": 0.01, )" + hands + "]}";

/// WebXR's y up and -z forward become z up and y forward.
Vector3d in_world(double x, double y, double z) { return {x, -z, y}; }

/// The last capsule of a finger points from its last joint to the tip, and lies between them.
void expect_between(const Trace& trace, int phalanx, const Vector3d& from, const Vector3d& tip) {
  const Pose& X = trace.hands.at(0).samples.at(0).X_WP[std::size_t(phalanx)];
  EXPECT_GT((X.R * Vector3d::UnitZ()).dot((tip - from).normalized()), 0.999) << phalanx;
  EXPECT_LT((X.p - from).norm(), (tip - from).norm()) << phalanx;
  EXPECT_LT((X.p - tip).norm(), (tip - from).norm()) << phalanx;
}

TEST(RealRecording, HasThumbAndIndexWhereTheHeadsetSawThem) {
  const Trace trace = read_joints(recording, "real.json");
  ASSERT_EQ(trace.hands.size(), 1u);
  expect_between(trace, 2, in_world(0.143307, 1.203409, -0.250771), in_world(0.162003, 1.20407, -0.266778));
  expect_between(trace, 5, in_world(0.125991, 1.259903, -0.312861), in_world(0.133625, 1.264214, -0.333461));
}

}  // namespace
}  // namespace handhold
