// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/voxel_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handhold::realtime::paper {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

bool full(const VoxelField& field, const Vector3i& v) {
  if (v.minCoeff() < 0 || (v.array() >= field.grid().size.array()).any()) return false;
  return field.occupied(v.x(), v.y(), v.z());
}

/// Coordinates in voxels: voxel i holds [i, i + 1).
Vector3d in_voxels(const VoxelField& field, const Vector3d& p_O) {
  return (p_O - field.grid().origin) / field.grid().spacing + Vector3d::Constant(0.5);
}

Vector3i voxel_at(const Vector3d& x) { return x.array().floor().cast<int>(); }

/// Where a way enters the grid with a rim of one voxel around it, as a part of the way; infinity: it passes by. Who
/// begins there walks no further than the grid is wide, however far away a run that diverges may be.
double entry(const Vector3d& begin, const Vector3d& way, const Vector3i& size) {
  double enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    const double low = -1 - begin[i], high = size[i] + 1 - begin[i];
    if (way[i] == 0) {
      if (low > 0 || high < 0) return std::numeric_limits<double>::infinity();
      continue;
    }
    enter = std::max(enter, std::min(low / way[i], high / way[i]));
    leave = std::min(leave, std::max(low / way[i], high / way[i]));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/// Nearest face of voxel `v` that has no full neighbour, if nearer than `best`.
void nearest_face(const VoxelField& field, const Vector3d& x, const Vector3i& v, double& best, Spot& spot) {
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, side = face % 2;
    if (full(field, v + (2 * side - 1) * Vector3i::Unit(axis))) continue;
    Vector3d foot = x.cwiseMax(v.cast<double>()).cwiseMin((v + Vector3i::Ones()).cast<double>());
    foot[axis] = v[axis] + side;
    const double squared = (x - foot).squaredNorm();
    if (squared >= best) continue;
    best = squared;
    spot.C_O = field.grid().origin + field.grid().spacing * (foot - Vector3d::Constant(0.5));
    spot.n_O = (2 * side - 1) * Vector3d::Unit(axis);
  }
}

}  // namespace

std::optional<Spot> cast_voxels(const VoxelField& field, const Vector3d& from_O, const Vector3d& to_O) {
  const Vector3d begin = in_voxels(field, from_O), way = in_voxels(field, to_O) - begin;
  if (!begin.allFinite() || !way.allFinite()) return std::nullopt;
  const Vector3i& size = field.grid().size;
  const double enter = entry(begin, way, size);
  if (!(enter <= 1)) return std::nullopt;
  const Vector3d inner = begin + enter * way;  // rounded: from far away not on the rim itself
  Vector3i v = voxel_at(inner.cwiseMax(-1).cwiseMin((size + Vector3i::Ones()).cast<double>()));
  Vector3d next, pace;  // fraction of the way at the next wall along each axis, and from wall to wall
  for (int i = 0; i < 3; ++i) {
    const double wall = v[i] + (way[i] > 0);
    next[i] = way[i] == 0 ? std::numeric_limits<double>::infinity() : (wall - begin[i]) / way[i];
    pace[i] = way[i] == 0 ? std::numeric_limits<double>::infinity() : 1 / std::abs(way[i]);
  }
  bool inside = full(field, v);
  while (true) {
    int axis = 0;
    const double t = next.minCoeff(&axis);
    if (!(t <= 1)) return std::nullopt;
    const int step = way[axis] > 0 ? 1 : -1;
    v[axis] += step;
    if (v[axis] < -1 || v[axis] > size[axis] + 1) return std::nullopt;
    next[axis] += pace[axis];
    const bool entered = full(field, v);
    if (entered && !inside) {
      Vector3d hit = begin + t * way;
      hit[axis] = v[axis] + (step < 0);
      return Spot{field.grid().origin + field.grid().spacing * (hit - Vector3d::Constant(0.5)),
                  -double(step) * Vector3d::Unit(axis)};
    }
    inside = entered;
  }
}

std::optional<Spot> closest_voxel_face(const VoxelField& field, const Vector3d& p_O, double reach) {
  if (!p_O.allFinite() || !(reach >= 0)) return std::nullopt;
  const Vector3d x = in_voxels(field, p_O), size = field.grid().size.cast<double>();
  const Vector3d inner = x.cwiseMax(0).cwiseMin(size);
  const Vector3i home = voxel_at(inner);
  const double limit = reach / field.grid().spacing, outside = (x - inner).squaredNorm();
  double best = limit * limit;
  Spot spot;
  bool found = false;
  // Cube shells around p's voxel, or the grid's nearest to it: what lies in shell r is farther than r − 1 voxels from
  // there, and the grid is convex.
  const int shells = int(std::ceil(std::min(limit, size.maxCoeff()))) + 1;
  for (int r = 0; r <= shells; ++r) {
    if (best < outside || (r > 0 && best < outside + double(r - 1) * (r - 1))) break;
    for (int k = -r; k <= r; ++k)
      for (int j = -r; j <= r; ++j) {
        const bool rim = std::abs(k) == r || std::abs(j) == r;
        for (int i = -r; i <= r; i += (rim || r == 0) ? 1 : 2 * r) {
          const Vector3i v = home + Vector3i(i, j, k);
          if (!full(field, v)) continue;
          const double before = best;
          nearest_face(field, x, v, best, spot);
          found |= best < before;
        }
      }
  }
  if (!found) return std::nullopt;
  return spot;
}

}  // namespace handhold::realtime::paper
