// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>

#include <fmt/format.h>

#include "cases/input/mesh/mesh_formats.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/text_encoding.hpp"

namespace handhold {
namespace {

// Moves past the keyword to the word that counts the vertices. The keyword may be missing, or stuck to the count.
std::string_view vertex_count(TextLines& lines) {
  std::string_view word = lines.first_word("its header");
  const std::size_t at = lower(word).find("off");
  if (std::isdigit(static_cast<unsigned char>(word.front())) && at == std::string_view::npos) return word;
  const std::string_view before = word.substr(0, at);
  if (at == std::string_view::npos || before.find_first_not_of("STCNstc") != std::string_view::npos) {
    if (at != std::string_view::npos) lines.fail("vertices of more than 3 dimensions", "export it in 3");
    lines.fail("does not begin with OFF", "is it another format?");
  }
  word.remove_prefix(at + 3);
  if (word.empty()) word = lines.word();
  if (lower(word) == "binary") lines.fail("is binary OFF", "save it as text");
  return word.empty() ? lines.first_word("its header") : word;
}

}  // namespace

PolygonSoup parse_off(std::string_view bytes, const std::string& file) {
  const std::string text = plain_text(std::string(bytes));
  TextLines lines(text, file, {.comments = true, .continuations = false});
  const long vertices = lines.whole(vertex_count(lines));
  std::string_view word = lines.word();
  const long faces = lines.whole(word.empty() ? lines.first_word("its header") : word);
  // A count of edges may follow, and nobody counts them.
  if (vertices < 4 || faces < 4)
    lines.fail(fmt::format("{} vertices, {} faces", vertices, faces), "a solid has at least 4");
  const auto fitting = static_cast<long>(text.size());
  if (vertices > fitting || faces > fitting) lines.fail("announces more than the file can hold", "is it truncated?");
  PolygonSoup soup;
  // One vertex and one face a line, as all writers do: what follows on the line are normals and colours.
  for (long v = 0; v < vertices; ++v) {
    const double x = lines.real(lines.first_word("the vertices")), y = lines.real(), z = lines.real();
    soup.points.emplace_back(x, y, z);
  }
  for (long f = 0; f < faces; ++f) {
    const long corners = lines.whole(lines.first_word("the faces"));
    if (corners < 1 || corners > vertices)
      lines.fail(fmt::format("face of {} corners", corners), "a face has at least 3");
    for (long c = 0; c < corners; ++c) {
      word = lines.word();
      if (word.empty()) lines.fail(fmt::format("face of {} corners names only {}", corners, c), "complete the line");
      const long index = lines.whole(word);
      if (index < 0 || index >= vertices)
        lines.fail(fmt::format("face names vertex {}, there are {}", index, vertices), "indices start at 0");
      if (corners > 2) soup.corners.push_back(static_cast<int>(index));
    }
    soup.dropped += corners < 3;
    if (corners > 2) soup.ends.push_back(soup.corners.size());
  }
  return soup;
}

}  // namespace handhold
