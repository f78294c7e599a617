// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/surface.hpp"
#include "realtime/paper/voxel_walk.hpp"

namespace handhold::realtime::paper {

using Eigen::Vector3d;

std::optional<Spot> FieldSurface::cast(const Vector3d& from_O, const Vector3d& to_O) const {
  if (normals_ == Normals::voxel) return cast_voxels(*field_, from_O, to_O);
  const Vector3d way = to_O - from_O;
  const double length = way.norm();
  if (!(length > 0)) return std::nullopt;
  const std::optional<RayHit> hit = field_->raycast(from_O, way / length, length);
  if (!hit) return std::nullopt;
  return Spot{hit->p_O, normals_ == Normals::smooth ? smooth(hit->p_O, hit->n_O) : hit->n_O};
}

std::optional<Spot> FieldSurface::closest(const Vector3d& p_O, double reach) const {
  if (normals_ == Normals::voxel) return closest_voxel_face(*field_, p_O, reach);
  const std::optional<SurfacePoint> point = field_->closest(p_O, reach);
  if (!point) return std::nullopt;
  const Vector3d n = face_normal(point->triangle, point->n_O);
  // Inside a triangle the foot along its normal is the same point with less rounding: the field's goes through
  // barycentric coordinates, 1e-15 m on a triangle of metres, and a sample's first lag is made of it.
  const Vector3d foot = p_O - (p_O - point->p_O).dot(n) * n;
  const Vector3d C = (foot - point->p_O).squaredNorm() < 1e-24 ? foot : point->p_O;
  return Spot{C, normals_ == Normals::smooth ? smooth(C, n) : n};
}

/// Of the triangle itself, as a ray would see it: the field's own answer leans towards the query near an edge.
Vector3d FieldSurface::face_normal(int triangle, const Vector3d& instead) const {
  const Mesh& mesh = field_->mesh();
  const auto& corners = mesh.triangles[std::size_t(triangle)];
  const Vector3d& a = mesh.vertices[std::size_t(corners[0])];
  const Vector3d& b = mesh.vertices[std::size_t(corners[1])];
  const Vector3d& c = mesh.vertices[std::size_t(corners[2])];
  const Vector3d n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0 ? Vector3d(n / length) : instead;
}

/// Central differences over one voxel: continuous, unlike the gradient of the trilinear interpolant.
Vector3d FieldSurface::smooth(const Vector3d& p_O, const Vector3d& instead) const {
  const double h = field_->grid().spacing;
  Vector3d g;
  for (int i = 0; i < 3; ++i) {
    const Vector3d step = h * Vector3d::Unit(i);
    g[i] = field_->distance(p_O + step).distance - field_->distance(p_O - step).distance;
  }
  const double length = g.norm();
  return length > 0.2 * h ? Vector3d(g / length) : instead;  // at the ridge of a thin wall there is no gradient
}

std::shared_ptr<const Surface> make_surface(const printed::Shape& shape) {
  if (const auto* plane = std::get_if<printed::Plane>(&shape)) return std::make_shared<PlaneSurface>(plane->height);
  if (const auto* slab = std::get_if<printed::Slab>(&shape)) return std::make_shared<SlabSurface>(slab->half_width);
  if (const auto* ball = std::get_if<printed::Ball>(&shape)) return std::make_shared<SphereSurface>(ball->radius);
  const auto& voxels = std::get<printed::Voxels>(shape);
  return std::make_shared<FieldSurface>(voxels.field, voxels.normals);
}

}  // namespace handhold::realtime::paper
