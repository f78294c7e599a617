// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joint_frames.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "cases/hand/hand_skeleton.hpp"

namespace handhold {
namespace {

/// Of a finger's bone in arrays of phalanges (hand_model.hpp).
std::size_t phalanx_index(int finger, int bone) { return 3 * std::size_t(finger) + std::size_t(bone); }

constexpr double least_length = 1e-6;  // shorter bones have no direction [m]

double median(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }), values.end());
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The quantity of every tracked frame, its median.
template <class Quantity>
double median_of(const std::vector<std::optional<HandJoints>>& frames, const Quantity& quantity) {
  std::vector<double> values;
  for (const std::optional<HandJoints>& frame : frames) {
    if (frame) values.push_back(quantity(*frame));
  }
  return median(std::move(values));
}

Eigen::Quaterniond from_axes(const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
  Eigen::Matrix3d R;
  R << y.cross(z), y, z;
  return Eigen::Quaterniond(R).normalized();
}

/// y: what is left of `dorsal` across z; nothing if (almost) nothing is.
std::optional<Eigen::Quaterniond> axes(const Eigen::Vector3d& z, const Eigen::Vector3d& dorsal) {
  const Eigen::Vector3d y = dorsal - dorsal.dot(z) * z;
  if (!(y.norm() > 1e-3 * dorsal.norm())) return std::nullopt;
  return from_axes(y.normalized(), z);
}

Eigen::Quaterniond bone_axes(const HandJoints& joints, int finger, int bone, const Eigen::Vector3d& z,
                             const Eigen::Quaterniond& R_WPalm, Side side) {
  const std::optional<Eigen::Quaterniond>& R_WJ = joints.joints[static_cast<std::size_t>(joint_of(finger, bone))].R_WJ;
  if (R_WJ) {
    const Eigen::Vector3d dorsal = *R_WJ * Eigen::Vector3d::UnitY();
    if (const std::optional<Eigen::Quaterniond> R = axes(z, dorsal)) return *R;
  }
  const Eigen::Vector3d hinge = R_WPalm * hinge_axis(finger, side);
  const Eigen::Vector3d dorsal = z.cross(hinge);
  if (const std::optional<Eigen::Quaterniond> R = axes(z, dorsal.norm() > 1e-3 ? dorsal : z.unitOrthogonal()))
    return *R;
  return R_WPalm;
}

/// Where a capsule begins and ends on the line through its joints: the last one ends short of the skin by its radius.
Pose bone_pose(const HandJoints& joints, int finger, int bone, const Capsule& capsule,
               const Eigen::Quaterniond& R_WPalm, Side side, Eigen::Vector3d& z) {
  const Eigen::Vector3d& from = joints.p(joint_of(finger, bone));
  const Eigen::Vector3d along = joints.p(joint_of(finger, bone + 1)) - from;
  if (along.norm() > least_length) z = along.normalized();
  // Tracked bones may breathe a little: all but the fingertip stay centred between their joints.
  const double middle = bone < 2 ? along.norm() / 2 : capsule.half_length;
  return {bone_axes(joints, finger, bone, z, R_WPalm, side), from + middle * z};
}

double skin_length(double length, double radius, TipPlace tip, double soft) {
  if (tip == TipPlace::bone) return length + soft;
  return tip == TipPlace::ball ? length + radius : length;
}

HandModel measure(const std::vector<std::optional<HandJoints>>& frames, TipPlace tip) {
  std::array<double, 15> lengths{};
  for (std::size_t i = 0; i < 15; ++i) {
    lengths[i] = median_of(frames, [i](const HandJoints& joints) { return bone_lengths(joints)[i]; });
  }
  const Anatomy& mean = mean_anatomy();
  const auto fingers = [](const std::array<double, 15>& all) {  // not the thumb: formats differ in where it begins
    return std::accumulate(all.begin() + 3, all.end(), 0.0);
  };
  const double scale = fingers(lengths) > 0 ? fingers(lengths) / fingers(mean.bones) : 1;

  HandModel model = anatomical_hand(scale);
  for (int finger = 0; finger < 5; ++finger) {
    for (int bone = 0; bone < 3; ++bone) {
      const auto i = phalanx_index(finger, bone);
      const auto from = static_cast<std::size_t>(joint_of(finger, bone));
      const double given = median_of(
          frames, [from](const HandJoints& j) { return (j.joints[from].radius + j.joints[from + 1].radius) / 2; });
      const double radius = given > 0 ? given : model.capsules[i].radius;
      const double soft = scale * mean.soft_tip[static_cast<std::size_t>(finger)];
      const double ball = median_of(frames, [from](const HandJoints& j) { return j.joints[from + 1].radius; });
      model.capsules[i] =
          bone < 2 ? capsule_of_bone(lengths[i], radius)
                   : capsule_of_fingertip(skin_length(lengths[i], ball > 0 ? ball : radius, tip, soft), radius);
    }
  }
  return model;
}

/// The palm's box in the axes of `palm_axes`: from the wrist (or as long as an anatomical palm) to the knuckles.
struct PalmPlace {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  Eigen::Vector3d half{Eigen::Vector3d::Zero()};
};

