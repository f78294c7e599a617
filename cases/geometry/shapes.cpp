// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/shapes.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cases/geometry/loft.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

void require_length(const char* what, double value) {
  if (value > 0 && value < 1e3) return;
  throw InputError(fmt::format("{}={}: need a length between 0 and 1000 m (correct the shape)", what, value));
}

void require_count(const char* what, int value, int least, int step = 1) {
  if (value >= least && value <= 4096 && value % step == 0) return;
  const std::string rule = step == 1 ? "" : fmt::format(", a multiple of {}", step);
  throw InputError(fmt::format("{}={}: need a number from {} to 4096{} (correct the shape)", what, value, least, rule));
}

void require(bool holds, const char* rule) {
  if (!holds) throw InputError(fmt::format("shape: {} (correct its sizes)", rule));
}

// Moves the centre of volume to the origin; what is symmetric keeps its exact coordinates.
Mesh centred(Mesh mesh) {
  Vector3d center = solid_properties(mesh).center;
  for (double& x : center) x = std::abs(x) < 1e-14 ? 0 : x;
  for (Vector3d& v : mesh.vertices) v -= center;
  return mesh;
}

std::vector<Vector2d> rectangle(double x, double y) {
  return {{x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}, {-x / 2, -y / 2}};
}

// A handle along z that ends in a prism over `head`.
Mesh tool(const ToolSize& size, const std::vector<Vector2d>& head) {
  require_length("handle_length", size.handle_length);
  require_length("handle_radius", size.handle_radius);
  for (const double x : size.head) require_length("head", x);
  require_count("segments", size.segments, 16, 4);
  require(size.head.y() > 2 * size.handle_radius, "the head must be wider than the handle");
  const double neck = size.handle_length, top = neck + size.head.z();
  return centred(loft({circle(size.handle_radius, 0, size.segments), circle(size.handle_radius, neck, size.segments),
                       around_polygon(head, neck, size.segments), around_polygon(head, top, size.segments)},
                      Vector3d::Zero(), {0, 0, top}));
}

}  // namespace

