// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Independent, slow answers for the geometry tests: every triangle, in long double, by other formulae than the
// library's.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>

#include "cases/model/mesh.hpp"

namespace handhold::brute {

using Real = long double;
inline constexpr double pi = 3.14159265358979323846;
using Vec = Eigen::Matrix<Real, 3, 1>;

inline Real distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec d = b - a;
  const Real length2 = d.squaredNorm();
  const Real s = length2 > 0 ? std::clamp<Real>((p - a).dot(d) / length2, 0, 1) : 0;
  return (p - a - s * d).norm();
}

// Distance by plane and sides: inside the prism over the triangle the plane's, else the nearest side's.
inline Real distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const Vec n = (b - a).cross(c - a);
  const bool inside =
      n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
  if (inside && n.norm() > 0) return std::abs(n.normalized().dot(p - a));
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

inline double distance(const Mesh& mesh, const Eigen::Vector3d& p) {
  Real nearest = std::numeric_limits<Real>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    nearest = std::min(nearest, distance_to_triangle(p.cast<Real>(), mesh.vertices[a].cast<Real>(),
                                                     mesh.vertices[b].cast<Real>(), mesh.vertices[c].cast<Real>()));
  }
  return static_cast<double>(nearest);
}

// First crossing by Moeller and Trumbore; infinity if there is none. `edge` widens the triangles.
inline double raycast(const Mesh& mesh, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, Real edge) {
  Real nearest = std::numeric_limits<Real>::infinity();
  const Vec o = origin.cast<Real>(), d = direction.cast<Real>();
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec a = mesh.vertices[i].cast<Real>(), e1 = mesh.vertices[j].cast<Real>() - a,
              e2 = mesh.vertices[k].cast<Real>() - a;
    const Vec p = d.cross(e2), s = o - a, q = s.cross(e1);
    const Real det = e1.dot(p);
    if (det == 0) continue;
    const Real u = s.dot(p) / det, v = d.dot(q) / det, t = e2.dot(q) / det;
    if (u >= -edge && v >= -edge && u + v <= 1 + edge && t >= 0) nearest = std::min(nearest, t);
  }
  return static_cast<double>(nearest);
}

inline Eigen::AlignedBox3d bounds(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& v : mesh.vertices) box.extend(v);
  return box;
}

inline Eigen::Vector3d random_in(const Eigen::AlignedBox3d& box, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  return box.min() + box.sizes().cwiseProduct(Eigen::Vector3d(unit(random), unit(random), unit(random)));
}

inline Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

inline Mesh turned(Mesh mesh) {  // to no axis in particular
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  for (auto& v : mesh.vertices) v = R * v;
  return mesh;
}

}  // namespace handhold::brute
