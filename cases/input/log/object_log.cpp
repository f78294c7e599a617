// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/log/object_log.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/input/json_input.hpp"
#include "cases/input/nearest_name.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/json_readers.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

const std::vector<std::string> object_keys{"shape", "scale", "mass", "friction", "friction_dynamic"};
const std::vector<std::string> pose_keys{"position", "orientation"};

std::string dumped(const json& value) { return value.dump(-1, ' ', true, json::error_handler_t::replace); }

/// A number > 0 (>= 0 for friction), if the member is there.
std::optional<double> positive(const json& object, const char* name, bool zero, const std::string& where) {
  const auto found = object.find(name);
  if (found == object.end() || found->is_null()) return std::nullopt;
  const double value = found->is_number() ? found->get<double>() : std::nan("");
  if (value > 0 || (zero && value == 0)) return value;
  throw InputError(fmt::format("{}: {} {} is no number {} 0 (correct it, or leave it out)", where, name, dumped(*found),
                               zero ? ">=" : ">"));
}

LoggedObject read_object(const std::string& name, const json& head, const std::string& path) {
  const std::string where = fmt::format("{}, object '{}'", path, name);
  LoggedObject object;
  object.name = name;
  if (!head.is_object()) throw InputError(where + ": is no object (write {\"shape\": \"shape:box\", \"mass\": 0.1})");
  check_keys(head, object_keys, where);
  if (head.contains("shape")) {
    if (!head["shape"].is_string()) throw InputError(where + ": \"shape\" is no text (put it in quotes)");
    object.shape = head["shape"].get<std::string>();
  }
  object.scale = positive(head, "scale", false, where).value_or(1);
  object.mass = positive(head, "mass", false, where);
  object.mu_static = positive(head, "friction", true, where);
  object.mu_dynamic = positive(head, "friction_dynamic", true, where);
  return object;
}

std::vector<LoggedObject> read_objects(const json& recording, const std::string& path) {
  const auto head = recording.find("objects");
  if (head == recording.end() || !head->is_object() || head->empty())
    throw InputError(
        fmt::format("{}: the head names no object (write \"objects\": {{\"cube\": {{\"shape\": \"shape:box\", "
                    "\"mass\": 0.1, \"friction\": 0.5}}}} before the frames)",
                    path));
  std::vector<LoggedObject> objects;
  for (const auto& [name, object] : head->items()) objects.push_back(read_object(name, object, path));
  return objects;
}

std::optional<Pose> read_pose(const json& pose, const JointsFormat& format, const std::string& where) {
  if (pose.is_null()) return std::nullopt;
  if (!pose.is_object())
    throw InputError(where + ": is no pose (write {\"position\": [0, 0, 0], \"orientation\": [0, 0, 0, 1]})");
  check_keys(pose, pose_keys, where);
  const Eigen::Vector3d p = vector_of(pose, "position");
  const Eigen::Vector4d v = numbers_of<4>(list_of(pose, "orientation"));
  if (!p.allFinite() || !v.allFinite()) return std::nullopt;
  if (std::abs(v.norm() - 1) > 0.01)
    throw InputError(fmt::format("{}: the orientation's length is {:.3g}, not 1 (give a unit quaternion, {})", where,
                                 v.norm(), format.wxyz ? "w, x, y, z" : "x, y, z, w"));
  Eigen::Quaterniond q =
      format.wxyz ? Eigen::Quaterniond(v[0], v[1], v[2], v[3]) : Eigen::Quaterniond(v[3], v[0], v[1], v[2]);
  q.normalize();
  return Pose{format.frame.rotation(q), format.frame.position(p)};
}

/// Puts what the frame says of objects at stamp number `stamp`.
void add_poses(const json& frame, const JointsFormat& format, const std::string& where, std::size_t stamp,
               std::vector<LoggedObject>& objects) {
  const auto poses = frame.find("objects");
  if (poses == frame.end() || poses->is_null()) return;
  if (!poses->is_object()) throw InputError(where + ": \"objects\" is no object (write {\"cube\": {...}})");
  for (const auto& [name, pose] : poses->items()) {
    const std::string& wanted = name;
    const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& o) { return o.name == wanted; });
    if (found == objects.end()) {
      std::vector<std::string> known;
      for (const LoggedObject& object : objects) known.push_back(object.name);
      throw InputError(fmt::format("{}: object '{}' is not in the head (did you mean '{}'?)", where, name,
                                   nearest_name(name, known)));
    }
    found->X_WO[stamp] = read_pose(pose, format, fmt::format("{}, object '{}'", where, name));
  }
}

double time_of(const json& frame, const std::string& where) {
  const double t = number_or(frame, "t", std::nan(""));
  if (!std::isfinite(t)) throw InputError(where + ": \"t\" is no time (write the seconds since the start)");
  return t;
}

void read_frames(const json& frames, const JointsFormat& format, const std::string& path, ObjectLog& log) {
  std::size_t late = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string where = fmt::format("{}, frame {}", path, i);
    const double t = time_of(frames[i], where) / format.ticks;
    if (!log.t.empty() && t <= log.t.back()) {
      ++late;
      continue;
    }
    log.t.push_back(t);
    for (LoggedObject& object : log.objects) object.X_WO.emplace_back();
    add_poses(frames[i], format, where, log.t.size() - 1, log.objects);
  }
  if (late > 0) log.warnings.push_back(fmt::format("{} frames are no later than the one before them: left out", late));
}

bool any_hand(const json& frames) {
  return std::any_of(frames.begin(), frames.end(), [](const json& frame) {
    const auto hands = frame.find("hands");
    return hands != frame.end() && hands->is_object() &&
           std::any_of(hands->begin(), hands->end(), [](const json& hand) { return !hand.is_null(); });
  });
}

}  // namespace

ObjectLog read_object_log(const std::string& path) {
  ObjectLog log;
  log.name = stem_of(path);
  const json recording = canonical_joints(parse_json(read_text_file(path), path), path, log.warnings);
  const json& frames = list_of(recording, "frames");
  constexpr std::size_t fewest = 3;  // of which an acceleration can be told
  if (frames.size() < fewest)
    throw InputError(fmt::format("{}: {} frames (log at least {})", path, frames.size(), fewest));
  const JointsFormat format = read_joints_format(recording, path);
  log.drawn_hands = recording.value("drawn_hands", false);
  log.objects = read_objects(recording, path);
  read_frames(frames, format, path, log);
  if (any_hand(frames)) {
    log.trace = joints_trace(recording, path);
    for (double& t : log.trace->t) t += log.t.front();  // traces begin at 0
    log.warnings.insert(log.warnings.end(), log.trace->warnings.begin(), log.trace->warnings.end());
  }
  return log;
}

}  // namespace handhold
