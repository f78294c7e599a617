// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "cases/hand/hand_skeleton.hpp"
#include "cases/input/trace/joint_sets.hpp"

namespace handhold::test {

/// Joints of the mean adult hand that closes, y up and -z forward, by our numbers of joints [m]. x is mirrored for a
/// left hand.
inline Eigen::Vector3d closing_joint(int joint, double curl, double side = 1) {
  const HandModel model = anatomical_hand();
  if (joint == wrist_joint) return {side * 0.1, 1.2, -0.3};
  const Eigen::Vector3d center(side * 0.1, 1.2, -0.3 - model.palm_box.half_extents.z());
  if (joint == palm_joint || joint == unused_joint) return center;
  std::array<FingerPose, 5> fingers;
  for (int finger = 0; finger < 5; ++finger) fingers[std::size_t(finger)] = curled(finger, curl);
  const std::array<Pose, phalanx_count> X = forward_kinematics(model, Side::right, Pose{}, fingers);
  const auto i = std::size_t(3 * (joint / 4) + std::min(joint % 4, 2));
  const double end = joint % 4 == 3 ? 1 : -1;
  const Eigen::Vector3d p = X[i] * Eigen::Vector3d(0, 0, end * model.capsules[i].half_length);
  // The palm's x points to the thumb, y to its back, z to the fingers.
  return center + Eigen::Vector3d(-side * p.x(), p.y(), -p.z());
}

inline nlohmann::json position_of(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

/// A closing right hand of `frames` frames at 60 Hz as joints_reader.hpp documents it.
inline nlohmann::json closing_recording(const std::string& format = "openxr", int frames = 12, bool named = false) {
  nlohmann::json list = nlohmann::json::array();
  for (int i = 0; i < frames; ++i) {
    nlohmann::json joints = nlohmann::json::array();
    for (const JointSet::Entry& entry : joint_set(format).entries) {
      joints.push_back({{"position", position_of(closing_joint(entry.joint, double(i) / frames))}});
      if (named) joints.back()["name"] = std::string(entry.name);
    }
    list.push_back({{"t", i / 60.0}, {"hands", {{"right", {{"joints", joints}}}}}});
  }
  return {{"format", format}, {"frames", list}};
}

/// Calls `change` with every joint of the recording.
template <class Change>
nlohmann::json with_joints(nlohmann::json recording, const Change& change) {
  for (nlohmann::json& frame : recording["frames"]) {
    for (nlohmann::json& joint : frame["hands"]["right"]["joints"]) change(joint);
  }
  return recording;
}

}  // namespace handhold::test
