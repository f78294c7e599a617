// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/loft.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace handhold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

std::vector<int> numbers(int first, int count) {
  std::vector<int> result(count);
  std::iota(result.begin(), result.end(), first);
  return result;
}

double cross(const Vector2d& u, const Vector2d& v) { return u.x() * v.y() - u.y() * v.x(); }

Mesh sides(const std::vector<Ring>& rings) {
  const int count = static_cast<int>(rings.front().size());
  Mesh mesh;
  for (const Ring& ring : rings) {
    assert(static_cast<int>(ring.size()) == count);
    mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
  }
  for (int r = 0; r + 1 < static_cast<int>(rings.size()); ++r)
    join_rings(mesh, numbers(r * count, count), numbers((r + 1) * count, count));
  return mesh;
}

}  // namespace

void join_rings(Mesh& mesh, const std::vector<int>& from, const std::vector<int>& to) {
  for (std::size_t j = 0; j < from.size(); ++j) {
    const std::size_t next = (j + 1) % from.size();
    mesh.triangles.push_back({from[j], from[next], to[next]});
    mesh.triangles.push_back({from[j], to[next], to[j]});
  }
}

Mesh loft(const std::vector<Ring>& rings, const Vector3d& bottom, const Vector3d& top) {
  Mesh mesh = sides(rings);
  const int count = static_cast<int>(rings.front().size());
  const int last = count * static_cast<int>(rings.size() - 1);
  const int bottom_vertex = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(bottom);
  mesh.vertices.push_back(top);
  for (int j = 0; j < count; ++j) {
    const int next = (j + 1) % count;
    mesh.triangles.push_back({bottom_vertex, next, j});
    mesh.triangles.push_back({bottom_vertex + 1, last + j, last + next});
  }
  return mesh;
}

Mesh loft_around(const std::vector<Ring>& rings) {
  Mesh mesh = sides(rings);
  const int count = static_cast<int>(rings.front().size());
  join_rings(mesh, numbers(count * static_cast<int>(rings.size() - 1), count), numbers(0, count));
  return mesh;
}

Ring circle(double radius, double z, int count) {
  Ring ring;
  for (int j = 0; j < count; ++j) {
    const double angle = 2 * pi * j / count;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return ring;
}

Ring around_polygon(const std::vector<Vector2d>& polygon, double z, int count) {
  Ring ring = circle(1, z, count);
  for (Vector3d& corner : ring) {
    const Vector2d direction = corner.head<2>();
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d& a = polygon[i];
      const Vector2d side = polygon[(i + 1) % polygon.size()] - a;
      const double turn = cross(direction, side);
      const double along = cross(a, direction) / turn;  // of the side, 0 to 1
      if (turn > 0 && along >= -1e-12 && along <= 1 + 1e-12) reach = std::min(reach, cross(a, side) / turn);
    }
    corner.head<2>() = reach * direction;
  }
  for (const Vector2d& corner : polygon) {
    const double turn = std::atan2(corner.y(), corner.x()) / (2 * pi) * count;
    const int nearest = (static_cast<int>(std::lround(turn)) + count) % count;
    ring[nearest].head<2>() = corner;
  }
  return ring;
}

}  // namespace handhold
