// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// A border is passed this far beyond it [m]: an anchor that has just come over is then inside its new face, and
/// round-off cannot send it back.
constexpr double border = 1e-12;

/// Sine of the turn of an edge that counts as hollow; less moves no anchor by more than `border`.
constexpr double least_hollow = 1e-10;

}  // namespace

MeshSurface::MeshSurface(std::shared_ptr<const VoxelField> field) : field_(std::move(field)) {
  const Mesh& mesh = field_->mesh();
  faces_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    Face f;
    for (std::size_t i = 0; i < 3; ++i) f.corner[i] = mesh.vertices[std::size_t(t[i])];
    const Vector3d normal = (f.corner[1] - f.corner[0]).cross(f.corner[2] - f.corner[0]);
    const double size = normal.norm();
    f.n = size > 0 ? Vector3d(normal / size) : Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) f.out[i] = (f.corner[(i + 1) % 3] - f.corner[i]).cross(f.n).stableNormalized();
    faces_.push_back(f);
  }
  join_neighbours();
  diagonal_ =
      field_->bounds().diagonal().norm() + 2 * field_->grid().spacing * field_->grid().size.cast<double>().norm();
}

void MeshSurface::join_neighbours() {
  const Mesh& mesh = field_->mesh();
  std::map<std::pair<int, int>, std::pair<int, int>> side_of;  // a directed edge belongs to one face of a closed mesh
  for (int f = 0; f < int(mesh.triangles.size()); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 3>& t = mesh.triangles[std::size_t(f)];
      side_of[{t[std::size_t(i)], t[std::size_t((i + 1) % 3)]}] = {f, i};
    }
  for (const auto& [edge, mine] : side_of) {
    const auto other = side_of.find({edge.second, edge.first});
    if (other != side_of.end())
      faces_[std::size_t(mine.first)].neighbour[std::size_t(mine.second)] = other->second.first;
  }
}

double MeshSurface::outside(const Face& face, int side, const Vector3d& p) {
  return (p - face.corner[std::size_t(side)]).dot(face.out[std::size_t(side)]);
}

int MeshSurface::farthest_side(const Face& face, const Vector3d& p) {
  int best = 0;
  for (int side = 1; side < 3; ++side)
    if (outside(face, side, p) > outside(face, best, p)) best = side;
  return best;
}

int MeshSurface::side_towards(int from, int to) const {
  const std::array<int, 3>& neighbour = face(from).neighbour;
  return int(std::find(neighbour.begin(), neighbour.end(), to) - neighbour.begin()) % 3;
}

/// With u along the side, n_next = cos n + sin (u × n): the turn is positive (convex) along u.
bool MeshSurface::hollow(int from, int side) const {
  const Face& here = face(from);
  const Vector3d u = here.n.cross(here.out[std::size_t(side)]);
  return here.n.cross(face(here.neighbour[std::size_t(side)]).n).dot(u) < -least_hollow;
}

double MeshSurface::value(const Vector3d& p_O) const {
  const double h = field_->grid().spacing, interpolated = field_->distance(p_O).distance;
  if (!(std::abs(interpolated) < 2 * h)) return interpolated;  // it errs by less than √3 h: its sign is right
  const std::optional<SurfacePoint> closest = field_->closest(p_O, 4 * h);
  return closest ? closest->distance : interpolated;
}

Foot MeshSurface::foot(const Vector3d& p_O) const {
  Foot foot;
  const std::optional<SurfacePoint> closest = field_->closest(p_O, diagonal_ + field_->bounds().exteriorDistance(p_O));
  if (!closest) return foot;  // not finite
  const Face& f = face(closest->triangle);
  foot.p_O = closest->p_O;
  foot.hold.face = closest->triangle;
  const Vector3d r = p_O - foot.p_O;
  const Vector3d beside = r - r.dot(f.n) * f.n;
  const bool over_edge = beside.norm() > 1e-9 * r.norm() + 1e-15;  // more than round-off
  foot.n_O = f.n;
  foot.depth = -r.dot(f.n);
  if (!over_edge) return foot;
  const int side = farthest_side(f, foot.p_O + beside);
  const int next = f.neighbour[std::size_t(side)];
  const bool caught = closest->distance < 0 && next >= 0 && !face(next).n.isZero(0) && hollow(closest->triangle, side);
  if (caught) foot.hold.wall = next;
  if (caught || closest->distance > 0) foot.n_O = r.normalized() * (closest->distance < 0 ? -1 : 1);
  foot.depth = -r.dot(foot.n_O);
  return foot;
}

AnchorSurface MeshSurface::at(const Vector3d& anchor_O, const Foothold& hold, bool) const {
  AnchorSurface surface;
  const Face& f = face(hold.face);
  surface.phi = (anchor_O - f.corner[0]).dot(f.n);
  surface.n = f.n;
  return surface;
}

Vector3d MeshSurface::project(const Vector3d& p_O, const Foothold& hold) const {
  const Face& f = face(hold.face);
  if (!hold.caught()) return p_O - (p_O - f.corner[0]).dot(f.n) * f.n;
  const std::size_t side = std::size_t(side_towards(hold.face, hold.wall));
  const Vector3d& a = f.corner[side];
  const Vector3d along = f.corner[(side + 1) % 3] - a;
  return a + std::clamp((p_O - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

double MeshSurface::overrun(const Vector3d& anchor_O, const Foothold& hold) const {
  const Face& f = face(hold.face);
  return outside(f, farthest_side(f, anchor_O), anchor_O) - border;
}

Foothold MeshSurface::beyond(const Vector3d& anchor_O, const Foothold& hold) const {
  const Face& f = face(hold.face);
  const int side = farthest_side(f, anchor_O);
  const int next = f.neighbour[std::size_t(side)];
  if (next < 0 || face(next).n.isZero(0)) return search_beyond(anchor_O, hold.face, side);
  if (hollow(hold.face, side)) return {hold.face, next};
  return {next, -1};
}

/// Across a face without area: whatever lies a little beyond it.
Foothold MeshSurface::search_beyond(const Vector3d& anchor, int from, int side) const {
  const double step = 1e-6 * diagonal_;
  const Vector3d p = anchor + step * face(from).out[std::size_t(side)];
  const std::optional<SurfacePoint> closest = field_->closest(p, diagonal_);
  return {closest ? closest->triangle : from, -1};
}

Wedge MeshSurface::wedge(const Foothold& hold) const {
  const Face &first = face(hold.face), &second = face(hold.wall);
  const std::size_t side = std::size_t(side_towards(hold.face, hold.wall));
  const std::size_t back = std::size_t(side_towards(hold.wall, hold.face));
  return {{first.n, second.n}, {-first.out[side], -second.out[back]}};
}

}  // namespace handhold::reference
