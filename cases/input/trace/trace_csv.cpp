// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_csv.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/source_frame.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::string_view columns = "t,hand,side,phalanx,px,py,pz,qw,qx,qy,qz,confidence";
constexpr std::size_t column_count = 12;
constexpr int most_hands = 64;

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// One hand at the stamp being read.
struct Pending {
  HandSample sample{};
  std::bitset<phalanx_count> seen{};
  bool lost{false};
  bool broken{false};  // NaN
};

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& path) : path_(path) {
    trace_.name = stem_of(path);
    for (const std::string_view line : split(text, '\n')) {
      ++line_;
      read_line(!line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line);
    }
    end_frame();
  }

  Trace finish() {
    if (!marked_) fail_file("the line \"# handhold trace 1\" is missing (is it a handhold trace?)");
    if (trace_.hands.empty()) fail_file("there is no hand (give lines of phalanges)");
    trace_.source_frame = frame_.text();
    warn(repeated_, "phalanges are given twice at one time stamp; the later ones were dropped");
    warn(incomplete_, "hand samples lack a phalanx and count as lost");
    warn(broken_, "hand samples have numbers that are not finite and count as lost");
    for (std::size_t hand = 0; hand < named_.size(); ++hand) {
      if (!named_[hand])
        fail_file(fmt::format("there are {} hands, but no line of hand {} (count from 0)",
                              std::count(named_.begin(), named_.end(), true), hand));
    }
    for (auto& [hand, model] : models_) {
      if (hand >= static_cast<int>(trace_.hands.size()))
        fail_file(fmt::format("hand {} has a shape, but no line (remove the shape, or correct its number)", hand));
      trace_.hands[static_cast<std::size_t>(hand)].model = model;
    }
    validate(trace_);
    return std::move(trace_);
  }

 private:
  [[nodiscard]] std::string where() const { return fmt::format("{}:{}", path_, line_); }
  [[noreturn]] void fail(const std::string& rule) const { throw InputError(where() + ": " + rule); }
  [[noreturn]] void fail_file(const std::string& rule) const { throw InputError(path_ + ": " + rule); }
  void warn(std::size_t count, const char* what) {
    if (count > 0) trace_.warnings.push_back(fmt::format("{} {}", count, what));
  }

  [[nodiscard]] double number(std::string_view field) const {
    double value{};
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size()) {
      fail(fmt::format("\"{}\" is not a number (write 0.25 or 2.5e-1)", field));
    }
    return value;
  }
  [[nodiscard]] int hand_number(std::string_view field) const {
    const double value = number(field);
    if (value >= 0 && value < most_hands && value == std::floor(value)) return static_cast<int>(value);
    fail(fmt::format("hand {} is not a whole number from 0 to {} (count the hands from 0)", field, most_hands - 1));
  }
  [[nodiscard]] int phalanx(std::string_view name) const {
    try {
      return phalanx_from_name(name);
    } catch (const InputError& error) {
      fail(error.what());
    }
  }
  [[nodiscard]] Side side(std::string_view name) const {
    if (name == "left") return Side::left;
    if (name == "right") return Side::right;
    fail(fmt::format("side \"{}\" is unknown (use left or right)", name));
  }

  void read_line(std::string_view line) {
    if (line.empty() || line == columns) return;
    if (line.front() == '#') return read_header(line);
    const std::vector<std::string_view> fields = split(line, ',');
    if (fields.size() != column_count) {
      fail(fmt::format("{} fields, but a line has {} (write {})", fields.size(), column_count, columns));
    }
    read_row(fields);
  }

  void read_header(std::string_view line) {
    std::vector<std::string_view> words;
    for (const std::string_view word : split(line, ' ')) {
      if (!word.empty()) words.push_back(word);
    }
    if (words.size() < 3) return;
    const std::string_view key = words[1];
    if (line.rfind("# handhold trace ", 0) == 0) {
      if (words.size() != 4 || words[3] != "1")
        fail(fmt::format("version {} is unknown (this program reads 1)", words.back()));
      marked_ = true;
    } else if (key == "name") {
      trace_.name = clean_text(line.substr(line.find("name") + 5));
    } else if (key == "unit") {
      require_first(key);
      frame_.per_metre = units_per_metre(words[2], where());
    } else if (key == "up") {
      require_first(key);
      set_up(frame_, words[2], where());
    } else if (key == "handedness") {
      require_first(key);
      set_handedness(frame_, words[2], where());
    } else if (key == "time") {
      require_first(key);
      ticks_ = ticks_per_second(words[2], where());
    } else if (key == "capsule") {
      if (words.size() != 6) fail("a capsule has four fields (write # capsule, hand, phalanx, half length, radius)");
      const int bone = phalanx(words[3]);
      if (bone == palm) fail("the palm is no capsule (write # palm, hand and three half extents)");
      model(words[2]).capsules[static_cast<std::size_t>(bone)] = {length(words[4]), length(words[5])};
    } else if (key == "palm") {
      if (words.size() != 6) fail("a palm has four fields (write # palm, hand and three half extents)");
      model(words[2]).palm_box.half_extents = {length(words[3]), length(words[4]), length(words[5])};
    }
  }

  /// What was read before would be in another unit or frame than what follows.
  void require_first(std::string_view key) const {
    if (trace_.t.empty() && models_.empty()) return;
    fail(fmt::format("\"# {}\" stands below shapes or poses that it describes (move it to the top)", key));
  }

  [[nodiscard]] double length(std::string_view field) const {
    const double value = number(field);
    if (value >= 0 && std::isfinite(value)) return value / frame_.per_metre;
    fail(fmt::format("length {} must be finite and >= 0", field));
  }
  HandModel& model(std::string_view hand) {
    return models_.try_emplace(hand_number(hand), anatomical_hand()).first->second;
  }

  void read_row(const std::vector<std::string_view>& fields) {
    const double t = number(fields[0]) / ticks_;
    if (!std::isfinite(t)) fail("the time stamp is not finite (drop the line)");
    if (!trace_.t.empty() && t < trace_.t.back()) {
      fail(fmt::format("the time stamp {:.9g} s lies before {:.9g} s of the lines above (sort the lines by time)", t,
                       trace_.t.back()));
    }
    if (trace_.t.empty() || t > trace_.t.back()) {
      end_frame();
      trace_.t.push_back(t);
    }
    const int hand = hand_number(fields[1]);
    Pending& pending = pending_[hand];
    add_hand(hand, side(fields[2]));
    if (fields[3] == "lost") {
      pending.lost = true;
      pending.sample.confidence = fields[11].empty() ? 0 : number(fields[11]);
      return;
    }
    const auto i = static_cast<std::size_t>(phalanx(fields[3]));
    if (pending.seen[i]) {
      ++repeated_;
      return;
    }
    pending.seen.set(i);
    read_pose(fields, pending, i);
  }

  void read_pose(const std::vector<std::string_view>& fields, Pending& pending, std::size_t i) {
    std::array<double, 8> v{};
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = number(fields[4 + k]);
    Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);
    const Eigen::Vector3d p(v[0], v[1], v[2]);
    pending.sample.confidence = v[7];
    if (!p.allFinite() || !q.coeffs().allFinite() || !std::isfinite(v[7])) {
      pending.broken = true;
      return;
    }
    if (v[7] < 0 || v[7] > 1) fail(fmt::format("confidence {} must be 0 to 1 (scale it)", v[7]));
    if (std::abs(q.norm() - 1) > 0.01)
      fail(fmt::format("quaternion of norm {:.6g} (normalise it: w, x, y, z)", q.norm()));
    if (std::abs(q.norm() - 1) > 1e-7) q.normalize();  // else keep the very numbers of the file
    pending.sample.X_WP[i] = {frame_.rotation(q), frame_.position(p)};
  }

  void add_hand(int hand, Side side) {
    const auto index = static_cast<std::size_t>(hand);
    while (trace_.hands.size() <= index) {
      trace_.hands.push_back({side, anatomical_hand(), std::vector<HandSample>(trace_.t.size() - 1)});
    }
    if (named_.size() <= index) named_.resize(index + 1);
    if (named_[index] && trace_.hands[index].side != side) {
      fail(fmt::format("hand {} is {}, but was {} above (give each side its own number)", hand, to_string(side),
                       to_string(trace_.hands[index].side)));
    }
    trace_.hands[index].side = side;
    named_[index] = true;
  }

  void end_frame() {
    for (std::size_t h = 0; h < trace_.hands.size(); ++h) {
      Pending& pending = pending_[static_cast<int>(h)];
      const bool partial = pending.seen.any() && !pending.seen.all();
      if (partial && !pending.lost) ++incomplete_;
      if (pending.broken) ++broken_;
      pending.sample.tracked = pending.seen.all() && !pending.lost && !pending.broken;
      if (trace_.hands[h].samples.size() < trace_.t.size()) trace_.hands[h].samples.push_back(pending.sample);
    }
    pending_.clear();
  }

  const std::string& path_;
  std::size_t line_{};
  Trace trace_{};
  SourceFrame frame_{};
  double ticks_{1};
  bool marked_{false};
  std::map<int, HandModel> models_{};
  std::map<int, Pending> pending_{};
  std::vector<bool> named_{};
  std::size_t repeated_{}, incomplete_{}, broken_{};
};

}  // namespace

