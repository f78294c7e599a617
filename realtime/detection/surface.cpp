// SPDX-License-Identifier: Apache-2.0
#include "realtime/detection/surface.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

constexpr double smallest_turn_cosine = 0.5;  // 60 degrees a voxel
constexpr double most_moves = 64;
constexpr double projection_error = 0.1;  // of `follow` [voxels]
constexpr double no_motion = 1e-9;        // a shorter way has no direction [voxels]

/// The same at the rim of the grid, where not all neighbours exist: six more queries.
Vector3d central_differences(const VoxelField& field, const Vector3d& p) {
  const double h = field.grid().spacing;
  Vector3d g;
  for (int i = 0; i < 3; ++i) {
    const Vector3d step = h * Vector3d::Unit(i);
    g[i] = (field.distance(p + step).distance - field.distance(p - step).distance) / (2 * h);
  }
  return g;
}

/// One Newton step of `p` onto the zero of the interpolated distance. False where the clamp at the band's end, felt two
/// cells inwards, would bend the gradient.
bool onto_surface(const VoxelField& field, Vector3d& p, Vector3d& n) {
  const SmoothDistance at = smooth_distance(field, p);
  if (std::abs(at.distance) >= field.band() - 3 * field.grid().spacing) return false;
  const double squared = at.gradient.squaredNorm();
  if (!(squared > 0.01)) return false;  // at a ridge of the distance: no way out is nearer than another
  p -= at.distance / squared * at.gradient;
  n = at.gradient / std::sqrt(squared);
  return true;
}

/// Two Newton steps onto the surface from a point that is close to it.
bool follow(const VoxelField& field, const Vector3d& p_O, Anchor& anchor) {
  Vector3d C = p_O, n;
  if (!onto_surface(field, C, n) || !onto_surface(field, C, n)) return false;
  anchor = {C, n};
  return true;
}

/// The exact nearest surface point from inside, searched from near to far: the cost grows with the cube of the reach.
std::optional<SurfacePoint> nearest_from_inside(const VoxelField& field, const Vector3d& p_O) {
  const double farthest = field.bounds().diagonal().norm() + field.band();
  for (double reach = field.band();; reach *= 2) {
    const std::optional<SurfacePoint> nearest = field.closest(p_O, reach);
    if (nearest || reach > farthest) return nearest;
  }
}

/// Smooth normal at a point of the surface, unless the surface is sharper there than voxels can tell.
Anchor anchor_at(const VoxelField& field, const Vector3d& p_O, const Vector3d& n_O, TouchNormal normal) {
  Anchor smooth;
  if (normal == TouchNormal::smooth && follow(field, p_O, smooth) && smooth.n_O.dot(n_O) > smallest_turn_cosine &&
      (smooth.C_O - p_O).norm() < 0.5 * field.grid().spacing)
    return smooth;
  return {p_O, n_O};
}

/// One stride of a slide, to the surface below its end. False (and `anchor` untouched) where the surface does not go
/// on: at the end of the band, onto another sheet, or where it turns by more than voxels can tell.
bool go_on(const VoxelField& field, const Vector3d& stride, Anchor& anchor) {
  Anchor moved;
  if (!follow(field, anchor.C_O + stride, moved)) return false;
  if (moved.n_O.dot(anchor.n_O) < smallest_turn_cosine) return false;
  const Vector3d way = moved.C_O - anchor.C_O;
  const double slack = projection_error * field.grid().spacing;
  if (way.norm() > 2 * stride.norm() + slack) return false;
  if (way.dot(stride) < -slack * stride.norm()) return false;  // an edge that smooth distances round off
  anchor = moved;
  return true;
}

/// How far behind an anchor, along its way, a sample is.
double lag_along(const Vector3d& way, const Vector3d& sample_O, const Anchor& anchor) {
  const Vector3d along = way - way.dot(anchor.n_O) * anchor.n_O;
  return (sample_O - anchor.C_O).dot(along) / along.norm();
}

/// Moves an anchor to where the lag within a stride falls to `least`, halving it: in a hollow edge, whose fillet is as
/// narrow as the stride.
void halve_to(const VoxelField& field, const Vector3d& sample_O, Vector3d stride, double least, Anchor& anchor) {
  for (int i = 0; i < 6; ++i) {
    stride *= 0.5;
    Anchor moved = anchor;
    if (go_on(field, stride, moved) && lag_along(stride, sample_O, moved) >= least) anchor = moved;
  }
}

}  // namespace

