// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace handhold {

struct TrianglePoint {
  /// What of the triangle the point lies on: its inside, side `edge + i` (from corner i to i + 1), or corner `vertex +
  /// i`.
  static constexpr int face = 0, edge = 1, vertex = 4;

  Eigen::Vector3d p{Eigen::Vector3d::Zero()};
  double squared_distance{};
  int feature{face};
};

/// Closest point of triangle (a, b, c) to p, by Voronoi region (Ericson, Real-Time Collision Detection, 5.1.5). The
/// squared distance is taken from the point itself: plane formulae lose millimetres on slivers.
inline TrianglePoint closest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  constexpr int face = TrianglePoint::face, edge = TrianglePoint::edge, vertex = TrianglePoint::vertex;
  const auto at = [&p](const Eigen::Vector3d& q, int feature) {
    return TrianglePoint{q, (p - q).squaredNorm(), feature};
  };
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return at(a, vertex + 0);
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return at(b, vertex + 1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(a + d1 / (d1 - d3) * ab, edge + 0);
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return at(c, vertex + 2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(a + d2 / (d2 - d6) * ac, edge + 2);
  const double va = d3 * d6 - d5 * d4;
  const double e1 = d4 - d3, e2 = d5 - d6;
  if (va <= 0 && e1 >= 0 && e2 >= 0) return at(b + e1 / (e1 + e2) * (c - b), edge + 1);
  const double scale = 1 / (va + vb + vc);
  return at(a + vb * scale * ab + vc * scale * ac, face);
}

/// A ray prepared for the watertight test of Woop, Benthin and Wald (JCGT 2013): vertices are sheared so that the ray
/// runs along one axis, and the edge functions of two triangles that share an edge are exact negatives of each other,
/// so that no ray slips between them.
class WatertightRay {
 public:
  WatertightRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    direction.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    ox_ = origin[x_];
    oy_ = origin[y_];
    oz_ = origin[z_];
    shear_x_ = direction[x_] / direction[z_];
    shear_y_ = direction[y_] / direction[z_];
    shear_z_ = 1 / direction[z_];
  }

  /// Parameter t of the crossing with triangle (a, b, c), of either orientation and any sign; NaN if there is none.
  [[nodiscard]] double crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
    const double az = a.data()[z_] - oz_, bz = b.data()[z_] - oz_, cz = c.data()[z_] - oz_;
    const double ax = a.data()[x_] - ox_ - shear_x_ * az, ay = a.data()[y_] - oy_ - shear_y_ * az;
    const double bx = b.data()[x_] - ox_ - shear_x_ * bz, by = b.data()[y_] - oy_ - shear_y_ * bz;
    const double w = bx * ay - by * ax;  // of the side a b
    const double cx = c.data()[x_] - ox_ - shear_x_ * cz, cy = c.data()[y_] - oy_ - shear_y_ * cz;
    const double u = cx * by - cy * bx, v = ax * cy - ay * cx;
    const double least = std::min(std::min(u, v), w), most = std::max(std::max(u, v), w);
    if (least < 0 && most > 0) return NAN;
    const double det = u + v + w;
    if (det == 0) return NAN;  // the ray lies in the triangle's plane: its neighbours are hit
    return shear_z_ * (u * az + v * bz + w * cz) / det;
  }

 private:
  int x_{}, y_{}, z_{};
  double ox_{}, oy_{}, oz_{};
  double shear_x_{}, shear_y_{}, shear_z_{};
};

}  // namespace handhold
