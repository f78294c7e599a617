// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/input/json_input.hpp"
#include "cases/input/trace/joint_sets.hpp"
#include "cases/input/trace/json_readers.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;
using Names = std::map<std::string, std::string>;

/// Theirs -> ours, for members whose unit is not in doubt.
const Names& joint_names() {
  static const Names names{{"pos", "position"},      {"p", "position"},
                           {"location", "position"}, {"translation", "position"},
                           {"rot", "orientation"},   {"rotation", "orientation"},
                           {"q", "orientation"},     {"quaternion", "orientation"},
                           {"r", "radius"},          {"joint", "name"}};
  return names;
}
const Names& hand_names() {
  static const Names names{{"landmarks", "joints"}, {"keypoints", "joints"}, {"score", "confidence"}};
  return names;
}
constexpr std::array<const char*, 6> side_names{"handedness", "side", "hand", "chirality", "type", "label"};

void rename(json& object, const Names& names) {
  for (const auto& [theirs, ours] : names) {
    if (!object.contains(theirs) || object.contains(ours)) continue;
    json value = std::move(object[theirs]);
    object.erase(theirs);
    object[ours] = std::move(value);
  }
}

/// {"x": 1, "y": 2, "z": 3} as [1, 2, 3]; w, where there is one, last.
json list_of_members(const json& value) {
  if (!value.is_object() || !value.contains("x")) return value;
  json list = json::array();
  for (const char* name : {"x", "y", "z", "w"}) {
    if (value.contains(name)) list.push_back(value[name]);
  }
  return list;
}

bool all_numbers(const json& list) {
  return list.is_array() && !list.empty() &&
         std::all_of(list.begin(), list.end(), [](const json& v) { return v.is_number() || v.is_null(); });
}

json part(const json& list, std::size_t begin, std::size_t count) {
  const auto from = list.begin() + std::ptrdiff_t(begin);
  return json(std::vector<json>(from, from + std::ptrdiff_t(count)));
}

