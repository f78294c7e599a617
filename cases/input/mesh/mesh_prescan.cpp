// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_prescan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

// Walks through the lines of a text; remembers where it is for messages.
class Lines {
 public:
  Lines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  // Moves to the next line, comments and outer blanks removed.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++number_;
    line_ = line_.substr(0, line_.find('#'));
    return true;
  }

  // The next word of the line; empty at its end.
  std::string_view word() {
    const std::size_t begin = line_.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return line_ = {};
    const std::size_t end = std::min(line_.find_first_of(blanks, begin), line_.size());
    const std::string_view result = line_.substr(begin, end - begin);
    line_ = line_.substr(end);
    return result;
  }

  double real() { return real(word()); }

  double real(std::string_view text) const {
    if (text.empty()) fail("a vertex needs three coordinates", "complete the line");
    const char* first = text.data() + (text.front() == '+');  // from_chars knows no plus sign
    double value = 0;
    const auto [end, error] = std::from_chars(first, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      fail(fmt::format("'{}' is not a finite number", text), "correct the coordinate");
    return value;
  }

  long whole(std::string_view text) const {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(fmt::format("'{}' is not a whole number", text), "correct the line");
    return value;
  }

  [[noreturn]] void fail(const std::string& rule, const char* advice) const {
    throw InputError(fmt::format("{}:{}: {} ({})", file_, number_, rule, advice));
  }

  [[nodiscard]] int number() const { return number_; }

 private:
  std::string_view rest_, line_;
  const std::string& file_;
  int number_ = 0;
};

/// Words of a damaged header may be anything.
std::string printable(std::string_view word) {
  std::string text(word.substr(0, 20));
  for (char& c : text) c = c < ' ' || c > '~' ? '?' : c;
  return text;
}

[[noreturn]] void fail(const std::string& file, const std::string& rule, const char* advice) {
  throw InputError(fmt::format("{}: {} ({})", file, rule, advice));
}

