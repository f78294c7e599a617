// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/wall_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace handhold {

using Eigen::Vector3d;

double thinnest_wall(const VoxelField& field) {
  const Mesh& mesh = field.mesh();
  const double longest = field.bounds().diagonal().norm();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 2000);
  std::vector<std::pair<double, double>> walls;  // thickness, area
  double total = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vector3d& a = mesh.vertices[i];
    const Vector3d& b = mesh.vertices[j];
    const Vector3d& c = mesh.vertices[k];
    const Vector3d normal = (b - a).cross(c - a);
    const double area = normal.norm() / 2;
    if (!(area > 0)) continue;
    const Vector3d n = normal / (2 * area);
    const double start = 1e-9 * longest;  // just inside, not to hit the triangle itself
    const auto hit = field.raycast((a + b + c) / 3 - start * n, -n, longest);
    if (!hit || hit->n_O.dot(n) > -std::cos(20 * 3.14159265358979323846 / 180)) continue;
    walls.emplace_back(hit->t + start, area);
    total += area;
  }
  std::sort(walls.begin(), walls.end());
  double below = 0;
  for (const auto& [thickness, area] : walls) {
    below += area;
    if (below >= 0.01 * total) return thickness;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace handhold
