// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/mesh_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cases/model/triangle_queries.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// A border is passed this far beyond it [m], and the anchor is then put on it: round-off cannot send it back.
constexpr double border_width = 1e-12;

/// Nearer than this to a corner, an anchor is on it [m]: where two borders meet, it can have passed both.
constexpr double corner_size = 10 * border_width;

constexpr double round_off = 1e-16;  // of a length of some centimetres [m]

}  // namespace

MeshSurface::MeshSurface(std::shared_ptr<const VoxelField> field) : field_(std::move(field)), solid_(field_->faces()) {
  diagonal_ =
      field_->bounds().diagonal().norm() + 2 * field_->grid().spacing * field_->grid().size.cast<double>().norm();
}

double MeshSurface::value(const Vector3d& p_O) const {
  const double h = field_->grid().spacing, interpolated = field_->distance(p_O).distance;
  if (!(std::abs(interpolated) < 2 * h)) return interpolated;  // it errs by less than √3 h: its sign is right
  const std::optional<SurfacePoint> closest = field_->closest(p_O, 4 * h);
  return closest ? closest->distance : interpolated;
}

/// Behind a hollow edge or corner the point below p is on it, for all p between the normals of its faces.
Foot MeshSurface::foot(const Vector3d& p_O) const {
  Foot foot;
  const std::optional<SurfacePoint> closest = field_->closest(p_O, diagonal_ + field_->bounds().exteriorDistance(p_O));
  if (!closest) return foot;  // not finite
  foot.p_O = closest->p_O;
  foot.hold.face = solid_.with_area(closest->triangle, p_O);
  const Face& f = solid_.face(foot.hold.face);
  foot.n_O = f.n;
  const Vector3d r = p_O - foot.p_O;
  const Vector3d beside = r - r.dot(f.n) * f.n;
  const bool over_edge = beside.norm() > 1e-9 * r.norm() + 1e-15;  // more than round-off
  if (over_edge && closest->distance > 0) {
    foot.n_O = r.normalized();
  } else if (over_edge) {
    return foot_at(p_O, {foot.p_O, solid_.feature(foot.p_O, foot.hold.face, corner_size)});
  }
  foot.depth = -r.dot(foot.n_O);
  return foot;
}

/// For a place that p's anchor rests at without friction.
Foot MeshSurface::foot_at(const Vector3d& p_O, const Place& at) const {
  const Vector3d r = p_O - at.p_O;
  Foot foot{at.p_O, solid_.face(at.hold.face).n, 0, at.hold};
  if (at.hold.caught()) {
    const Way way = solid_.way(r, at.hold);
    foot.n_O = way.n;
    if (!way.hold.caught()) foot.hold = way.hold;
  }
  foot.depth = -r.dot(foot.n_O);
  return foot;
}

Foot MeshSurface::foot_on_sheet(const Vector3d& p_O, const Place& anchor) const {
  return foot_at(p_O, *slide(p_O, anchor, 0));
}

AnchorSurface MeshSurface::at(const Vector3d& anchor_O, const Foothold& hold, bool) const {
  AnchorSurface surface;
  const Face& f = solid_.face(hold.face);
  surface.phi = (anchor_O - f.corner[0]).dot(f.n);
  surface.n = f.n;
  return surface;
}

Vector3d MeshSurface::project(const Vector3d& p_O, const Foothold& hold) const {
  if (hold.corner >= 0) return field_->mesh().vertices[std::size_t(hold.corner)];
  if (hold.side >= 0) return solid_.on_side(hold.face, hold.side, p_O);
  const Face& f = solid_.face(hold.face);
  return p_O - (p_O - f.corner[0]).dot(f.n) * f.n;
}

double MeshSurface::overrun(const Vector3d& anchor_O, const Foothold& hold) const {
  if (hold.corner >= 0) return -1;
  if (hold.side < 0)
    return solid_.outside(hold.face, solid_.farthest_side(hold.face, anchor_O), anchor_O) - border_width;
  const Face& f = solid_.face(hold.face);
  const Vector3d &a = f.corner[std::size_t(hold.side)], &b = f.corner[std::size_t(hold.side + 1) % 3];
  const Vector3d u = (b - a).normalized();
  return std::max((a - anchor_O).dot(u), (anchor_O - b).dot(u)) - border_width;
}