json numbers_in(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }
json numbers_in(const Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

/// A homogeneous matrix in a row: by columns, as WebXR and OpenGL write it, or by rows, told by where the zeros are.
json of_matrix(const json& list) {
  Eigen::Matrix4d X;
  X = Eigen::Map<const Eigen::Matrix4d>(numbers_of<16>(list).data());
  if (X.row(3).head<3>().isZero(0) == false && X.col(3).head<3>().isZero(0)) X.transposeInPlace();
  if (!X.allFinite()) return nullptr;
  const Eigen::Matrix3d R = X.topLeftCorner<3, 3>();
  return {{"position", numbers_in(Vector3d(X.topRightCorner<3, 1>()))}, {"orientation", numbers_in(Quaterniond(R))}};
}

/// Position, and a quaternion and a radius where there are more numbers than three.
json of_numbers(const json& list) {
  if (list.size() == 16) return of_matrix(list);
  json joint{{"position", part(list, 0, 3)}};
  if (list.size() >= 7) joint["orientation"] = part(list, 3, 4);
  if (list.size() == 8) joint["radius"] = list[7];
  return joint;
}

constexpr std::array<std::size_t, 4> number_counts{3, 7, 8, 16};  // of a joint in a row of numbers

json canonical_joint(json joint) {
  if (all_numbers(joint) && std::count(number_counts.begin(), number_counts.end(), joint.size()) > 0)
    return of_numbers(joint);
  if (!joint.is_object()) return joint;
  rename(joint, joint_names());
  if (joint.contains("x") && !joint.contains("position")) {
    const json position = list_of_members(joint);
    for (const char* name : {"x", "y", "z"}) joint.erase(name);
    joint["position"] = position;
  }
  for (const char* name : {"position", "orientation"}) {
    if (joint.contains(name)) joint[name] = list_of_members(joint[name]);
  }
  return joint;
}

/// All joints in one row of numbers: so many each as the length allows.
json in_joints(const json& numbers) {
  for (const JointSet& set : joint_sets()) {
    for (const std::size_t count : number_counts) {
      if (numbers.size() != count * set.entries.size()) continue;
      json joints = json::array();
      for (std::size_t i = 0; i < set.entries.size(); ++i) joints.push_back(part(numbers, i * count, count));
      return joints;
    }
  }
  return numbers;
}

void make_canonical(json& hand) {
  if (hand.is_array()) hand = {{"joints", std::move(hand)}};
  if (!hand.is_object()) return;
  rename(hand, hand_names());
  const auto joints = hand.find("joints");
  if (joints == hand.end()) return;
  if (joints->is_object()) {
    json list = json::array();
    for (auto& [name, joint] : joints->items()) {
      json named = canonical_joint(std::move(joint));
      if (named.is_object()) named["name"] = name;
      list.push_back(std::move(named));
    }
    *joints = std::move(list);
    return;
  }
  if (all_numbers(*joints) && joints->size() > 3) *joints = in_joints(*joints);
  if (!joints->is_array()) return;
  for (json& joint : *joints) joint = canonical_joint(std::move(joint));
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Hands in a list say themselves which they are.
json by_side(json& list, const std::string& where) {
  json hands = json::object();
  for (json& hand : list) {
    if (hand.is_null()) continue;
    std::string side;
    for (const char* name : side_names) {
      if (!side.empty() || !hand.is_object() || !hand.contains(name) || !hand[name].is_string()) continue;
      side = lower(hand[name]);
      hand.erase(name);
    }
    if (side.empty())
      throw InputError(fmt::format("{}: a hand does not say which it is (add \"handedness\": \"right\")", where));
    if (hands.contains(side)) throw InputError(fmt::format("{}: there are two {} hands (keep one)", where, side));
    hands[side] = std::move(hand);
  }
  return hands;
}

void make_frame_canonical(json& frame, const std::string& where) {
  if (!frame.is_object()) return;
  for (const char* side : {"left", "right"}) {
    if (!frame.contains(side)) continue;
    json hand = std::move(frame[side]);
    frame.erase(side);
    frame["hands"][side] = std::move(hand);
  }
  const auto hands = frame.find("hands");
  if (hands == frame.end()) return;
  if (hands->is_array()) *hands = by_side(*hands, where);
  if (!hands->is_object()) return;
  json sides = json::object();
  for (auto& [side, hand] : hands->items()) {
    make_canonical(hand);
    sides[lower(side)] = std::move(hand);
  }
  *hands = std::move(sides);
}

/// The first set that has all names, or as many joints.
const JointSet* set_of(const json& joints) {
  const auto name_of = [](const json& joint) {
    return joint.is_object() && joint.contains("name") && joint["name"].is_string() ? joint["name"].get<std::string>()
                                                                                    : std::string();
  };
  const bool named = !joints.empty() && !name_of(joints[0]).empty();
  for (const JointSet& set : joint_sets()) {
    const auto knows = [&](const json& joint) { return !joint.is_object() || set.find(name_of(joint)).has_value(); };
    if (named ? std::all_of(joints.begin(), joints.end(), knows) : joints.size() == set.entries.size()) return &set;
  }
  return nullptr;
}

void find_format(json& recording, std::vector<std::string>& remarks) {
  for (const json& frame : list_of(recording, "frames")) {
    const auto hands = frame.is_object() ? frame.find("hands") : frame.end();
    if (!frame.is_object() || hands == frame.end() || !hands->is_object()) continue;
    for (const auto& [side, hand] : hands->items()) {
      const json& joints = list_of(hand, "joints");
      const JointSet* set = joints.empty() ? nullptr : set_of(joints);
      if (set == nullptr) continue;
      recording["format"] = std::string(set->name);
      if (joints[0].is_object() && joints[0].contains("name")) return;  // names leave no doubt
      remarks.push_back(
          fmt::format("\"format\" is missing: {} joints a hand, taken as those of {} (write \"format\": "
                      "\"{}\" if that is right)",
                      joints.size(), set->name, set->name));
      return;
    }
  }
}

Quaterniond rotation_of(const json& numbers, std::size_t begin) {
  const Eigen::Vector4d q = numbers_of<4>(part(numbers, begin, 4));
  return Quaterniond(q[3], q[0], q[1], q[2]).normalized();
}

/// One input of a frame of the emulator: its number, the pose of its target ray, then lists, of which the one of joints
/// is the longest: position, quaternion and radius of each in the frame of the target ray.
json emulator_hand(const json& input, const json& sequence) {
  const auto joints = std::find_if(input.begin() + 8, input.end(), [&](const json& list) {
    return all_numbers(list) && list.size() == 8 * sequence.size();
  });
  if (joints == input.end() || sequence.empty()) return nullptr;
  const Vector3d p_WT = numbers_of<3>(part(input, 1, 3));
  const Quaterniond R_WT = rotation_of(input, 4);
  json list = json::array();
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const Vector3d p_TJ = numbers_of<3>(part(*joints, 8 * i, 3));
    list.push_back({{"name", sequence[i]},
                    {"position", numbers_in(Vector3d(p_WT + R_WT * p_TJ))},
                    {"orientation", numbers_in(R_WT * rotation_of(*joints, 8 * i + 3))},
                    {"radius", (*joints)[8 * i + 7]}});
  }
  return {{"joints", list}};
}

/// Recording of the Immersive Web Emulation Runtime: time in ms, pose of the viewer, inputs.
json from_emulator(const json& recording, const std::string& path, std::vector<std::string>& remarks) {
  std::map<long, json> inputs;
  for (const json& entry : list_of(recording, "schema")) {
    if (entry.is_array() && entry.size() == 2 && entry[0].is_number() && entry[1].is_object())
      inputs[entry[0].get<long>()] = entry[1];
  }
  json frames = json::array();
  for (const json& frame : list_of(recording, "frames")) {
    if (!frame.is_array() || frame.size() < 8)
      throw InputError(
          fmt::format("{}, frame {}: is no frame of the WebXR emulator (record it again)", path, frames.size()));
    json hands = json::object();
    for (std::size_t i = 8; i < frame.size(); ++i) {
      const json& input = frame[i];
      if (!input.is_array() || input.size() < 9 || !input[0].is_number()) continue;
      const json& schema = inputs[input[0].get<long>()];
      json hand = emulator_hand(input, list_of(schema, "jointSequence"));
      if (!hand.is_null() && schema["handedness"].is_string()) hands[schema["handedness"].get<std::string>()] = hand;
    }
    frames.push_back({{"t", frame[0]}, {"hands", hands}});
  }
  remarks.emplace_back("the WebXR emulator rounds positions to 1 mm and quaternions to 0.001");
  return {{"format", "webxr"}, {"time", "ms"}, {"frames", frames}};
}

const json& member(const json& object, const char* name) {
  static const json nothing;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : nothing;
}

/// The last three bones of a digit: the metacarpals come first where they are given.
json pointable_of(const json& digit, std::size_t type, std::size_t hand) {
  static constexpr std::array<const char*, 4> bone_names{"metacarpal", "proximal", "intermediate", "distal"};
  std::vector<json> bones = list_of(digit, "bones");
  if (bones.empty()) {
    for (const char* name : bone_names) {
      if (!member(digit, name).is_null()) bones.push_back(member(digit, name));
    }
  }
  if (bones.size() < 3) return nullptr;
  const json* const last = &bones[bones.size() - 3];
  const auto end = [](const json& bone, const char* name) { return list_of_members(member(bone, name)); };
  return {{"handId", hand},
          {"type", type},
          {"width", member(last[1], "width")},
          {"mcpPosition", end(last[0], "prev_joint")},
          {"pipPosition", end(last[0], "next_joint")},
          {"dipPosition", end(last[1], "next_joint")},
          {"tipPosition", end(last[2], "next_joint")}};
}

std::string leap_side(const json& type) {
  if (type.is_number()) return type == 0 ? "left" : "right";
  const std::string text = type.is_string() ? lower(type) : "";
  return text.find("left") != std::string::npos ? "left" : text.find("right") != std::string::npos ? "right" : "";
}

void add_leap_c_hand(const json& hand, std::size_t id, json& frame) {
  static constexpr std::array<const char*, 5> fingers{"thumb", "index", "middle", "ring", "pinky"};
  const json& center = member(hand, "palm");
  json out{{"id", id},
           {"type", leap_side(member(hand, "type"))},
           {"palmPosition", list_of_members(member(center, "position"))},
           {"palmNormal", list_of_members(member(center, "normal"))},
           {"direction", list_of_members(member(center, "direction"))}};
  if (member(hand, "confidence").is_number()) out["confidence"] = hand["confidence"];
  const json wrist = list_of_members(member(member(hand, "arm"), "next_joint"));
  if (wrist.is_array()) out["wrist"] = wrist;
  frame["hands"].push_back(std::move(out));
  const json& digits = list_of(hand, "digits");
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    json pointable = pointable_of(i < digits.size() ? digits[i] : member(hand, fingers[i]), i, id);
    if (!pointable.is_null()) frame["pointables"].push_back(std::move(pointable));
  }
}

