// SPDX-License-Identifier: GPL-3.0-or-later
// shape_kinds and make_shape: shapes by name, for scene files and the command line.
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

// Parameters of one shape, all of them set.
class Values {
 public:
  explicit Values(std::map<std::string, double> values) : values_(std::move(values)) {}

  double operator()(const char* name) const { return values_.at(name); }

  [[nodiscard]] int count(const char* name) const {
    const double value = values_.at(name);
    if (value == std::floor(value) && std::abs(value) < 1e6) return static_cast<int>(value);
    throw InputError(fmt::format("{}={}: need a whole number (correct the shape)", name, value));
  }

 private:
  std::map<std::string, double> values_;
};

struct Entry {
  ShapeKind kind;
  std::function<Mesh(const Values&)> make;
};

ToolSize tool_size(const Values& v) {
  return {v("handle_length"), v("handle_radius"), {v("head_x"), v("head_y"), v("head_z")}, v.count("segments")};
}

std::vector<ShapeParameter> tool_parameters(const ToolSize& size) {
  return {{"handle_length", size.handle_length, "[m]"},
          {"handle_radius", size.handle_radius, "[m]"},
          {"head_x", size.head.x(), "across the handle [m]"},
          {"head_y", size.head.y(), "[m]"},
          {"head_z", size.head.z(), "along the handle [m]"},
          {"segments", double(size.segments), "around the handle, a multiple of 4"}};
}

std::vector<Entry> entries() {
  const MugSize mug;
  const ToolSize hammer, axe{0.4, 0.015, {0.16, 0.034, 0.08}, 64};
  return {
      {{"box", "cuboid", {{"x", 0.06, "[m]"}, {"y", 0.06, "[m]"}, {"z", 0.06, "[m]"}}},
       [](const Values& v) {
         return make_box({v("x"), v("y"), v("z")});
       }},
      {{"sphere",
        "subdivided icosahedron",
        {{"radius", 0.035, "[m]"}, {"subdivisions", 4, "triangles: 20 · 4^subdivisions"}}},
       [](const Values& v) { return make_sphere(v("radius"), v.count("subdivisions")); }},
      {{"cylinder", "along z", {{"radius", 0.03, "[m]"}, {"height", 0.1, "[m]"}, {"segments", 64, "around"}}},
       [](const Values& v) { return make_cylinder(v("radius"), v("height"), v.count("segments")); }},
      {{"l_shape",
        "two legs from one corner",
        {{"leg_x", 0.08, "[m]"}, {"leg_y", 0.06, "[m]"}, {"width", 0.02, "of a leg [m]"}, {"height", 0.03, "[m]"}}},
       [](const Values& v) { return make_l_shape(v("leg_x"), v("leg_y"), v("width"), v("height")); }},
      {{"torus",
        "ring around z",
        {{"major_radius", 0.04, "of the middle line [m]"},
         {"minor_radius", 0.012, "of the section [m]"},
         {"segments", 64, "around"},
         {"section_segments", 32, "around the section"}}},
       [](const Values& v) {
         return make_torus(v("major_radius"), v("minor_radius"), v.count("segments"), v.count("section_segments"));
       }},
      {{"plate_with_hole",
        "with a round hole along z",
        {{"x", 0.1, "[m]"},
         {"y", 0.08, "[m]"},
         {"z", 0.012, "thickness [m]"},
         {"hole_radius", 0.02, "[m]"},
         {"segments", 64, "around the hole, a multiple of 4"}}},
       [](const Values& v) {
         return make_plate_with_hole({v("x"), v("y"), v("z")}, v("hole_radius"), v.count("segments"));
       }},
      {{"cup",
        "mug without a handle, open at +z",
        {{"radius", 0.04, "outer [m]"}, {"height", 0.095, "[m]"}, {"wall", 0.003, "[m]"}, {"segments", 96, "around"}}},
       [](const Values& v) { return make_cup(v("radius"), v("height"), v("wall"), v.count("segments")); }},
      {{"mug",
        "cup with a handle on +x",
        {{"radius", mug.radius, "outer [m]"},
         {"height", mug.height, "[m]"},
         {"wall", mug.wall, "[m]"},
         {"handle_gap", mug.handle_gap, "between wall and handle [m]"},
         {"handle_thickness", mug.handle_thickness, "[m]"},
         {"segments", double(mug.segments), "around, at least 48"}}},
       [](const Values& v) {
         return make_mug(
             {v("radius"), v("height"), v("wall"), v("handle_gap"), v("handle_thickness"), v.count("segments")});
       }},
      {{"hammer", "round handle along z, block as head", tool_parameters(hammer)},
       [](const Values& v) { return make_hammer(tool_size(v)); }},
      {{"axe", "round handle along z, head with a sharp edge on +x", tool_parameters(axe)},
       [](const Values& v) { return make_axe(tool_size(v)); }},
      {{"card", "bank card", {{"x", 0.0856, "[m]"}, {"y", 0.054, "[m]"}, {"z", 0.0008, "thickness [m]"}}},
       [](const Values& v) {
         return make_box({v("x"), v("y"), v("z")});
       }},
      {{"bowl",
        "open at +z",
        {{"radius", 0.06, "of the rim, outer [m]"},
         {"height", 0.045, "[m]"},
         {"wall", 0.004, "[m]"},
         {"segments", 64, "around"}}},
       [](const Values& v) { return make_bowl(v("radius"), v("height"), v("wall"), v.count("segments")); }},
      {{"bottle", "full, along z", {{"radius", 0.033, "[m]"}, {"height", 0.2, "[m]"}, {"segments", 64, "around"}}},
       [](const Values& v) { return make_bottle(v("radius"), v("height"), v.count("segments")); }},
      {{"pawn", "chess pawn", {{"height", 0.055, "[m]"}, {"segments", 64, "around"}}},
       [](const Values& v) { return make_pawn(v("height"), v.count("segments")); }},
  };
}

template <class Range>
std::string names(const Range& range) {
  std::vector<std::string> result;
  for (const auto& item : range) result.push_back(item.name);
  return fmt::format("{}", fmt::join(result, ", "));
}

}  // namespace

std::vector<ShapeKind> shape_kinds() {
  std::vector<ShapeKind> kinds;
  for (const Entry& entry : entries()) kinds.push_back(entry.kind);
  return kinds;
}

Mesh make_shape(std::string_view kind, const std::map<std::string, double>& parameters) {
  for (const Entry& entry : entries()) {
    if (entry.kind.name != kind) continue;
    std::map<std::string, double> values;
    for (const ShapeParameter& parameter : entry.kind.parameters) values[parameter.name] = parameter.value;
    for (const auto& [name, value] : parameters) {
      const auto place = values.find(name);
      if (place == values.end()) {
        throw InputError(fmt::format("shape {} with parameter '{}': no such parameter (choose from {})", kind, name,
                                     names(entry.kind.parameters)));
      }
      place->second = value;
    }
    return entry.make(Values(std::move(values)));
  }
  throw InputError(fmt::format("shape '{}': no such kind (choose from {})", kind, names(shape_kinds())));
}

}  // namespace handhold