Place MeshSurface::border(const Place& anchor) const {
  const int face = anchor.hold.face;
  const int side = anchor.hold.side >= 0 ? anchor.hold.side : solid_.farthest_side(face, anchor.p_O);
  const Vector3d p = solid_.on_side(face, side, anchor.p_O);
  const int next = solid_.face(face).beyond[std::size_t(side)];
  const Foothold at = solid_.feature(p, face, corner_size);
  if (at.corner >= 0) return {field_->mesh().vertices[std::size_t(at.corner)], at};
  if (next < 0) return search_beyond(anchor.p_O, face, side);
  return {p, {face, side, -1}};
}

/// Across a face without area: whatever lies a little beyond it.
Place MeshSurface::search_beyond(const Vector3d& anchor_O, int face, int side) const {
  const double step = 1e-6 * diagonal_;
  const Vector3d p = anchor_O + step * solid_.face(face).out[std::size_t(side)];
  const std::optional<SurfacePoint> closest = field_->closest(p, diagonal_);
  const Foothold hold{closest ? solid_.with_area(closest->triangle, p) : face, -1, -1};
  return {project(anchor_O, hold), hold};
}

/// Moves along w, which shrinks |p − C| all the way, so that no face is met twice.
std::optional<Place> MeshSurface::slide(const Vector3d& p_O, const Place& anchor, double mu) const {
  Place at = anchor;
  const int most = 100 + 4 * solid_.count();
  for (int i = 0; i < most; ++i) {
    const Vector3d r = p_O - at.p_O;
    Vector3d w, n;
    if (at.hold.caught()) {
      const Way way = solid_.way(r, at.hold);
      if (!(way.N > 0)) return at;
      at.hold = way.hold;
      w = way.w, n = way.n;
    } else {
      n = solid_.face(at.hold.face).n;
      w = r - r.dot(n) * n;
    }
    const double depth = -r.dot(n), lag = w.norm(), wanted = lag - mu * depth;
    if (!(depth > 0) || !(wanted > round_off)) return at;
    const Vector3d direction = w / lag;
    const Vector3d goal = at.p_O + wanted * direction;
    if (!(overrun(goal, at.hold) > 0)) return Place{project(goal, at.hold), at.hold};
    double t = wanted;
    if (at.hold.caught()) {
      t = (solid_.on_side(at.hold.face, at.hold.side, goal) - at.p_O).norm();
    } else {
      for (int side = 0; side < 3; ++side) {
        const double rate = direction.dot(solid_.face(at.hold.face).out[std::size_t(side)]);
        if (rate > 0) t = std::min(t, std::max(0.0, -solid_.outside(at.hold.face, side, at.p_O) / rate));
      }
    }
    at = border({at.p_O + t * direction, at.hold});
  }
  return at;
}

Foothold MeshSurface::convex_crease(const Foot& foot, double reach) const {
  const Foothold at = solid_.feature(foot.p_O, foot.hold.face, reach);
  for (int side = 0; side < 3; ++side) {
    const std::array<int, 3>& v = solid_.face(at.face).vertex;
    const bool ends_here = v[std::size_t(side)] == at.corner || v[std::size_t(side + 1) % 3] == at.corner;
    if ((side == at.side || ends_here) && solid_.convex_crease(at.face, side)) return at;
  }
  return {at.face, -1, -1};
}

/// Feet of one sheet that are as near are nearer to each other than a tenth of the depth.
bool MeshSurface::between_sheets(const Vector3d& p_O, const Foot& foot, double reach) const {
  for (int i = 0; i < solid_.count(); ++i) {
    const Face& f = solid_.face(i);
    const TrianglePoint q = closest_on_triangle(p_O, f.corner[0], f.corner[1], f.corner[2]);
    const bool as_near = std::sqrt(q.squared_distance) < foot.depth + reach;
    if (as_near && !f.n.isZero(0) && (q.p - foot.p_O).norm() > 0.1 * foot.depth) return true;
  }
  return false;
}

}  // namespace handhold::reference
