// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "cases/input/mesh/binary_bytes.hpp"
#include "cases/input/mesh/mesh_formats.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::size_t header = 84, record = 50;  // bytes of the header and of a triangle

[[noreturn]] void fail(const std::string& file, const std::string& rule, const char* advice) {
  throw InputError(fmt::format("{}: {} ({})", file, rule, advice));
}

void end_triangle(PolygonSoup& soup) {
  for (int i = 3; i > 0; --i) soup.corners.push_back(static_cast<int>(soup.points.size()) - i);
  soup.ends.push_back(soup.corners.size());
}

PolygonSoup parse_text(std::string_view bytes, const std::string& file) {
  const std::string text = plain_text(std::string(bytes));
  TextLines lines(text, file, {});
  PolygonSoup soup;
  std::size_t corners = 0, opened = 0, closed = 0;
  bool ended = false;
  while (lines.next()) {
    // Some writers put a whole facet on one line.
    for (std::string key = lower(lines.word()); !key.empty(); key = lower(lines.word())) {
      if (key == "end") key += lower(lines.word());
      if (key == "solid" || key == "endsolid") {
        ended = key == "endsolid";
        break;  // a name of any words follows
      }
      opened += key == "facet";
      closed += key == "endfacet";
      if (key != "vertex") continue;
      const double x = lines.real(), y = lines.real(), z = lines.real();
      soup.points.emplace_back(x, y, z);
      if (++corners % 3 == 0) end_triangle(soup);
    }
  }
  if (corners % 3 != 0 || opened != closed || corners != 3 * opened)
    lines.fail(fmt::format("{} facets with {} corners, {} of them ended", opened, corners, closed),
               "is the file truncated?");
  if (!ended) soup.warnings.emplace_back("no 'endsolid' at its end: facets may be missing");
  return soup;
}

PolygonSoup parse_binary(std::string_view bytes, const std::string& file) {
  if (bytes.size() < header) fail(file, "binary STL of the wrong size: less than a header", "is it truncated?");
  PolygonSoup soup;
  const std::size_t room = (bytes.size() - header) / record, rest = (bytes.size() - header) % record;
  std::size_t count = number_at<std::uint32_t>(bytes, 80);
  // Who writes while it is scanning cannot count before.
  const bool uncounted = (count == 0 || count == 0xffffffffu) && rest == 0;
  if (uncounted) {
    soup.warnings.push_back(fmt::format("its header counts {} triangles, {} are there", count, room));
    count = room;
  }
  const std::string_view start = bytes.substr(0, header);
  if (count > room && std::all_of(start.begin(), start.end(), [](char c) { return c >= '\t' && c <= '~'; }))
    fail(file, "text that does not begin with 'solid'", "is it another format?");
  if (count > room) {
    fail(file,
         fmt::format("binary STL of the wrong size: {} triangles announced, {} bytes instead of {}", count,
                     bytes.size(), header + record * count),
         "is it truncated?");
  }
  if (const std::size_t more = bytes.size() - header - record * count; more > 0)
    soup.warnings.push_back(fmt::format("{} bytes after its last triangle were passed over", more));
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Eigen::Vector3d p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = number_at<float>(bytes, header + record * t + 12 * corner + 4 * std::size_t(axis));
      if (!p.allFinite())
        fail(file, fmt::format("triangle {} has a coordinate that is not finite", t), "correct the file");
      soup.points.push_back(p);
    }
    end_triangle(soup);
  }
  return soup;
}

bool is_text(std::string_view bytes) {
  if (bytes.size() >= header && bytes.size() == header + record * number_at<std::uint32_t>(bytes, 80)) return false;
  const std::string start = lower(plain_text(std::string(bytes.substr(0, 1000))));
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  return (start.compare(first, 5, "solid") == 0 && start.find('\0') == std::string::npos) ||
         start.compare(first, 5, "facet") == 0;
}

}  // namespace

PolygonSoup parse_stl(std::string_view bytes, const std::string& file) {
  return is_text(bytes) ? parse_text(bytes, file) : parse_binary(bytes, file);
}

}  // namespace handhold
