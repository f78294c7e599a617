// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joints_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/hand/trace_doubts.hpp"
#include "cases/input/json_input.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/joint_frames.hpp"
#include "cases/input/trace/joint_sets.hpp"
#include "cases/input/trace/json_readers.hpp"
#include "cases/input/trace/source_frame.hpp"
#include "cases/input/trace/trace_assembler.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

const std::vector<std::string> recording_keys{"format", "unit", "up",       "handedness", "time",    "quaternion",
                                              "frames", "name", "metadata", "comment",    "objects", "drawn_hands"};
const std::vector<std::string> frame_keys{"t", "hands", "objects"};
const std::vector<std::string> hand_keys{"joints", "confidence", "id"};
const std::vector<std::string> joint_keys{"position", "orientation", "radius", "name"};

using Format = JointsFormat;

std::string text_or(const json& object, const char* name, std::string_view otherwise) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string(otherwise);
}

bool is_wxyz(const std::string& order, const std::string& path) {
  if (order == "xyzw" || order == "wxyz") return order == "wxyz";
  throw InputError(fmt::format("{}: quaternion \"{}\" is no order (use xyzw or wxyz)", path, order));
}

/// Place of a joint in the format's order: named, or its place in the list.
std::size_t place_of(const json& joint, std::size_t order, const JointSet& set, const std::string& where) {
  const std::string name = text_or(joint, "name", "");
  if (name.empty()) return order;
  if (const std::optional<std::size_t> place = set.find(name)) return *place;
  throw InputError(fmt::format("{}: joint \"{}\" is unknown in {} (use {})", where, name, set.name, set.names()));
}

HandJoints::Joint read_joint(const json& joint, const Format& format) {
  HandJoints::Joint read;
  read.p_W = format.frame.position(vector_of(joint, "position"));
  read.radius = std::max(0.0, number_or(joint, "radius", 0)) / format.frame.per_metre;
  const Eigen::Vector4d v = numbers_of<4>(list_of(joint, "orientation"));
  if (!(v.norm() > 0.5)) return read;  // absent, or zeros for "unknown"
  Eigen::Quaterniond q =
      format.wxyz ? Eigen::Quaterniond(v[0], v[1], v[2], v[3]) : Eigen::Quaterniond(v[3], v[0], v[1], v[2]);
  q.normalize();
  if (format.set->minus_z_forward) q = q * Eigen::Quaterniond(0, 0, 1, 0);  // half a turn about y
  read.R_WJ = format.frame.rotation(q);
  return read;
}

[[noreturn]] void fail_count(std::size_t count, const JointSet& set, const std::string& where) {
  std::string other;
  for (const JointSet& s : joint_sets()) {
    if (other.empty() && s.entries.size() == count)
      other = fmt::format("{0} has {1}: write \"format\": \"{0}\" if they are its; else ", s.name, count);
  }
  throw InputError(
      fmt::format("{}: {} joints, but {} has {} ({}give all in its order, null if untracked, or name them: {})", where,
                  count, set.name, set.entries.size(), other, set.names()));
}

double read_confidence(const json& hand, const std::string& where) {
  const auto found = hand.find("confidence");
  if (found == hand.end() || found->is_null()) return 1;
  const double confidence = found->is_number() ? found->get<double>() : std::nan("");
  if (confidence >= 0 && confidence <= 1) return confidence;
  throw InputError(fmt::format("{}: confidence {} must be a number from 0 to 1 (scale it, or leave it out)", where,
                               found->dump(-1, ' ', true, json::error_handler_t::replace)));
}

HandJoints read_hand(const json& hand, const Format& format, const std::string& where) {
  check_keys(hand, hand_keys, where);
  HandJoints joints;
  joints.confidence = read_confidence(hand, where);
  const json& list = list_of(hand, "joints");
  const bool named = std::any_of(list.begin(), list.end(), [](const json& j) { return j.contains("name"); });
  if (!named && list.size() != format.set->entries.size()) fail_count(list.size(), *format.set, where);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_object()) continue;
    check_keys(list[i], joint_keys, fmt::format("{}, joint {}", where, i));
    const std::size_t place = place_of(list[i], i, *format.set, where);
    if (place >= format.set->entries.size()) continue;
    const int joint = format.set->entries[place].joint;
    if (joint != unused_joint) joints.joints[static_cast<std::size_t>(joint)] = read_joint(list[i], format);
  }
  return joints;
}

/// Calls `visit` with side and joints of every hand of the frame that is there.
template <class Visit>
void each_hand(const json& frame, const Format& format, const std::string& where, const Visit& visit) {
  const auto hands = frame.find("hands");
  if (hands == frame.end() || !hands->is_object()) return;
  for (const auto& [side, hand] : hands->items()) {
    if (side != "left" && side != "right") {
      throw InputError(fmt::format("{}: hand \"{}\" is unknown (use left and right)", where, side));
    }
    if (!hand.is_object()) continue;
    visit(side == "left" ? Side::left : Side::right, read_hand(hand, format, fmt::format("{}, {} hand", where, side)));
  }
}

double read_time(const json& frame, const std::string& where) {
  if (!frame.is_object()) throw InputError(fmt::format("{}: is no object (write {{\"t\": 0, \"hands\": ...}})", where));
  check_keys(frame, frame_keys, where);
  const auto found = frame.find("t");
  if (found == frame.end()) throw InputError(fmt::format("{}: \"t\" is missing (add the time in seconds)", where));
  if (found->is_string())
    throw InputError(fmt::format("{}: \"t\" is text, {}, and no number (remove the quotes)", where,
                                 found->dump(-1, ' ', true, json::error_handler_t::replace)));
  return found->is_number() ? found->get<double>() : std::nan("");
}

