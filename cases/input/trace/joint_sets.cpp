// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joint_sets.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/model/defect.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Entries = std::vector<JointSet::Entry>;

// XrHandJointEXT, in its order (OpenXR 1.1, XR_EXT_hand_tracking).
const Entries& openxr_entries() {
  static const Entries entries{{"palm", palm_joint},
                               {"wrist", wrist_joint},
                               {"thumb_metacarpal", 0},
                               {"thumb_proximal", 1},
                               {"thumb_distal", 2},
                               {"thumb_tip", 3},
                               {"index_metacarpal", unused_joint},
                               {"index_proximal", 4},
                               {"index_intermediate", 5},
                               {"index_distal", 6},
                               {"index_tip", 7},
                               {"middle_metacarpal", unused_joint},
                               {"middle_proximal", 8},
                               {"middle_intermediate", 9},
                               {"middle_distal", 10},
                               {"middle_tip", 11},
                               {"ring_metacarpal", unused_joint},
                               {"ring_proximal", 12},
                               {"ring_intermediate", 13},
                               {"ring_distal", 14},
                               {"ring_tip", 15},
                               {"little_metacarpal", unused_joint},
                               {"little_proximal", 16},
                               {"little_intermediate", 17},
                               {"little_distal", 18},
                               {"little_tip", 19}};
  return entries;
}

// XRHandJoint, in its order (WebXR Hand Input Module, level 1).
const Entries& webxr_entries() {
  static const Entries entries{{"wrist", wrist_joint},
                               {"thumb-metacarpal", 0},
                               {"thumb-phalanx-proximal", 1},
                               {"thumb-phalanx-distal", 2},
                               {"thumb-tip", DEFECT(webxr_tips_swapped, 3, 7)},
                               {"index-finger-metacarpal", unused_joint},
                               {"index-finger-phalanx-proximal", 4},
                               {"index-finger-phalanx-intermediate", 5},
                               {"index-finger-phalanx-distal", 6},
                               {"index-finger-tip", DEFECT(webxr_tips_swapped, 7, 3)},
                               {"middle-finger-metacarpal", unused_joint},
                               {"middle-finger-phalanx-proximal", 8},
                               {"middle-finger-phalanx-intermediate", 9},
                               {"middle-finger-phalanx-distal", 10},
                               {"middle-finger-tip", 11},
                               {"ring-finger-metacarpal", unused_joint},
                               {"ring-finger-phalanx-proximal", 12},
                               {"ring-finger-phalanx-intermediate", 13},
                               {"ring-finger-phalanx-distal", 14},
                               {"ring-finger-tip", 15},
                               {"pinky-finger-metacarpal", unused_joint},
                               {"pinky-finger-phalanx-proximal", 16},
                               {"pinky-finger-phalanx-intermediate", 17},
                               {"pinky-finger-phalanx-distal", 18},
                               {"pinky-finger-tip", 19}};
  return entries;
}

// The order of most 21-joint files (wrist, thumb to little, tip last); MANO's own model orders its 16 frames otherwise.
const Entries& mano_entries() {
  static const Entries entries{{"wrist", wrist_joint}, {"thumb_cmc", 0},   {"thumb_mcp", 1},   {"thumb_ip", 2},
                               {"thumb_tip", 3},       {"index_mcp", 4},   {"index_pip", 5},   {"index_dip", 6},
                               {"index_tip", 7},       {"middle_mcp", 8},  {"middle_pip", 9},  {"middle_dip", 10},
                               {"middle_tip", 11},     {"ring_mcp", 12},   {"ring_pip", 13},   {"ring_dip", 14},
                               {"ring_tip", 15},       {"little_mcp", 16}, {"little_pip", 17}, {"little_dip", 18},
                               {"little_tip", 19}};
  return entries;
}

// LeapJS: what it calls the thumb's mcp is its carpometacarpal joint.
const Entries& leap_entries() {
  static const Entries entries{{"palm", palm_joint}, {"wrist", wrist_joint}, {"thumb_mcp", 0},  {"thumb_pip", 1},
                               {"thumb_dip", 2},     {"thumb_tip", 3},       {"index_mcp", 4},  {"index_pip", 5},
                               {"index_dip", 6},     {"index_tip", 7},       {"middle_mcp", 8}, {"middle_pip", 9},
                               {"middle_dip", 10},   {"middle_tip", 11},     {"ring_mcp", 12},  {"ring_pip", 13},
                               {"ring_dip", 14},     {"ring_tip", 15},       {"pinky_mcp", 16}, {"pinky_pip", 17},
                               {"pinky_dip", 18},    {"pinky_tip", 19}};
  return entries;
}

}  // namespace

std::optional<std::size_t> JointSet::find(std::string_view joint_name) const {
  const auto same = [joint_name](const Entry& e) { return e.name == joint_name; };
  const auto found = std::find_if(entries.begin(), entries.end(), same);
  if (found == entries.end()) return std::nullopt;
  return static_cast<std::size_t>(found - entries.begin());
}

std::string JointSet::names() const {
  std::string all;
  for (const Entry& e : entries) all += (all.empty() ? "" : ", ") + std::string(e.name);
  return all;
}

const JointSet& joint_set(std::string_view name) {
  static const std::array<JointSet, 4> sets{JointSet{"leap", leap_entries(), TipPlace::bone, false},
                                            JointSet{"openxr", openxr_entries(), TipPlace::ball, true},
                                            JointSet{"webxr", webxr_entries(), TipPlace::ball, true},
                                            JointSet{"mano", mano_entries(), TipPlace::skin, false}};
  for (const JointSet& set : sets) {
    if (set.name == name) return set;
  }
  throw InputError(fmt::format("joint set \"{}\": there is no such set (use leap, openxr, webxr or mano)", name));
}

}  // namespace handhold