SmoothDistance smooth_distance(const VoxelField& field, const Vector3d& p_O) {
  // A central difference of the trilinear interpolant over one voxel is the trilinear interpolant of the nodes' central
  // differences: 4 x 4 x 4 nodes without the corners hold it all.
  const Grid& grid = field.grid();
  const double per_metre = 1 / grid.spacing;
  const Vector3d x = (p_O - grid.origin) * per_metre;
  const Eigen::Array3d last = grid.size.cast<double>().array() - 2;
  if (!((x.array() >= 1).all() && (x.array() < last).all()))
    return {field.distance(p_O).distance, central_differences(field, p_O)};
  const int i = int(x.x()), j = int(x.y()), k = int(x.z());
  const double u = x.x() - i, v = x.y() - j, w = x.z() - k;
  const std::ptrdiff_t dy = grid.size.x(), dz = dy * grid.size.y();
  const float* const node = field.data().distance.data() + grid.index(i, j, k);
  // Along x at (y, z): value, and differences of both ends.
  const auto at = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* const p = node + y * dy + z * dz;
    return p[0] + u * (double(p[1]) - p[0]);
  };
  const auto slope = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* const p = node + y * dy + z * dz;
    const double low = double(p[1]) - p[-1], high = double(p[2]) - p[0];
    return low + u * (high - low);
  };
  const auto bilinear = [&](double c00, double c10, double c01, double c11) {
    const double c0 = c00 + v * (c10 - c00), c1 = c01 + v * (c11 - c01);
    return c0 + w * (c1 - c0);
  };
  const double c00 = at(0, 0), c10 = at(1, 0), c01 = at(0, 1), c11 = at(1, 1);
  SmoothDistance s;
  s.distance = bilinear(c00, c10, c01, c11);
  s.gradient.x() = bilinear(slope(0, 0), slope(1, 0), slope(0, 1), slope(1, 1));
  s.gradient.y() = bilinear(c10 - at(-1, 0), at(2, 0) - c00, c11 - at(-1, 1), at(2, 1) - c01);
  s.gradient.z() = bilinear(c01 - at(0, -1), c11 - at(1, -1), at(0, 2) - c00, at(1, 2) - c10);
  s.gradient *= 0.5 * per_metre;
  return s;
}

bool foot(const VoxelField& field, const Vector3d& p_O, Anchor& anchor) {
  if (field.distance(p_O).distance >= 0) return follow(field, p_O, anchor);
  const std::optional<SurfacePoint> nearest = nearest_from_inside(field, p_O);
  if (!nearest) return false;
  if (!follow(field, nearest->p_O, anchor)) anchor = {nearest->p_O, nearest->n_O};
  return true;
}

bool find_touch(const VoxelField& field, const Vector3d& from_O, const Vector3d& to_O, TouchNormal normal,
                Anchor& anchor) {
  const Vector3d way = to_O - from_O;
  const double length = way.norm();
  if (!std::isfinite(length)) return false;
  if (length > no_motion * field.grid().spacing) {
    const Vector3d direction = way / length;
    const std::optional<RayHit> hit = field.raycast(from_O, direction, length);
    if (hit && hit->n_O.dot(direction) < 0) {
      anchor = anchor_at(field, hit->p_O, hit->n_O, normal);
      return true;
    }
  }
  if (field.distance(to_O).distance >= field.grid().spacing) return false;
  const std::optional<SurfacePoint> nearest = nearest_from_inside(field, to_O);
  if (!nearest || nearest->distance >= 0) return false;
  anchor = anchor_at(field, nearest->p_O, nearest->n_O, normal);
  return true;
}

bool slide(const VoxelField& field, const Vector3d& sample_O, const Vector3d& step_O, Anchor& anchor) {
  const double length = step_O.norm(), voxel = field.grid().spacing;
  if (!(length > 0) || !std::isfinite(length)) return true;
  const int moves = int(std::clamp(std::ceil(length / voxel), 1.0, most_moves));
  const double stride = length / moves;
  const Anchor straight{anchor.C_O + step_O, anchor.n_O};
  const auto leave = [&] {
    anchor = straight;
    return false;
  };
  const auto is_out = [&] { return field.distance(sample_O).distance > voxel; };
  Vector3d direction = step_O / length;
  const Vector3d reach = sample_O - anchor.C_O;
  const bool below = reach.dot(anchor.n_O) < 0;
  const double least = std::min(0.0, reach.dot(direction) - length);  // on a plane it never gets less than that
  for (int i = 0; i < moves; ++i) {
    const Vector3d way = stride * direction;
    Anchor moved = anchor;
    if (!go_on(field, way, moved)) {
      if (is_out()) return leave();
      anchor.C_O += (moves - i) * way;
      return true;
    }
    if (below && (sample_O - moved.C_O).dot(moved.n_O) >= 0) return leave();
    if (i + 1 < moves && lag_along(way, sample_O, moved) < least) {
      if (is_out()) return leave();
      halve_to(field, sample_O, way, least, anchor);
      return true;
    }
    anchor = moved;
    const Vector3d ahead = direction - direction.dot(anchor.n_O) * anchor.n_O;
    direction = ahead.normalized();  // not zero: a stride turns by 60 degrees at most
  }
  return true;
}

}  // namespace handhold::realtime
