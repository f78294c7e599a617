// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/leap_reader.hpp"

#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/input/json_input.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/joint_frames.hpp"
#include "cases/input/trace/source_frame.hpp"
#include "cases/input/trace/trace_assembler.hpp"
#include "cases/model/defect.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

const SourceFrame leap_frame{DEFECT(leap_in_centimetres, 1000, 100), 'y', false};
constexpr int deepest = 8;  // frame, pointables, a pointable, a list in it: more levels are no recording

/// An array of values with the given columns, as the object it stands for. A column is a name, or an object whose one
/// member names the columns of a nested object ([...]) or of a list of them ([[...]]).
json unpack(const json& columns, const json& row, const std::string& where, int depth = 0) {
  if (!columns.is_array() || !row.is_array() || row.size() > columns.size() || depth > deepest) {
    throw InputError(
        fmt::format("{}: a packed row does not fit the columns of the first frame (record it again)", where));
  }
  json object = json::object();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (columns[i].is_string()) {
      object[columns[i].get<std::string>()] = row[i];
      continue;
    }
    for (const auto& [name, nested] : columns[i].items()) {
      const bool list = nested.is_array() && !nested.empty() && nested[0].is_array();
      if (!list) {
        object[name] = unpack(nested, row[i], where, depth + 1);
        continue;
      }
      object[name] = json::array();
      for (const json& item : row[i]) object[name].push_back(unpack(nested[0], item, where, depth + 1));
    }
  }
  return object;
}

void read_palm(const json& hand, HandJoints& joints) {
  HandJoints::Joint& center = joints.joints[palm_joint];
  center.p_W = leap_frame.position(vector_of(hand, "palmPosition"));
  const Eigen::Vector3d z = leap_frame.direction(vector_of(hand, "direction")).normalized();
  const Eigen::Vector3d dorsal = -leap_frame.direction(vector_of(hand, "palmNormal"));
  const Eigen::Vector3d y = (dorsal - dorsal.dot(z) * z).normalized();
  if (!y.allFinite() || !z.allFinite()) return;
  Eigen::Matrix3d R;
  R << y.cross(z), y, z;
  center.R_WJ = Eigen::Quaterniond(R).normalized();
}

void read_finger(const json& pointable, int finger, HandJoints& joints) {
  static constexpr std::array<const char*, 4> names{"mcpPosition", "pipPosition", "dipPosition", "tipPosition"};
  const double radius = number_or(pointable, "width", 0) / 2 / leap_frame.per_metre;
  for (std::size_t i = 0; i < names.size(); ++i) {
    // The end of the bone where the file has it; else `tipPosition`, which is the same in the files that lack it.
    const bool bone_end = i == 3 && pointable.contains("btipPosition");
    HandJoints::Joint& joint = joints.joints[static_cast<std::size_t>(joint_of(finger, 0)) + i];
    joint.p_W = leap_frame.position(vector_of(pointable, bone_end ? "btipPosition" : names[i]));
    joint.radius = radius;
  }
}

/// Fingers of the hand `id`: by type, or in the order of the file.
void read_fingers(const json& frame, long id, HandJoints& joints) {
  int order = 0;
  for (const json& pointable : list_of(frame, "pointables")) {
    const bool tool = pointable.is_object() && pointable.contains("tool") && pointable["tool"] == true;
    if (tool || integer_or(pointable, "handId", -1) != id) continue;
    const long finger = integer_or(pointable, "type", order++);
    if (finger >= 0 && finger < 5) read_finger(pointable, static_cast<int>(finger), joints);
  }
}

void read_hand(const json& frame, const json& hand, TraceAssembler& assembler, std::size_t& guessed) {
  const long id = integer_or(hand, "id", -1);
  HandJoints joints;
  joints.confidence = number_or(hand, "confidence", 1);
  read_palm(hand, joints);
  if (hand.contains("wrist")) joints.joints[wrist_joint].p_W = leap_frame.position(vector_of(hand, "wrist"));
  read_fingers(frame, id, joints);
  const std::string type = hand.contains("type") && hand["type"].is_string() ? hand["type"].get<std::string>() : "";
  if (type == "left" || type == "right")
    return assembler.add_hand(type == "left" ? Side::left : Side::right, joints, id);
  if (!joints.complete()) return;  // no way to tell
  ++guessed;
  assembler.add_hand(side_of(joints), joints, id);
}

}  // namespace

Trace read_leap(std::string_view text, const std::string& path) {
  const json recording = parse_json(text, path);
  const json& frames = list_of(recording, "frames");
  if (frames.empty()) throw InputError(fmt::format("{}: there are no frames (is it a LeapJS recording?)", path));
  const bool packed = frames[0].is_array();
  TraceAssembler assembler(path, leap_frame.text(), TipPlace::bone);
  const std::size_t first = packed ? 1 : 0;
  if (const auto meta = recording.find("metadata"); meta != recording.end() && meta->is_object()) {
    const double stated = number_or(*meta, "frames", -1);
    const auto count = static_cast<double>(frames.size() - first);
    if (stated >= 0 && stated != count && stated != count + static_cast<double>(first)) {
      assembler.warn(fmt::format("metadata.frames says {}, but there are {}", stated, count));
    }
  }
  std::size_t guessed = 0;
  for (std::size_t i = first; i < frames.size(); ++i) {
    const std::string where = fmt::format("{}, frame {}", path, i);
    const json frame = packed ? unpack(frames[0], frames[i], where) : frames[i];
    if (!frame.is_object()) throw InputError(fmt::format("{}: is neither an object nor a packed row", where));
    if (!assembler.add_frame(number_or(frame, "timestamp", std::nan("")) * 1e-6, i)) continue;
    for (const json& hand : list_of(frame, "hands")) read_hand(frame, hand, assembler, guessed);
  }
  if (guessed > 0)
    assembler.warn(fmt::format("{} hands do not say whether left or right; told by their shape", guessed));
  Trace trace = assembler.finish();
  trace.name = stem_of(path);
  return trace;
}

}  // namespace handhold