bool is_leap_c(const json& recording) {
  for (const json& frame : list_of(recording, "frames")) {
    for (const json& hand : list_of(frame, "hands")) {
      return hand.is_object() && hand.contains("palm") && (hand.contains("digits") || hand.contains("index"));
    }
  }
  return false;
}

}  // namespace

json as_recording(json value) {
  if (!value.is_array()) return value;
  json recording = json::object();
  const bool header = !value.empty() && value[0].is_object() && value[0].contains("format");
  if (header && !value[0].contains("t") && !value[0].contains("hands") && !value[0].contains("frames")) {
    recording = std::move(value[0]);
    value.erase(0);
  }
  recording["frames"] = std::move(value);
  return recording;
}

bool is_leap(const json& recording) {
  if (recording.contains("format") || recording.contains("schema")) return false;
  for (const json& frame : list_of(recording, "frames")) {
    if (frame.is_array() || (frame.is_object() && frame.contains("pointables"))) return true;
    for (const json& hand : list_of(frame, "hands")) {
      if (hand.is_object() && hand.contains("palmPosition")) return true;
    }
  }
  return false;
}

json from_leap_c(json recording) {
  if (!is_leap_c(recording)) return recording;
  json frames = json::array();
  for (const json& frame : list_of(recording, "frames")) {
    json out{{"timestamp", member(frame, "timestamp")}, {"hands", json::array()}, {"pointables", json::array()}};
    if (out["timestamp"].is_null()) out["timestamp"] = member(member(frame, "info"), "timestamp");
    std::size_t id = 0;
    for (const json& hand : list_of(frame, "hands")) add_leap_c_hand(hand, id++, out);
    frames.push_back(std::move(out));
  }
  return {{"frames", frames}};
}

json canonical_joints(json recording, const std::string& path, std::vector<std::string>& remarks) {
  recording = as_recording(std::move(recording));
  if (recording.contains("schema")) recording = from_emulator(recording, path, remarks);
  const auto frames = recording.find("frames");
  if (frames == recording.end() || !frames->is_array()) return recording;
  for (std::size_t i = 0; i < frames->size(); ++i)
    make_frame_canonical((*frames)[i], fmt::format("{}, frame {}", path, i));
  if (!recording.contains("format")) find_format(recording, remarks);
  return recording;
}

}  // namespace handhold