Trace assemble(const json& recording, const Format& format, const std::string& path) {
  const json& frames = list_of(recording, "frames");
  TraceAssembler assembler(path, format.frame.text(), format.set->tip);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string where = fmt::format("{}, frame {}", path, i);
    if (!assembler.add_frame(read_time(frames[i], where) / format.ticks, i)) continue;
    each_hand(frames[i], format, where, [&](Side side, const HandJoints& joints) { assembler.add_hand(side, joints); });
  }
  return assembler.finish();
}

/// Mean cosine between the joints' axes and the bones that begin there, of the first hands; NaN without orientations.
double axis_cosine(const json& recording, const Format& format, const std::string& path) {
  constexpr int enough = 400;
  double sum = 0;
  int count = 0;
  for (const json& frame : list_of(recording, "frames")) {
    each_hand(frame, format, path, [&](Side, const HandJoints& joints) {
      for (int finger = 1; finger < 5; ++finger) {
        for (int bone = 0; bone < 2; ++bone) {
          const HandJoints::Joint& from = joints.joints[std::size_t(joint_of(finger, bone))];
          const Eigen::Vector3d along = joints.p(joint_of(finger, bone + 1)) - from.p_W;
          if (!from.R_WJ || !(along.norm() > 0)) continue;
          sum += along.normalized().dot(*from.R_WJ * Eigen::Vector3d::UnitZ());
          ++count;
        }
      }
    });
    if (count > enough) break;
  }
  return count > 0 ? sum / count : std::nan("");
}

void doubt_quaternions(const json& recording, Format format, const std::string& path,
                       std::vector<std::string>& remarks) {
  constexpr double right = 0.7, wrong = 0.3;  // 45 and 73 degrees off the bones, on average
  const double cosine = axis_cosine(recording, format, path);
  if (!(cosine < wrong)) return;
  format.wxyz = !format.wxyz;
  const double other = axis_cosine(recording, format, path);
  const char* order = format.wxyz ? "wxyz" : "xyzw";
  remarks.push_back(
      fmt::format("the orientations of joints do not point along the bones (mean cosine {:.2f}{})", cosine,
                  other > right ? fmt::format("; {0:.2f} if read as {1}: write \"quaternion\": \"{1}\"", other, order)
                                : fmt::format("; -z goes to the fingertip and y to the back in {}", format.set->name)));
}

/// The same joints in the order of another set, if only that makes a hand of them.
void doubt_order(const json& recording, Format format, const std::string& path, const Trace& trace,
                 std::vector<std::string>& remarks) {
  const auto odd = [](const Trace& t) {
    std::size_t count = 0;
    for (const TraceHand& hand : t.hands) count += odd_bones(hand.model).size();
    return count;
  };
  if (odd(trace) == 0) return;
  const std::string_view given = format.set->name;
  for (const JointSet& set : joint_sets()) {
    if (set.name == given || set.entries.size() != format.set->entries.size()) continue;
    Format other = format;
    other.set = &set;
    if (odd(assemble(recording, other, path)) > 0) continue;
    remarks.push_back(fmt::format("the joints make a hand in the order of {0}, not of {1} (write \"format\": \"{0}\")",
                                  set.name, given));
    return;
  }
}

}  // namespace

JointsFormat read_joints_format(const json& recording, const std::string& path) {
  check_keys(recording, recording_keys, path);
  for (const char* name : {"format", "unit", "up", "handedness", "time", "quaternion"}) {
    if (recording.contains(name) && !recording[name].is_string())
      throw InputError(fmt::format("{}: \"{}\" is no text (put it in quotes)", path, name));
  }
  if (recording.contains("drawn_hands") && !recording["drawn_hands"].is_boolean())
    throw InputError(fmt::format("{}: \"drawn_hands\" is neither true nor false (write one of them)", path));
  if (!recording.contains("format"))
    throw InputError(
        fmt::format("{}: \"format\" is missing (write \"format\": \"openxr\", \"webxr\", \"mano\", "
                    "\"mediapipe\" or \"leap\")",
                    path));
  Format format{};
  try {
    format.set = &joint_set(text_or(recording, "format", ""));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
  format.frame.per_metre = units_per_metre(text_or(recording, "unit", "m"), path);
  set_up(format.frame, text_or(recording, "up", format.set->up), path);
  set_handedness(format.frame, text_or(recording, "handedness", "right"), path);
  format.ticks = ticks_per_second(text_or(recording, "time", "s"), path);
  format.wxyz = is_wxyz(text_or(recording, "quaternion", "xyzw"), path);
  return format;
}

Trace joints_trace(json parsed, const std::string& path, std::vector<std::string> remarks) {
  const json recording = canonical_joints(std::move(parsed), path, remarks);
  if (list_of(recording, "frames").empty())
    throw InputError(fmt::format("{}: there are no frames (give at least two, as a list \"frames\")", path));
  const Format format = read_joints_format(recording, path);
  Trace trace = assemble(recording, format, path);
  doubt_quaternions(recording, format, path, remarks);
  doubt_order(recording, format, path, trace, remarks);
  trace.warnings.insert(trace.warnings.end(), remarks.begin(), remarks.end());
  trace.name = stem_of(path);
  return trace;
}

Trace read_joints(std::string_view text, const std::string& path) { return joints_trace(parse_json(text, path), path); }

}  // namespace handhold
