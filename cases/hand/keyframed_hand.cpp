// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/keyframed_hand.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/hand/minimum_jerk.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

double blend(double a, double b, double s) { return a + s * (b - a); }

FingerPose blend(const FingerPose& a, const FingerPose& b, double s) {
  FingerPose pose;
  for (std::size_t i = 0; i < pose.flexion.size(); ++i) pose.flexion[i] = blend(a.flexion[i], b.flexion[i], s);
  pose.spread = blend(a.spread, b.spread, s);
  return pose;
}

HandKeyframe blend(const HandKeyframe& a, const HandKeyframe& b, double t) {
  const double s = minimum_jerk((t - a.t) / (b.t - a.t));
  HandKeyframe frame;
  frame.t = t;
  frame.X_WH = {a.X_WH.R.slerp(s, b.X_WH.R).normalized(), a.X_WH.p + s * (b.X_WH.p - a.X_WH.p)};
  for (std::size_t i = 0; i < frame.fingers.size(); ++i) frame.fingers[i] = blend(a.fingers[i], b.fingers[i], s);
  return frame;
}

bool is_finite(const HandKeyframe& frame) {
  double sum = frame.t + frame.X_WH.p.sum() + frame.X_WH.R.coeffs().sum();
  for (const FingerPose& f : frame.fingers) sum += f.flexion[0] + f.flexion[1] + f.flexion[2] + f.spread;
  return std::isfinite(sum) && std::abs(frame.X_WH.R.norm() - 1) < 1e-6;
}

void check(const std::vector<HandKeyframe>& keyframes) {
  if (keyframes.empty()) throw InputError("keyframes: there are none (give at least one)");
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (!is_finite(keyframes[i])) {
      throw InputError(
          fmt::format("keyframe {}: a number is not finite or the quaternion not of unit length (normalise)", i));
    }
    if (i > 0 && keyframes[i].t <= keyframes[i - 1].t) {
      throw InputError(fmt::format("keyframe {}: time {} s must come after {} s (sort them)", i, keyframes[i].t,
                                   keyframes[i - 1].t));
    }
  }
}

}  // namespace

HandKeyframe HandKeyframe::of_curl(double t, const Pose& X_WH, double curl, double thumb_curl) {
  HandKeyframe frame{t, X_WH, {}};
  for (int finger = 0; finger < 5; ++finger) {
    frame.fingers[static_cast<std::size_t>(finger)] = curled(finger, finger == 0 ? thumb_curl : curl);
  }
  return frame;
}

PoseFunction keyframed_hand(const HandModel& model, Side side, std::vector<HandKeyframe> keyframes) {
  check(keyframes);
  const Pose X_HPalm{Eigen::Quaterniond::Identity(), {0, 0, model.palm_box.half_extents.z()}};
  return [=, keyframes = std::move(keyframes)](double t) {
    const auto later = [](double value, const HandKeyframe& frame) { return value < frame.t; };
    const auto next = std::upper_bound(keyframes.begin(), keyframes.end(), t, later);
    const HandKeyframe frame = next == keyframes.begin() ? keyframes.front()
                               : next == keyframes.end() ? keyframes.back()
                                                         : blend(*(next - 1), *next, t);
    return forward_kinematics(model, side, frame.X_WH * X_HPalm, frame.fingers);
  };
}

}  // namespace handhold