Trace read_trace_csv(std::string_view text, const std::string& path) { return CsvReader(text, path).finish(); }

std::string to_csv(const Trace& trace) {
  validate(trace);
  std::string name = clean_text(trace.name), out;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const auto add = std::back_inserter(out);
  fmt::format_to(add, "# handhold trace 1\n# name {}\n# unit m\n# up z\n# handedness right\n# time s\n", name);
  for (std::size_t h = 0; h < trace.hands.size(); ++h) {
    const HandModel& model = trace.hands[h].model;
    for (std::size_t i = 0; i < model.capsules.size(); ++i) {
      fmt::format_to(add, "# capsule {} {} {} {}\n", h, phalanx_name(static_cast<int>(i)),
                     model.capsules[i].half_length, model.capsules[i].radius);
    }
    const Eigen::Vector3d& half = model.palm_box.half_extents;
    fmt::format_to(add, "# palm {} {} {} {}\n", h, half.x(), half.y(), half.z());
  }
  fmt::format_to(add, "{}\n", columns);
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    for (std::size_t h = 0; h < trace.hands.size(); ++h) {
      const TraceHand& hand = trace.hands[h];
      const HandSample& sample = hand.samples[i];
      if (!sample.tracked) {
        fmt::format_to(add, "{},{},{},lost,,,,,,,,{}\n", trace.t[i], h, to_string(hand.side), sample.confidence);
        continue;
      }
      for (std::size_t k = 0; k < phalanx_count; ++k) {
        const Pose& X = sample.X_WP[k];
        fmt::format_to(add, "{},{},{},{},{},{},{},{},{},{},{},{}\n", trace.t[i], h, to_string(hand.side),
                       phalanx_name(static_cast<int>(k)), X.p.x(), X.p.y(), X.p.z(), X.R.w(), X.R.x(), X.R.y(), X.R.z(),
                       sample.confidence);
      }
    }
  }
  return out;
}

void write_trace_csv(const Trace& trace, const std::string& path) {
  const std::string text = to_csv(trace);
  const std::string beside = path + ".part";  // then renamed: a full disk leaves what was there
  std::ofstream file(beside, std::ios::binary);
  file << text;
  file.close();
  std::error_code failed;
  if (file) std::filesystem::rename(beside, path, failed);
  if (file && !failed) return;
  std::filesystem::remove(beside, failed);
  throw InputError(fmt::format("{}: cannot be written (check the folder and the space left)", path));
}

}  // namespace handhold
