// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/wide_csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cases/input/trace/joint_sets.hpp"
#include "cases/input/trace/json_readers.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

/// What a column holds: the time (no joint), or a number of a joint.
struct Column {
  std::string side{}, joint{};
  const char* member{"position"};
  std::size_t place{};
};

std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  if (text.substr(0, 2) == "\r\n") text.remove_prefix(1);
  if (!text.empty()) text.remove_prefix(1);
  return line;
}

char separator_of(std::string_view line) {
  const std::size_t first = line.find_first_of(",;\t");
  return first == std::string_view::npos ? ',' : line[first];
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = std::min(line.find(separator), line.size());
    std::string_view field = line.substr(0, end);
    while (!field.empty() && (field.front() == ' ' || field.front() == '"')) field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '"')) field.remove_suffix(1);
    fields.push_back(field);
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

bool is_time(std::string_view name) {
  const std::vector<std::string> words = words_of(name);
  return !words.empty() && (words[0] == "t" || words[0] == "time" || words[0] == "timestamp");
}

/// Nothing if the name is no coordinate.
std::optional<Column> column_of(std::string_view name) {
  static const std::map<std::string, std::pair<const char*, std::size_t>> numbers{
      {"x", {"position", 0}},     {"y", {"position", 1}},     {"z", {"position", 2}},     {"px", {"position", 0}},
      {"py", {"position", 1}},    {"pz", {"position", 2}},    {"qx", {"orientation", 0}}, {"qy", {"orientation", 1}},
      {"qz", {"orientation", 2}}, {"qw", {"orientation", 3}}, {"w", {"orientation", 3}}};
  static const std::map<std::string, const char*> kinds{{"pos", "position"},           {"position", "position"},
                                                        {"rot", "orientation"},        {"rotation", "orientation"},
                                                        {"quat", "orientation"},       {"quaternion", "orientation"},
                                                        {"orientation", "orientation"}};
  std::vector<std::string> words = words_of(name);
  const auto number = words.empty() ? numbers.end() : numbers.find(words.back());
  if (number == numbers.end()) return std::nullopt;
  Column column{"", "", number->second.first, number->second.second};
  words.pop_back();
  if (const auto kind = words.empty() ? kinds.end() : kinds.find(words.back()); kind != kinds.end()) {
    column.member = kind->second;
    words.pop_back();
  }
  for (const std::string& word : words) {
    if (word == "left" || word == "right" || word == "l" || word == "r") {
      column.side = word[0] == 'l' ? "left" : "right";
      continue;
    }
    column.joint += (column.joint.empty() ? "" : "_") + word;
  }
  if (column.joint.empty()) return std::nullopt;
  return column;
}

class WideReader {
 public:
  WideReader(std::string_view text, const std::string& path) : path_(path) {
    const std::string_view header = next_line(text);
    separator_ = separator_of(header);
    for (const std::string_view name : fields_of(header, separator_)) read_column(name);
    while (!text.empty()) read_row(next_line(text));
  }

  Trace finish() {
    std::vector<std::string> remarks;
    if (guessed_)
      remarks.emplace_back(
          "the columns do not say which hand: taken as the right one (write left_ or right_ before them)");
    return joints_trace({{"frames", std::move(frames_)}}, path_, std::move(remarks));
  }

 private:
  void read_column(std::string_view name) {
    Column column;
    if (!is_time(name)) {
      const std::optional<Column> found = column_of(name);
      if (!found)
        throw InputError(
            fmt::format("{}:1: column \"{}\" is unknown (remove it, or name it like right_index_tip_x)", path_, name));
      column = *found;
      if (column.side.empty()) guessed_ = true, column.side = "right";
    }
    columns_.push_back(std::move(column));
  }

  /// NaN for an empty field.
  [[nodiscard]] double number(std::string_view field) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (field.empty()) return value;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error == std::errc{} && end == field.data() + field.size()) return value;
    throw InputError(
        fmt::format("{}:{}: \"{}\" is not a number (write 0.25 or 2.5e-1, with a point)", path_, line_, field));
  }

  void read_row(std::string_view line) {
    ++line_;
    if (line.empty()) return;
    const std::vector<std::string_view> fields = fields_of(line, separator_);
    if (fields.size() != columns_.size())
      throw InputError(fmt::format("{}:{}: {} fields for {} columns (give each a value, or leave it empty)", path_,
                                   line_, fields.size(), columns_.size()));
    json frame{{"hands", json::object()}};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const Column& column = columns_[i];
      const double value = number(fields[i]);
      if (column.joint.empty()) {
        frame["t"] = value;
        continue;
      }
      json& numbers = frame["hands"][column.side]["joints"][column.joint][column.member];
      if (numbers.is_null()) numbers = json(std::vector<json>(std::string_view(column.member) == "position" ? 3 : 4));
      numbers.at(std::min(column.place, numbers.size() - 1)) = value;
    }
    frames_.push_back(std::move(frame));
  }

  const std::string& path_;
  char separator_{};
  std::vector<Column> columns_{};
  std::size_t line_{1};
  json frames_ = json::array();
  bool guessed_{false};
};

}  // namespace

bool is_wide_csv(std::string_view text) {
  const std::string_view header = next_line(text);
  const std::vector<std::string_view> names = fields_of(header, separator_of(header));
  return std::any_of(names.begin(), names.end(), is_time) &&
         std::any_of(names.begin(), names.end(), [](std::string_view name) { return column_of(name).has_value(); });
}

Trace read_wide_csv(std::string_view text, const std::string& path) { return WideReader(text, path).finish(); }

}  // namespace handhold
