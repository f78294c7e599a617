// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joints_reader.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/input/json_input.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/joint_frames.hpp"
#include "cases/input/trace/joint_sets.hpp"
#include "cases/input/trace/source_frame.hpp"
#include "cases/input/trace/trace_assembler.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

struct Format {
  const JointSet& set;
  SourceFrame frame;
};

std::string text_or(const json& object, const char* name, const char* otherwise) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

Format read_format(const json& recording, const std::string& path) {
  for (const char* name : {"format", "unit", "up"}) {
    if (recording.contains(name) && !recording[name].is_string())
      throw InputError(fmt::format("{}: \"{}\" is no text (put it in quotes)", path, name));
  }
  try {
    return {
        joint_set(text_or(recording, "format", "")),
        {units_per_metre(text_or(recording, "unit", "m"), path), up_axis(text_or(recording, "up", "y"), path), false}};
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind(path, 0) == 0 ? what : path + ": " + what);
  }
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
  const Eigen::Vector4d xyzw = numbers_of<4>(list_of(joint, "orientation"));
  if (!(xyzw.norm() > 0.5)) return read;  // absent, or zeros for "unknown"
  Eigen::Quaterniond q = Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]).normalized();
  if (format.set.minus_z_forward) q = q * Eigen::Quaterniond(0, 0, 1, 0);  // half a turn about y
  read.R_WJ = format.frame.rotation(q);
  return read;
}

HandJoints read_hand(const json& hand, const Format& format, const std::string& where) {
  HandJoints joints;
  joints.confidence = number_or(hand, "confidence", 1);
  const json& list = list_of(hand, "joints");
  const bool named = !list.empty() && list[0].is_object() && list[0].contains("name");
  if (!named && list.size() != format.set.entries.size()) {
    throw InputError(
        fmt::format("{}: {} joints, but {} has {} (give all in its order, null if untracked, or name them: {})", where,
                    list.size(), format.set.name, format.set.entries.size(), format.set.names()));
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_object()) continue;
    const std::size_t place = place_of(list[i], i, format.set, where);
    if (place >= format.set.entries.size()) continue;
    const int joint = format.set.entries[place].joint;
    if (joint != unused_joint) joints.joints[static_cast<std::size_t>(joint)] = read_joint(list[i], format);
  }
  return joints;
}

void read_hands(const json& hands, const Format& format, const std::string& where, TraceAssembler& assembler) {
  for (const auto& [side, hand] : hands.items()) {
    if (side != "left" && side != "right") {
      throw InputError(fmt::format("{}: hand \"{}\" is unknown (use left and right)", where, side));
    }
    if (!hand.is_object()) continue;
    assembler.add_hand(side == "left" ? Side::left : Side::right,
                       read_hand(hand, format, fmt::format("{}, {} hand", where, side)));
  }
}

}  // namespace

Trace read_joints(std::string_view text, const std::string& path) {
  const json recording = parse_json(text, path);
  const Format format = read_format(recording, path);
  const json& frames = list_of(recording, "frames");
  if (frames.empty()) throw InputError(fmt::format("{}: there are no frames (give at least two)", path));
  TraceAssembler assembler(path, format.frame.text(), format.set.tip);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!assembler.add_frame(number_or(frames[i], "t", std::nan("")), i)) continue;
    const auto hands = frames[i].find("hands");
    if (hands == frames[i].end() || !hands->is_object()) continue;
    read_hands(*hands, format, fmt::format("{}, frame {}", path, i), assembler);
  }
  Trace trace = assembler.finish();
  trace.name = stem_of(path);
  return trace;
}

}  // namespace handhold
