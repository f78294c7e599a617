// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cases/input/recording/recording_csv.hpp"
#include "cases/input/regular_file.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t body_columns = 13;
constexpr std::size_t energy_columns = 5;
constexpr std::size_t contact_columns = 20;
constexpr std::size_t event_columns = 7 + body_columns;

std::string unescape(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    const char c = text[++i];
    result += c == 'n' ? '\n' : c == 'r' ? '\r' : c == 'c' ? ':' : c;
  }
  return result;
}

/// The lines of a file, with the place for errors. Lines starting with # before the column names go to `header`.
class Lines {
 public:
  explicit Lines(const fs::path& path) : path_(path) {
    text_ = read_regular_file(path);
    while (next()) {
      if (line_.empty() || line_.front() != '#') break;
      header.push_back(std::string(line_));
    }
    columns = split().size();
  }

  /// Steps to the next line that is not empty; false at the end.
  bool next() {
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      line_ = std::string_view(text_).substr(at_, end - at_);
      if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
      at_ = end + 1;
      ++number_;
      if (!line_.empty()) return true;
    }
    line_ = {};
    return false;
  }

  [[noreturn]] void fail(const std::string& text) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), number_, text));
  }

  /// The next row, of `count` fields; empty at the end.
  std::vector<std::string_view> row(std::size_t count) {
    if (!next()) return {};
    std::vector<std::string_view> fields = split();
    if (fields.size() != count) fail(fmt::format("{} fields: must be {} (see the column names)", fields.size(), count));
    return fields;
  }

  [[nodiscard]] double number(std::string_view field) const {
    double value{};
    const auto [end, failed] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (failed != std::errc() || end != field.data() + field.size()) {
      fail(fmt::format("'{}': must be a number (write e.g. 1.5e-3)", field.substr(0, 40)));
    }
    return value;
  }

  [[nodiscard]] std::size_t index(std::string_view field, std::size_t limit) const {
    if (limit == 0)
      fail(fmt::format("'{}': there is nothing of that number (write what it names first)", field.substr(0, 40)));
    std::size_t value{};
    const auto [end, failed] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (failed != std::errc() || end != field.data() + field.size() || value >= limit) {
      fail(fmt::format("'{}': must be a whole number from 0 to {} (count from 0)", field.substr(0, 40), limit - 1));
    }
    return value;
  }

  std::vector<std::string> header;
  std::size_t columns{};

 private:
  /// Fields between commas. Only column names can be in quotes, and of those only the number matters.
  [[nodiscard]] std::vector<std::string_view> split() const {
    std::vector<std::string_view> fields;
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (line_[i] == '"') quoted = !quoted;
      if (line_[i] != ',' || quoted) continue;
      fields.push_back(line_.substr(begin, i - begin));
      begin = i + 1;
    }
    if (!line_.empty()) fields.push_back(line_.substr(begin));
    return fields;
  }

  fs::path path_;
  std::string text_;
  std::string_view line_;
  std::size_t at_{0};
  int number_{0};
};

template <typename Enum>
Enum enum_from(const Lines& lines, std::string_view text, int count) {
  std::string names;
  for (int i = 0; i < count; ++i) {
    if (to_string(Enum(i)) == text) return Enum(i);
    names += (i > 0 ? ", " : "") + std::string(to_string(Enum(i)));
  }
  lines.fail(fmt::format("'{}' is not one of {} (take one)", text.substr(0, 40), names));
}

using Fields = std::vector<std::string_view>;

Eigen::Vector3d vector_at(const Lines& lines, const Fields& f, std::size_t i) {
  return {lines.number(f[i]), lines.number(f[i + 1]), lines.number(f[i + 2])};
}

SampleId id_at(const Lines& lines, const Fields& f, std::size_t i, std::size_t bodies) {
  constexpr std::size_t byte = std::numeric_limits<std::uint8_t>::max() + std::size_t(1);
  return {std::uint8_t(lines.index(f[i], byte)), std::uint8_t(lines.index(f[i + 1], byte)),
          std::uint8_t(lines.index(f[i + 2], std::min(byte, bodies))), std::uint8_t(lines.index(f[i + 3], byte))};
}

void read_header(const Lines& lines, Recording& recording) {
  constexpr std::string_view provenance = "provenance.";
  for (const std::string& line : lines.header) {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, 2, "# ") != 0 || colon == std::string::npos) continue;  // somebody's remark
    const std::string key = line.substr(2, colon - 2);
    const std::string value = unescape(std::string_view(line).substr(colon + 2));
    if (key == "engine") recording.engine = value;
    if (key == "scene") recording.scene = value;
    if (key == "outcome") recording.outcome = enum_from<Outcome>(lines, value, 4);
    if (key == "note") recording.note = value;
    if (key == "body") recording.body_names.push_back(value);
    if (key.compare(0, provenance.size(), provenance) == 0) {
      recording.provenance[unescape(std::string_view(key).substr(provenance.size()))] = value;
    }
  }
}