PalmPlace place_palm(Side side, const std::vector<std::optional<HandJoints>>& frames, const HandModel& model) {
  std::array<double, 4> x{}, y{}, z{};
  const auto coordinate = [&](int joint, int axis) {
    return median_of(frames, [&](const HandJoints& j) { return (palm_axes(side, j)->inverse() * j.p(joint))[axis]; });
  };
  for (int finger = 1; finger < 5; ++finger) {
    const auto i = static_cast<std::size_t>(finger - 1);
    x[i] = coordinate(joint_of(finger, 0), 0);
    y[i] = coordinate(joint_of(finger, 0), 1);
    z[i] = coordinate(joint_of(finger, 0), 2);
  }
  const double far = std::accumulate(z.begin(), z.end(), 0.0) / 4;
  const bool wrist =
      median_of(frames, [](const HandJoints& j) { return j.p(wrist_joint).allFinite() ? 1.0 : 0.0; }) > 0;
  const double near = wrist ? coordinate(wrist_joint, 2) : far - 2 * model.palm_box.half_extents.z();
  const double height =
      (std::accumulate(y.begin(), y.end(), 0.0) / 4 + (wrist ? coordinate(wrist_joint, 1) : y[1])) / 2;
  const double margin = (model.capsules[3].radius + model.capsules[12].radius) / 2;
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  return {{(*least + *most) / 2, height, (near + far) / 2},
          {(*most - *least) / 2 + margin, model.palm_box.half_extents.y(), std::abs(far - near) / 2}};
}

HandSample sample_of(Side side, const HandJoints& joints, const HandModel& model, const PalmPlace& palm_place) {
  const Pose X_WPalm = *palm_axes(side, joints);
  HandSample sample;
  sample.confidence = joints.confidence;
  sample.tracked = true;
  sample.X_WP[palm] = {X_WPalm.R, X_WPalm * palm_place.center};
  for (int finger = 0; finger < 5; ++finger) {
    Eigen::Vector3d z = X_WPalm.R * Eigen::Vector3d::UnitZ();
    for (int bone = 0; bone < 3; ++bone) {
      const auto i = phalanx_index(finger, bone);
      sample.X_WP[i] = bone_pose(joints, finger, bone, model.capsules[i], X_WPalm.R, side, z);
    }
  }
  return sample;
}

}  // namespace

bool HandJoints::complete() const {
  for (int joint = 0; joint < wrist_joint; ++joint) {
    if (!p(joint).allFinite()) return false;
  }
  const Joint& center = joints[palm_joint];
  return p(wrist_joint).allFinite() || (center.p_W.allFinite() && center.R_WJ);
}

std::optional<Pose> palm_axes(Side side, const HandJoints& joints) {
  const HandJoints::Joint& center = joints.joints[palm_joint];
  if (center.R_WJ && center.p_W.allFinite()) return Pose{*center.R_WJ, center.p_W};
  const Eigen::Vector3d& wrist = joints.p(wrist_joint);
  const Eigen::Vector3d index = joints.p(joint_of(1, 0)) - wrist;
  const Eigen::Vector3d little = joints.p(joint_of(4, 0)) - wrist;
  const Eigen::Vector3d z = (index + little) / 2;
  const Eigen::Vector3d dorsal = side == Side::right ? little.cross(index) : index.cross(little);
  if (!(z.norm() > least_length) || !(dorsal.norm() > 1e-3 * index.norm() * little.norm())) return std::nullopt;
  const std::optional<Eigen::Quaterniond> R = axes(z.normalized(), dorsal);
  if (!R) return std::nullopt;
  return Pose{*R, center.p_W.allFinite() ? center.p_W : wrist};
}

Side side_of(const HandJoints& joints) {
  const Eigen::Quaterniond& R_WPalm = *joints.joints[palm_joint].R_WJ;
  const Eigen::Vector3d towards_index = joints.p(joint_of(1, 0)) - joints.p(joint_of(4, 0));
  return (R_WPalm.conjugate() * towards_index).x() > 0 ? Side::right : Side::left;
}

std::array<double, 15> bone_lengths(const HandJoints& joints) {
  std::array<double, 15> lengths{};
  for (int finger = 0; finger < 5; ++finger) {
    for (int bone = 0; bone < 3; ++bone) {
      const int from = joint_of(finger, bone);
      lengths[phalanx_index(finger, bone)] = (joints.p(from + 1) - joints.p(from)).norm();
    }
  }
  return lengths;
}

TraceHand hand_from_joints(Side side, const std::vector<std::optional<HandJoints>>& frames, TipPlace tip,
                           std::vector<std::string>& warnings) {
  std::vector<std::optional<HandJoints>> usable = frames;
  std::size_t dropped = 0;
  for (std::optional<HandJoints>& frame : usable) {
    if (!frame || (frame->complete() && palm_axes(side, *frame))) continue;
    frame.reset();
    ++dropped;
  }
  if (dropped > 0) {
    warnings.push_back(fmt::format("{} hand: {} of {} frames have missing or degenerate joints and count as lost",
                                   to_string(side), dropped, frames.size()));
  }
  TraceHand hand{side, measure(usable, tip), std::vector<HandSample>(frames.size())};
  const bool any = std::any_of(usable.begin(), usable.end(), [](const auto& frame) { return frame.has_value(); });
  if (!any) return hand;
  const PalmPlace palm_place = place_palm(side, usable, hand.model);
  hand.model.palm_box.half_extents = palm_place.half;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (usable[i]) hand.samples[i] = sample_of(side, *usable[i], hand.model, palm_place);
  }
  return hand;
}

}  // namespace handhold
