// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include "cases/input/mesh/mesh_formats.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

class ObjParser {
 public:
  ObjParser(std::string text, const std::string& file)
      : text_(std::move(text)), lines_(text_, file, {.comments = true, .continuations = true}), file_(file) {}

  PolygonSoup run() && {
    while (lines_.next()) {
      const std::string key = lower(lines_.word());
      if (key == "v") add_vertex();
      if (key == "f" || key == "fo") add_face();
      soup_.dropped += key == "l" || key == "p";
    }
    // A face may name vertices that come later in the file.
    if (highest_ > static_cast<long>(soup_.points.size())) {
      throw InputError(fmt::format("{}:{}: face names vertex {}, there are {} (is the file truncated?)", file_,
                                   highest_line_, highest_, soup_.points.size()));
    }
    if (soup_.ends.empty()) throw InputError(file_ + ": no face ('f' line) in it (give a triangle mesh)");
    return std::move(soup_);
  }

 private:
  void add_vertex() {
    const double x = lines_.real(), y = lines_.real(), z = lines_.real();
    soup_.points.emplace_back(x, y, z);
    // One more is a weight, three are a colour.
    double weight = 1;
    int more = 0;
    for (auto word = lines_.word(); !word.empty(); word = lines_.word(), ++more) weight = lines_.real(word);
    if (more == 1 && weight != 1) lines_.fail(fmt::format("a vertex of weight {:g}", weight), "only 1 is supported");
  }

  void add_face() {
    const long vertices = static_cast<long>(soup_.points.size());
    std::size_t corners = 0;
    for (auto corner = lines_.word(); !corner.empty(); corner = lines_.word(), ++corners) {
      const long index = lines_.whole(corner.substr(0, corner.find('/')));
      if (index == 0 || index < -vertices || index > 2'000'000'000) {
        lines_.fail(fmt::format("face names vertex {}, there are {} so far", index, vertices),
                    "indices start at 1, negative ones count back");
      }
      if (index > highest_) highest_ = index, highest_line_ = lines_.number();
      soup_.corners.push_back(static_cast<int>(index > 0 ? index - 1 : vertices + index));
    }
    if (corners < 3) lines_.fail(fmt::format("face of {} corners", corners), "a face has at least 3");
    soup_.ends.push_back(soup_.corners.size());
  }

  std::string text_;
  TextLines lines_;
  const std::string& file_;
  PolygonSoup soup_;
  long highest_ = 0;
  int highest_line_ = 0;
};

}  // namespace

PolygonSoup parse_obj(std::string_view bytes, const std::string& file) {
  return ObjParser(plain_text(std::string(bytes)), file).run();
}

}  // namespace handhold
