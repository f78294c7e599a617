// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/grasp_places.hpp"

#include <algorithm>
#include <cmath>

namespace handhold {
namespace {

constexpr double least_opposition = 0.8;  // 37 degrees: two cones of friction 0.33 still meet
constexpr double opening = 0.12;          // [m]: wider than any cup that a hand goes round
constexpr double thinnest = 1e-4;         // [m]; nearer hits are the triangle itself or its neighbour round an edge

// The R2 sequence (Roberts 2018): fractional parts of n / g and n / g², g the plastic number; even, and no random
// numbers.
constexpr double r2_x = 0.7548776662466927, r2_y = 0.5698402909980532;

double fraction(double x) { return x - std::floor(x); }

struct Spot {
  Eigen::Vector3d p, n;
};

/// Sums of the triangles' areas, one more than there are triangles.
std::vector<double> area_sums(const Mesh& mesh) {
  std::vector<double> sums{0};
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    sums.push_back(sums.back() + (b - a).cross(c - a).norm() / 2);
  }
  return sums;
}

/// The point at share `u` of the area, at (v, w) within its triangle.
Spot spot(const Mesh& mesh, const std::vector<double>& sums, double u, double v, double w) {
  const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, u * sums.back());
  const std::array<int, 3>& t = mesh.triangles[std::size_t(above - sums.begin()) - 1];
  const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  if (v + w > 1) v = 1 - v, w = 1 - w;  // the other half of the parallelogram
  return {a + v * (b - a) + w * (c - a), (b - a).cross(c - a).normalized()};
}

/// Whether the solid is missing below a ring around p.
bool is_narrow(const VoxelField& field, const Eigen::Vector3d& p, const Eigen::Vector3d& n, double thickness) {
  constexpr double ring = 0.003, below = 0.001;  // [m]: of a finger's samples; past the sag of what is round
  const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  const Eigen::Vector3d inside = p - std::min(below, thickness / 2) * n;
  int missing = 0;
  for (const Eigen::Vector3d& side : {u, Eigen::Vector3d(-u), v, Eigen::Vector3d(-v)})
    missing += field.distance(inside + ring * side).distance > 0;
  return missing > 1;
}

}  // namespace

std::vector<GraspPlace> find_grasp_places(const VoxelField& field, double thickest, int count) {
  const Mesh& mesh = field.mesh();
  const std::vector<double> sums = area_sums(mesh);
  std::vector<GraspPlace> places;
  for (int i = 0; i < count; ++i) {
    const auto [p, n] = spot(mesh, sums, (i + 0.5) / count, fraction(i * r2_x), fraction(i * r2_y));
    if (!n.allFinite() || n.isZero()) continue;
    const std::optional<RayHit> exit = field.raycast(p - thinnest * n, -n, thickest - thinnest);
    if (!exit) continue;
    const double thickness = exit->t + thinnest, opposition = -n.dot(exit->n_O);
    if (opposition < least_opposition) continue;
    const bool enclosed = field.raycast(p + thinnest * n, n, opening) ||
                          field.raycast(exit->p_O + thinnest * exit->n_O, exit->n_O, opening);
    const bool narrow = is_narrow(field, p, n, thickness) || is_narrow(field, exit->p_O, exit->n_O, thickness);
    places.push_back({p - thickness / 2 * n, n, thickness, opposition, narrow, enclosed});
  }
  return places;
}

}  // namespace handhold