BodyState body_at(const Lines& lines, const Fields& f, std::size_t i) {
  BodyState body;
  body.X_WO.p = vector_at(lines, f, i);
  body.X_WO.R = Eigen::Quaterniond(lines.number(f[i + 3]), lines.number(f[i + 4]), lines.number(f[i + 5]),
                                   lines.number(f[i + 6]));
  body.V_WO.v = vector_at(lines, f, i + 7);
  body.V_WO.w = vector_at(lines, f, i + 10);
  return body;
}

Energy energy_at(const Lines& lines, const Fields& f, std::size_t i) {
  return {lines.number(f[i]), lines.number(f[i + 1]), lines.number(f[i + 2]), lines.number(f[i + 3]),
          lines.number(f[i + 4])};
}

/// Of an engine that gives poses only.
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Energy not_recorded{nan, nan, nan, nan, nan};

void read_frames(const fs::path& path, Recording& recording) {
  Lines lines(path);
  read_header(lines, recording);
  const std::size_t bodies = recording.body_names.size();
  const std::size_t without_energy = 1 + body_columns * bodies, columns = lines.columns;
  const bool has_energy = columns == without_energy + energy_columns;
  if (!has_energy && columns != without_energy) {
    lines.fail(
        fmt::format("{} columns for {} bodies: must be {} or, with energies, {} (t_s, 13 a body, 5 energies or none; "
                    "'# body: NAME' "
                    "names them)",
                    columns, bodies, without_energy, without_energy + energy_columns));
  }
  for (Fields f = lines.row(columns); !f.empty(); f = lines.row(columns)) {
    Frame& frame = recording.frames.emplace_back();
    frame.t = lines.number(f[0]);
    for (std::size_t b = 0; b < bodies; ++b) frame.bodies.push_back(body_at(lines, f, 1 + body_columns * b));
    frame.energy = has_energy ? energy_at(lines, f, without_energy) : not_recorded;
  }
}

void read_contacts(const fs::path& path, Recording& recording) {
  Lines lines(path);
  const std::size_t bodies = recording.body_names.size();
  for (Fields f = lines.row(contact_columns); !f.empty(); f = lines.row(contact_columns)) {
    Frame& frame = recording.frames[lines.index(f[0], recording.frames.size())];
    ContactState contact;
    contact.id = id_at(lines, f, 2, bodies);
    contact.mode = enum_from<Mode>(lines, f[6], 3);
    contact.depth = lines.number(f[7]);
    contact.p_W = vector_at(lines, f, 8);
    contact.C_W = vector_at(lines, f, 11);
    contact.n_W = vector_at(lines, f, 14);
    contact.f_W = vector_at(lines, f, 17);
    if (!frame.contacts.empty() && !(frame.contacts.back().id < contact.id)) {
      lines.fail("the contacts of a frame must ascend in hand, phalanx, body, sample (sort them)");
    }
    frame.contacts.push_back(contact);
  }
}

void read_events(const fs::path& path, Recording& recording) {
  Lines lines(path);
  for (Fields f = lines.row(event_columns); !f.empty(); f = lines.row(event_columns)) {
    recording.events.push_back({lines.number(f[0]), lines.number(f[1]), enum_from<EventKind>(lines, f[2], 4),
                                id_at(lines, f, 3, recording.body_names.size()), body_at(lines, f, 7)});
  }
}

void read_frame_times(const fs::path& path, Recording& recording) {
  Lines lines(path);
  for (Fields f = lines.row(2); !f.empty(); f = lines.row(2)) recording.frame_time.push_back(lines.number(f[1]));
}

std::string unquoted(std::string_view field) {
  if (field.size() < 2 || field.front() != '"') return std::string(field);
  std::string result;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    if (field[i] == '"') ++i;  // two of them are one
    result += field[i];
  }
  return result;
}

void read_ambiguities(const fs::path& path, Recording& recording) {
  Lines lines(path);
  for (Fields f = lines.row(6); !f.empty(); f = lines.row(6))
    recording.ambiguities.push_back(
        {lines.number(f[0]), id_at(lines, f, 1, recording.body_names.size()), unquoted(f[5])});
}

}  // namespace

Recording read_recording(const std::filesystem::path& folder) {
  Recording recording;
  read_frames(folder / "frames.csv", recording);
  std::error_code ignored;
  if (fs::exists(folder / "contacts.csv", ignored)) read_contacts(folder / "contacts.csv", recording);
  if (fs::exists(folder / "events.csv", ignored)) read_events(folder / "events.csv", recording);
  if (fs::exists(folder / "frame_times.csv", ignored)) read_frame_times(folder / "frame_times.csv", recording);
  if (fs::exists(folder / "ambiguities.csv", ignored)) read_ambiguities(folder / "ambiguities.csv", recording);
  return recording;
}

}  // namespace handhold
