// SPDX-License-Identifier: GPL-3.0-or-later
// make_mug, in its own file: its handle needs more than a loft.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "cases/geometry/loft.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr int patch_rows = 4;  // of wall quadrilaterals that give way to one end of the handle
constexpr int bow_rings = 24;

void require(bool holds, const char* rule) {
  if (!holds) throw InputError(fmt::format("mug: {} (correct its sizes)", rule));
}

// Where the handle meets the wall: quadrilaterals `column` = −columns/2 .. columns/2 around +x, `patch_rows` rows up.
struct Joint {
  int first_row;
  int columns;
  int segments;

  [[nodiscard]] int vertex(int row, int column) const {
    return (first_row + row) * segments + (column - columns / 2 + segments) % segments;
  }

  // Vertices around the patch, counter-clockwise seen from outside; upside down: mirrored top to bottom, so that a tube
  // bent by half a turn meets its corners again.
  [[nodiscard]] std::vector<int> border(bool upside_down) const {
    std::vector<int> ring;
    const auto add = [&](int row, int column) { ring.push_back(vertex(upside_down ? patch_rows - row : row, column)); };
    for (int c = 0; c < columns; ++c) add(0, c);
    for (int r = 0; r < patch_rows; ++r) add(r, columns);
    for (int c = columns; c > 0; --c) add(patch_rows, c);
    for (int r = patch_rows; r > 0; --r) add(r, 0);
    return ring;
  }

  [[nodiscard]] bool covers(int row, int column) const {
    const int shifted = (column + columns / 2) % segments;
    return row >= first_row && row < first_row + patch_rows && shifted < columns;
  }
};

// The handle between two joints: circles along half a turn around y.
void add_bow(Mesh& mesh, const Joint& upper, const Joint& lower, const Vector3d& middle, double bow, double thickness) {
  std::vector<int> previous = upper.border(false);
  const int corners = static_cast<int>(previous.size());
  // Directions of the circle's corners, as those of the patch's corners: the tube starts without a twist.
  std::vector<double> angles;
  Vector3d center = Vector3d::Zero();
  for (const int v : previous) center += mesh.vertices[v] / corners;
  for (const int v : previous) {
    const Vector3d d = mesh.vertices[v] - center;
    angles.push_back(std::atan2(d.z(), d.y()));
  }
  for (int ring = 0; ring <= bow_rings; ++ring) {
    const double turn = pi * ring / bow_rings;
    const Vector3d outward(std::sin(turn), 0, std::cos(turn));
    std::vector<int> current;
    for (const double angle : angles) {
      current.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back(middle + (bow + thickness / 2 * std::sin(angle)) * outward +
                              thickness / 2 * std::cos(angle) * Vector3d::UnitY());
    }
    join_rings(mesh, previous, current);
    previous = current;
  }
  join_rings(mesh, previous, lower.border(true));
}

}  // namespace

Mesh make_mug(const MugSize& size) {
  const auto& [radius, height, wall, gap, thickness, segments] = size;
  for (const double length : {radius, height, wall, gap, thickness})
    require(length > 0 && length < 1e3, "every length must be above 0");
  require(segments >= 48 && segments <= 4096, "segments must be from 48 to 4096");
  require(wall < radius && wall < height, "the wall must be thinner than the mug");
  const double stub = gap / 4;  // straight out of the wall before the bow begins
  const double bow = gap - stub + thickness / 2;
  require(2 * bow + 2 * thickness < height, "the handle must fit the height: take a smaller gap or thickness");
  require(bow > thickness, "the handle's gap must be wider than it is thick");

  const int wanted = static_cast<int>(std::lround(thickness / (2 * pi * radius / segments) / 2));
  const int columns = 2 * std::clamp(wanted, 1, segments / 8);
  const double low = height / 2 - bow, high = height / 2 + bow;
  std::vector<Ring> rings = {circle(radius, 0, segments)};
  for (const double joint : {low, high}) {
    for (int row = 0; row <= patch_rows; ++row)
      rings.push_back(circle(radius, joint + thickness * (double(row) / patch_rows - 0.5), segments));
  }
  const Joint lower{1, columns, segments}, upper{2 + patch_rows, columns, segments};
  rings.push_back(circle(radius, height, segments));
  rings.push_back(circle(radius - wall, height, segments));
  rings.push_back(circle(radius - wall, wall, segments));
  Mesh mesh = loft(rings, Vector3d::Zero(), {0, 0, wall});

  std::vector<std::array<int, 3>> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int quad = static_cast<int>(t / 2), row = quad / segments, column = quad % segments;
    if (!lower.covers(row, column) && !upper.covers(row, column)) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = std::move(kept);
  add_bow(mesh, upper, lower, {radius + stub, 0, height / 2}, bow, thickness);

  // Vertices inside the patches are no longer used.
  std::vector<int> number(mesh.vertices.size(), -1);
  Mesh result;
  for (auto& triangle : mesh.triangles) {
    for (int& v : triangle) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
      }
      v = number[v];
    }
  }
  result.triangles = std::move(mesh.triangles);
  const Vector3d center = solid_properties(result).center;
  for (Vector3d& v : result.vertices) v -= center;
  return result;
}

}  // namespace handhold