Mesh make_box(const Vector3d& size) {
  for (const double side : size) require_length("size", side);
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d side(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(size.cwiseProduct(side));
  }
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

Mesh make_sphere(double radius, int subdivisions) {
  require_length("radius", radius);
  if (subdivisions < 0 || subdivisions > 7)
    throw InputError(fmt::format("subdivisions={}: need a number from 0 to 7 (correct the shape)", subdivisions));
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (fresh) {
        // Split on the sphere, not on the chord, or triangles would grow uneven.
        const Vector3d sum = mesh.vertices[a].normalized() + mesh.vertices[b].normalized();
        mesh.vertices.push_back(sum.normalized());
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vector3d& v : mesh.vertices) v = radius * v.normalized();
  return mesh;
}

Mesh make_cylinder(double radius, double height, int segments) {
  require_length("radius", radius);
  require_length("height", height);
  require_count("segments", segments, 3);
  const double top = height / 2;
  return loft({circle(radius, -top, segments), circle(radius, top, segments)}, {0, 0, -top}, {0, 0, top});
}

Mesh make_l_shape(double leg_x, double leg_y, double width, double height) {
  require_length("leg_x", leg_x);
  require_length("leg_y", leg_y);
  require_length("width", width);
  require_length("height", height);
  require(width < leg_x && width < leg_y, "the legs must be longer than wide");
  const std::vector<Vector2d> outline = {{0, 0},         {leg_x, 0},     {leg_x, width},
                                         {width, width}, {width, leg_y}, {0, leg_y}};
  Mesh mesh;
  for (const double z : {-height / 2, height / 2}) {
    for (const Vector2d& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (int i = 1; i + 1 < 6; ++i) {  // every corner is seen from the first
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({6, 6 + i, 7 + i});
  }
  join_rings(mesh, {0, 1, 2, 3, 4, 5}, {6, 7, 8, 9, 10, 11});
  return centred(std::move(mesh));
}

Mesh make_torus(double major_radius, double minor_radius, int segments, int section_segments) {
  require_length("major_radius", major_radius);
  require_length("minor_radius", minor_radius);
  require_count("segments", segments, 3);
  require_count("section_segments", section_segments, 3);
  require(minor_radius < major_radius, "minor_radius must be below major_radius");
  std::vector<Ring> rings;
  for (int i = 0; i < section_segments; ++i) {
    const double angle = 2 * pi * i / section_segments;
    rings.push_back(circle(major_radius + minor_radius * std::cos(angle), minor_radius * std::sin(angle), segments));
  }
  return centred(loft_around(rings));
}

Mesh make_plate_with_hole(const Vector3d& size, double hole_radius, int segments) {
  for (const double side : size) require_length("size", side);
  require_length("hole_radius", hole_radius);
  require_count("segments", segments, 16, 4);
  require(2 * hole_radius < std::min(size.x(), size.y()), "the hole must be smaller than the plate");
  const auto outline = rectangle(size.x(), size.y());
  const double z = size.z() / 2;
  return centred(loft_around({around_polygon(outline, -z, segments), around_polygon(outline, z, segments),
                              circle(hole_radius, z, segments), circle(hole_radius, -z, segments)}));
}

Mesh make_cup(double radius, double height, double wall, int segments) {
  require_length("radius", radius);
  require_length("height", height);
  require_length("wall", wall);
  require_count("segments", segments, 3);
  require(wall < radius && wall < height, "the wall must be thinner than the cup");
  return centred(loft({circle(radius, 0, segments), circle(radius, height, segments),
                       circle(radius - wall, height, segments), circle(radius - wall, wall, segments)},
                      Vector3d::Zero(), {0, 0, wall}));
}

Mesh make_hammer(const ToolSize& size) {
  require(size.head.x() > 2 * size.handle_radius, "the head must be longer than the handle is thick");
  return tool(size, rectangle(size.head.x(), size.head.y()));
}

Mesh make_axe(const ToolSize& size) {
  const double poll = size.head.x() / 4, y = size.head.y() / 2;
  require(poll > size.handle_radius, "a quarter of the head must be longer than the handle's radius");
  // The cheeks stay parallel over the handle, then run straight to the edge.
  return tool(size, {{-poll, -y}, {size.handle_radius, -y}, {3 * poll, 0}, {size.handle_radius, y}, {-poll, y}});
}

Mesh make_pawn(double height, int segments) {
  require_length("height", height);
  require_count("segments", segments, 3);
  // Radius and height in parts of the whole height.
  std::vector<Vector2d> profile = {{0.30, 0}, {0.30, 0.08}, {0.27, 0.12}};
  for (int i = 0; i <= 10; ++i) {  // waist: a falling curve from 0.23 to 0.11
    const double s = i / 10.0;
    profile.emplace_back(0.11 + 0.12 * (1 - s) * (1 - s), 0.14 + 0.43 * s);
  }
  profile.insert(profile.end(), {{0.20, 0.59}, {0.20, 0.62}});
  const double ball = 0.19, middle = 1 - ball;
  for (int i = 1; i < 16; ++i) {
    const double angle = -pi / 2 + pi * (i + 4) / 20;  // from the collar to just short of the crown
    profile.emplace_back(ball * std::cos(angle), middle + ball * std::sin(angle));
  }
  std::vector<Ring> rings;
  for (const Vector2d& p : profile) rings.push_back(circle(height * p.x(), height * p.y(), segments));
  return centred(loft(rings, Vector3d::Zero(), {0, 0, height}));
}

Mesh make_bowl(double radius, double height, double wall, int segments) {
  require_length("radius", radius);
  require_length("height", height);
  require_length("wall", wall);
  require_count("segments", segments, 3);
  require(3 * wall < radius && 2 * wall < height, "the wall must be thinner than a third of the bowl");
  constexpr int rings_a_side = 12;
  std::vector<Ring> rings;
  const auto side = [&](double r, double bottom, bool up) {  // a quarter of an ellipse, foot to rim or back
    for (int i = 0; i <= rings_a_side; ++i) {
      const double angle = pi / 2 * (0.15 + 0.85 * (up ? i : rings_a_side - i) / rings_a_side);
      rings.push_back(circle(r * std::sin(angle), height - (height - bottom) * std::cos(angle), segments));
    }
  };
  side(radius, 0, true);
  side(radius - wall, wall, false);
  const auto foot = [&](double bottom) { return height - (height - bottom) * std::cos(0.15 * pi / 2); };
  return centred(loft(rings, {0, 0, foot(0)}, {0, 0, foot(wall)}));
}

Mesh make_bottle(double radius, double height, int segments) {
  require_length("radius", radius);
  require_length("height", height);
  require_count("segments", segments, 3);
  constexpr double body = 0.6, shoulder = 0.8, neck = 0.4;  // in parts of the height, and of the radius
  constexpr int shoulder_rings = 8;
  std::vector<Ring> rings = {circle(radius, 0, segments)};
  for (int i = 0; i <= shoulder_rings; ++i) {
    const double s = double(i) / shoulder_rings, narrowing = s * s * (3 - 2 * s);
    rings.push_back(circle(radius * (1 - (1 - neck) * narrowing), height * (body + (shoulder - body) * s), segments));
  }
  rings.push_back(circle(neck * radius, height, segments));
  return centred(loft(rings, Vector3d::Zero(), {0, 0, height}));
}

}  // namespace handhold