template <class T>
T binary(std::string_view bytes, std::size_t at) {  // little-endian, as this program's machines are
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

MeshPrescan scan_obj(std::string_view text, const std::string& file) {
  MeshPrescan result;
  Lines lines(text, file);
  long vertices = 0, highest = 0;
  int highest_line = 0;
  while (lines.next()) {
    const std::string_view key = lines.word();
    if (key == "v") {
      for (int i = 0; i < 3; ++i) lines.real();
      ++vertices;
    }
    if (key != "f") continue;
    std::size_t corners = 0;
    for (auto corner = lines.word(); !corner.empty(); corner = lines.word(), ++corners) {
      const long index = lines.whole(corner.substr(0, corner.find('/')));
      if (index == 0 || index < -vertices) {
        lines.fail(fmt::format("face names vertex {}, there are {} so far", index, vertices),
                   "indices start at 1, negative ones count back");
      }
      if (index > highest) highest = index, highest_line = lines.number();
    }
    if (corners < 3) lines.fail(fmt::format("face of {} corners", corners), "a face has at least 3");
    ++result.faces;
    result.triangles += corners - 2;
  }
  if (highest > vertices) {
    throw InputError(fmt::format("{}:{}: face names vertex {}, there are {} (is the file truncated?)", file,
                                 highest_line, highest, vertices));
  }
  if (result.faces == 0) fail(file, "no face ('f' line) in it", "give a triangle mesh");
  return result;
}

MeshPrescan scan_off(std::string_view text, const std::string& file) {
  Lines lines(text, file);
  const auto next_word = [&lines]() -> std::string_view {  // across lines
    for (auto word = lines.word();; word = lines.word()) {
      if (!word.empty()) return word;
      if (!lines.next()) lines.fail("the file ends too early", "is it truncated?");
    }
  };
  if (const auto magic = next_word(); magic.size() < 3 || magic.substr(magic.size() - 3) != "OFF")
    lines.fail("does not begin with OFF", "is it another format?");
  const long vertices = lines.whole(next_word()), faces = lines.whole(next_word());
  lines.whole(next_word());  // edges: nobody counts them
  if (vertices < 4 || faces < 4)
    lines.fail(fmt::format("{} vertices, {} faces", vertices, faces), "a solid has at least 4");
  const auto fitting = static_cast<long>(text.size());
  if (vertices > fitting || faces > fitting) lines.fail("announces more than the file can hold", "is it truncated?");
  // One vertex and one face a line, as all writers do: what follows on the line are colours.
  const auto next_filled = [&lines] {
    for (std::string_view word; lines.next();) {
      if (word = lines.word(); !word.empty()) return word;
    }
    lines.fail("the file ends too early", "is it truncated?");
  };
  for (long v = 0; v < vertices; ++v) {
    lines.real(next_filled());
    lines.real();
    lines.real();
  }
  MeshPrescan result;
  for (long f = 0; f < faces; ++f) {
    const long corners = lines.whole(next_filled());
    if (corners < 3 || corners > vertices)
      lines.fail(fmt::format("face of {} corners", corners), "a face has at least 3");
    for (long c = 0; c < corners; ++c) {
      const std::string_view word = lines.word();
      if (word.empty()) lines.fail(fmt::format("face of {} corners names only {}", corners, c), "complete the line");
      const long index = lines.whole(word);
      if (index < 0 || index >= vertices)
        lines.fail(fmt::format("face names vertex {}, there are {}", index, vertices), "indices start at 0");
    }
    ++result.faces;
    result.triangles += static_cast<std::size_t>(corners - 2);
  }
  return result;
}

MeshPrescan scan_stl(std::string_view bytes, const std::string& file) {
  // Some binary files begin with "solid", too: the announced size tells.
  const bool sized = bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t(binary<std::uint32_t>(bytes, 80));
  if (sized) {
    const std::size_t triangles = (bytes.size() - 84) / 50;
    for (std::size_t t = 0; t < triangles; ++t) {
      for (std::size_t i = 0; i < 9; ++i) {
        if (std::isfinite(binary<float>(bytes, 84 + 50 * t + 12 + 4 * i))) continue;
        fail(file, fmt::format("triangle {} has a coordinate that is not finite", t), "correct the file");
      }
    }
    return {triangles, triangles};
  }
  if (bytes.substr(0, 5) != "solid") {
    const std::string announced =
        bytes.size() < 84
            ? "less than a header"
            : fmt::format("{} triangles announced, {} bytes instead of {}", binary<std::uint32_t>(bytes, 80),
                          bytes.size(), 84 + 50 * std::size_t(binary<std::uint32_t>(bytes, 80)));
    fail(file, "binary STL of the wrong size: " + announced, "is it truncated?");
  }
  Lines lines(bytes, file);
  std::size_t corners = 0;
  bool ended = false;
  while (lines.next()) {
    const std::string_view key = lines.word();
    ended |= key == "endsolid";
    if (key != "vertex") continue;
    for (int i = 0; i < 3; ++i) lines.real();
    ++corners;
  }
  if (!ended) lines.fail("no 'endsolid'", "is the file truncated?");
  if (corners % 3 != 0)
    lines.fail(fmt::format("{} corners make no whole triangles", corners), "is the file truncated?");
  return {corners / 3, corners / 3};
}

MeshPrescan scan_ply(std::string_view bytes, const std::string& file) {
  Lines lines(bytes, file);
  if (!lines.next() || lines.word() != "ply") fail(file, "does not begin with 'ply'", "is it another format?");
  long vertices = -1, faces = -1;
  bool text = false;
  for (std::string_view key; key != "end_header";) {
    if (!lines.next()) lines.fail("no 'end_header'", "is the file truncated?");
    key = lines.word();
    const auto known = {"format", "comment", "obj_info", "element", "property", "end_header"};
    if (std::find(known.begin(), known.end(), key) == known.end())
      lines.fail(fmt::format("a PLY header has no '{}'", printable(key)), "is the file damaged?");
    if (key == "format") text = lines.word() == "ascii";
    if (key != "element") continue;
    const std::string_view what = lines.word();
    const long count = lines.whole(lines.word());
    if (count < 0 || count > static_cast<long>(bytes.size()))
      lines.fail(fmt::format("announces {} elements, more than the file can hold", count), "is it truncated?");
    if (what == "vertex") vertices = count;
    if (what == "face") faces = count;
  }
  if (vertices < 4 || faces < 4) lines.fail("needs at least 4 vertices and 4 faces", "give a closed mesh");
  if (text) {
    for (long i = 0; i < vertices; ++i) {
      if (!lines.next()) lines.fail("the file ends within the vertices", "is it truncated?");
      for (int axis = 0; axis < 3; ++axis) lines.real();
    }
    for (long i = 0; i < faces; ++i) {
      if (!lines.next()) lines.fail("the file ends within the faces", "is it truncated?");
      const long corners = lines.whole(lines.word());
      for (long c = 0; c < corners; ++c) {
        const long index = lines.whole(lines.word());
        if (index < 0 || index >= vertices)
          lines.fail(fmt::format("face names vertex {}, there are {}", index, vertices), "indices start at 0");
      }
    }
  }
  return {static_cast<std::size_t>(faces), static_cast<std::size_t>(faces)};
}

MeshPrescan scan_glb(std::string_view bytes, const std::string& file) {
  if (bytes.size() < 20 || bytes.substr(0, 4) != "glTF")
    fail(file, "does not begin with 'glTF'", "is it another format?");
  const auto length = binary<std::uint32_t>(bytes, 8);
  if (length != bytes.size())
    fail(file, fmt::format("announces {} bytes, has {}", length, bytes.size()), "is it truncated?");
  return {};
}

}  // namespace

MeshPrescan prescan_mesh(std::string_view bytes, const std::string& extension, const std::string& file) {
  if (extension == ".obj") return scan_obj(bytes, file);
  if (extension == ".off") return scan_off(bytes, file);
  if (extension == ".stl") return scan_stl(bytes, file);
  if (extension == ".ply") return scan_ply(bytes, file);
  if (extension == ".glb") return scan_glb(bytes, file);
  return {};
}

}  // namespace handhold
