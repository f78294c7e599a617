// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/built_grasps.hpp"

#include <string>

#include "cases/hand/keyframed_hand.hpp"

namespace handhold {
namespace {

constexpr double rate = 90;                   // [Hz]
constexpr double margin = 0.1, duration = 3;  // [s]: beyond both ends, see sample_trace
constexpr double lift = 0.1;                  // [m]
constexpr double forearm_turn = 0.785;        // [rad]

struct Curl {
  double fingers{}, outer{}, thumb{};  // 0 straight, 1 fist; outer: of ring and little finger
};

/// Fingers along x, the palm faces y, the thumb side is up.
Pose wrist(double height, double turned) {
  const Eigen::Matrix3d sideways = (Eigen::Matrix3d() << 0, 0, 1, 0, -1, 0, 1, 0, 0).finished();
  const Eigen::AngleAxisd about_forearm(turned, Eigen::Vector3d::UnitX());
  return {Eigen::Quaterniond(about_forearm * sideways).normalized(), {0, 0, 0.2 + height}};
}

HandKeyframe keyframe(double t, const Pose& X_WH, const Curl& curl) {
  HandKeyframe frame = HandKeyframe::of_curl(t, X_WH, curl.fingers, curl.thumb);
  for (const int finger : {3, 4}) frame.fingers[std::size_t(finger)] = curled(finger, curl.outer);
  return frame;
}

Trace built(const std::string& name, const Curl& open, const Curl& closed, double height, double turned) {
  const Pose rest = wrist(0, 0), moved = wrist(height, turned);
  const std::vector<HandKeyframe> way = {keyframe(0.3, rest, open),    keyframe(0.8, rest, closed),
                                         keyframe(1.1, rest, closed),  keyframe(1.7, moved, closed),
                                         keyframe(2.3, moved, closed), keyframe(2.7, moved, open)};
  const HandModel model = anatomical_hand();
  return sample_trace(name, Side::right, model, keyframed_hand(model, Side::right, way), -margin, duration + margin,
                      rate);
}

}  // namespace

std::vector<Trace> built_grasps() {
  const Curl open{0.1, 0.1, 0}, power{0.62, 0.62, 0.75}, tips{0.5, 0.15, 0.7};
  return {built("built power lift", open, power, lift, 0), built("built power turn", open, power, 0, forearm_turn),
          built("built tips lift", open, tips, lift, 0), built("built tips turn", open, tips, 0, forearm_turn)};
}

}  // namespace handhold
