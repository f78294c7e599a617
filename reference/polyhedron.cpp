// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "cases/model/triangle_queries.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// Two ways are not the same if they differ by more than this part of the force. Less, and the distances of a way and
/// its neighbour on the next sector differ by too little to tell.
constexpr double other_way = 1e-3;

double angle(const Vector3d& u, const Vector3d& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); }

std::size_t at(int i) { return std::size_t(i); }

}  // namespace

/// Of the boundary of a tangent cone, sector by sector: the point nearest to a force, and the nearest one elsewhere.
class Polyhedron::Nearest {
 public:
  explicit Nearest(const Vector3d& force) : f_(force) {}

  /// `outward`: its sign towards f tells whether f lies in the cone, if w is the nearest (Baerentzen & Aanaes 2005).
  void offer(const Vector3d& w, const Vector3d& outward, const Foothold& hold) {
    const double d = (f_ - w).norm();
    const bool same = distance_ < infinity && (w - way_.w).norm() <= other_way * f_.norm();
    if (d < distance_) {
      if (!same) rival_ = distance_;
      distance_ = d;
      outward_ = outward;
      way_.w = w;
      way_.hold = hold;
    } else if (!same) {
      rival_ = std::min(rival_, d);
    }
  }

  /// The part of a face between two of its sides.
  void offer_sector(const Face& face, int id, const Vector3d& out, const Vector3d& other_out) {
    if (face.n.isZero(0)) return;
    const Vector3d w = f_ - f_.dot(face.n) * face.n;
    if (w.dot(out) <= 0 && w.dot(other_out) <= 0) offer(w, face.n, {id, -1, -1});
  }

  [[nodiscard]] Way take() {
    const bool in_cone = f_.dot(outward_) > 0;
    way_.N = in_cone ? -distance_ : distance_;
    way_.n = distance_ > 0 ? Vector3d((f_ - way_.w) / -way_.N) : outward_.normalized();
    way_.rival = rival_ - distance_;
    return way_;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vector3d f_;
  Way way_{};
  Vector3d outward_{Vector3d::Zero()};
  double distance_{infinity}, rival_{infinity};
};

Polyhedron::Polyhedron(const FaceGraph& faces) : graph_(faces) {
  for (int i = 0; i < count(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Face& f = face(i);
      if (at(f.vertex[k]) >= corner_normal_.size()) corner_normal_.resize(at(f.vertex[k]) + 1, Vector3d::Zero());
      const Vector3d &a = f.corner[k], &b = f.corner[(k + 1) % 3], &c = f.corner[(k + 2) % 3];
      corner_normal_[at(f.vertex[k])] += angle(b - a, c - a) * f.n;
    }
}

int Polyhedron::with_area(int triangle, const Vector3d& p) const {
  if (!face(triangle).n.isZero(0)) return triangle;
  int best = triangle;
  double least = std::numeric_limits<double>::infinity();
  for (const int corner : face(triangle).vertex)
    for (const int id : graph_.around(corner)) {
      const Face& f = face(id);
      const double d = closest_on_triangle(p, f.corner[0], f.corner[1], f.corner[2]).squared_distance;
      if (d < least) least = d, best = id;
    }
  return best;
}

/// Unit, along a side.
Vector3d Polyhedron::direction(int f, int side) const { return face(f).n.cross(face(f).out[at(side)]); }

/// Its sign tells in from out next to the edge; not unit.
Vector3d Polyhedron::edge_normal(int f, int side) const {
  const int beyond = face(f).beyond[at(side)];
  return beyond < 0 ? face(f).n : Vector3d(face(f).n + face(beyond).n);
}

int Polyhedron::side_from(int f, int corner) const {
  const std::array<int, 3>& v = face(f).vertex;
  return int(std::find(v.begin(), v.end(), corner) - v.begin());
}

/// With u along the side, n_next = cos n + sin (u × n): the turn is positive (convex) along u.
double Polyhedron::turn(int f, int side) const {
  const int beyond = face(f).beyond[at(side)];
  if (beyond < 0 || face(f).n.isZero(0)) return 0;
  const Vector3d &n = face(f).n, &m = face(beyond).n;
  return std::atan2(n.cross(m).dot(direction(f, side)), n.dot(m));
}

double Polyhedron::sharpest() const {
  double most = 0;
  for (int f = 0; f < count(); ++f)
    for (int side = 0; side < 3; ++side) most = std::max(most, std::abs(turn(f, side)));
  return most;
}

int Polyhedron::farthest_side(int f, const Vector3d& p) const {
  int best = 0;
  for (int side = 1; side < 3; ++side)
    if (outside(f, side, p) > outside(f, best, p)) best = side;
  return best;
}

Vector3d Polyhedron::on_side(int f, int side, const Vector3d& p) const {
  const Vector3d &a = face(f).corner[at(side)], &b = face(f).corner[at(side + 1) % 3];
  return a + std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) * (b - a);
}

Foothold Polyhedron::feature(const Vector3d& p, int f, double reach) const {
  for (std::size_t i = 0; i < 3; ++i)
    if ((p - face(f).corner[i]).norm() <= reach) return {f, -1, face(f).vertex[i]};
  const int side = farthest_side(f, p);
  return {f, outside(f, side, p) >= -reach ? side : -1, -1};
}

Way Polyhedron::way(const Vector3d& f, const Foothold& hold) const {
  Nearest nearest(f);
  if (hold.corner < 0) {
    const Face& here = face(hold.face);
    const Vector3d u = direction(hold.face, hold.side), &out = here.out[at(hold.side)];
    nearest.offer_sector(here, hold.face, out, out);
    const int beyond = here.beyond[at(hold.side)];
    if (beyond >= 0) {
      const Vector3d back = face(beyond).n.cross(u);  // out of the next face, over the same edge
      nearest.offer_sector(face(beyond), beyond, back, back);
    }
    nearest.offer(f.dot(u) * u, edge_normal(hold.face, hold.side), hold);
    return nearest.take();
  }
  for (const int id : graph_.around(hold.corner)) {
    const int side = side_from(id, hold.corner);
    nearest.offer_sector(face(id), id, face(id).out[at(side)], face(id).out[at(side + 2) % 3]);
  }
  for (const int id : graph_.around(hold.corner)) {
    const int side = side_from(id, hold.corner);
    const Vector3d u = direction(id, side);
    if (f.dot(u) > 0) nearest.offer(f.dot(u) * u, edge_normal(id, side), {id, side, -1});
  }
  nearest.offer(Vector3d::Zero(), corner_normal_[at(hold.corner)], hold);
  return nearest.take();
}

Way Polyhedron::along_edge(const Vector3d& f, const Foothold& hold) const {
  Nearest nearest(f);
  const Face& here = face(hold.face);
  const Vector3d u = direction(hold.face, hold.side);
  nearest.offer(f.dot(u) * u, edge_normal(hold.face, hold.side), hold);
  Way way = nearest.take();
  way.edge = u;
  way.leaves = -f.dot(here.out[at(hold.side)]);
  const int beyond = here.beyond[at(hold.side)];
  if (beyond >= 0) way.leaves = std::max(way.leaves, f.dot(u.cross(face(beyond).n)));
  return way;
}

}  // namespace handhold::reference
