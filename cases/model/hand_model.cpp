// SPDX-License-Identifier: Apache-2.0
#include "cases/model/hand_model.hpp"

#include <algorithm>
#include <string>

#include "cases/model/input_error.hpp"
#include "cases/model/text.hpp"

namespace handhold {
namespace {

constexpr std::array<std::string_view, phalanx_count> names{
    "thumb_metacarpal",   "thumb_proximal",      "thumb_distal",      "index_proximal",
    "index_intermediate", "index_distal",        "middle_proximal",   "middle_intermediate",
    "middle_distal",      "ring_proximal",       "ring_intermediate", "ring_distal",
    "little_proximal",    "little_intermediate", "little_distal",     "palm"};

}  // namespace

std::string_view to_string(Side side) { return side == Side::left ? "left" : "right"; }

std::string_view phalanx_name(int phalanx) { return names.at(static_cast<std::size_t>(phalanx)); }

int phalanx_from_name(std::string_view name) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  std::string known;
  for (const std::string_view n : names) known += (known.empty() ? "" : ", ") + std::string(n);
  throw InputError("phalanx \"" + std::string(name) + "\": there is no such phalanx (use one of " + known + ")");
}

PhalanxShape HandModel::shape(int phalanx) const {
  if (phalanx == palm) return palm_box;
  return capsules.at(static_cast<std::size_t>(phalanx));
}

void validate(const HandModel& model, const std::string& who) {
  constexpr double most = 1;  // [m], of any bone
  for (std::size_t i = 0; i < model.capsules.size(); ++i) {
    const auto& [half_length, radius] = model.capsules[i];
    if (!(half_length >= 0 && half_length <= most && radius > 0 && radius <= most))
      throw InputError(sentence(who, ": ", names[i], " of half length ", half_length, " m and radius ", radius,
                                " m: need 0 to 1 m, and a radius above 0 (check the unit)"));
  }
  const Eigen::Vector3d& half = model.palm_box.half_extents;
  if (!(half.allFinite() && half.minCoeff() > 0 && half.maxCoeff() <= most))
    throw InputError(sentence(who, ": palm of half extents ", half,
                              " m: must be above 0 and at most 1 m each (check the", " unit)"));
}

Capsule capsule_of_bone(double length, double radius) { return {length / 2, radius}; }

Capsule capsule_of_fingertip(double skin_length, double radius) {
  return {std::max(0.0, skin_length - radius) / 2, radius};
}

Anatomy mean_anatomy() {
  // The thumb has no middle phalanx: its metacarpal comes first.
  return {{0.04622, 0.03157, 0.02167, 0.03978, 0.02238, 0.01582, 0.04463, 0.02633, 0.01740, 0.04137, 0.02565, 0.01730,
           0.03274, 0.01811, 0.01596},
          {0.0057, 0.0038, 0.0040, 0.0040, 0.0037},
          {0.0094, 0.0090, 0.0088, 0.0084, 0.0074},
          {0.040, 0.014, 0.0448}};
}

HandModel anatomical_hand(double scale) {
  const Anatomy mean = mean_anatomy();
  HandModel hand;
  for (std::size_t i = 0; i < hand.capsules.size(); ++i) {
    const std::size_t finger = i / 3;
    const double radius = scale * mean.radius[finger];
    const double length = scale * mean.bones[i];
    hand.capsules[i] = i % 3 < 2 ? capsule_of_bone(length, radius)
                                 : capsule_of_fingertip(length + scale * mean.soft_tip[finger], radius);
  }
  hand.palm_box.half_extents = scale * mean.palm_half_extents;
  return hand;
}

}  // namespace handhold
