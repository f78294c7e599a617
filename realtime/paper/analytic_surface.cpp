// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "realtime/paper/surface.hpp"

namespace handhold::realtime::paper {
namespace {

using Eigen::Vector3d;

/// Crossing of the plane x[axis] = at by the way from `from` to `to`, from outside (sign·x > sign·at) inwards.
std::optional<Spot> cross(const Vector3d& from, const Vector3d& to, int axis, double at, double sign) {
  const double before = sign * (from[axis] - at), after = sign * (to[axis] - at);
  if (before < 0 || after > 0 || before == after) return std::nullopt;
  Spot spot;
  // From the nearer end, so that what is left of a lag is not rounding.
  const double way = before - after;
  spot.C_O = before < way / 2 ? Vector3d(from + before / way * (to - from)) : Vector3d(to + after / way * (to - from));
  spot.C_O[axis] = at;
  spot.n_O = sign * Vector3d::Unit(axis);
  return spot;
}

std::optional<Spot> foot(const Vector3d& p, int axis, double at, double sign, double reach) {
  if (!(std::abs(p[axis] - at) <= reach)) return std::nullopt;
  Spot spot{p, sign * Vector3d::Unit(axis)};
  spot.C_O[axis] = at;
  return spot;
}

}  // namespace

std::optional<Spot> PlaneSurface::cast(const Vector3d& from_O, const Vector3d& to_O) const {
  return cross(from_O, to_O, 2, height_, 1);
}

std::optional<Spot> PlaneSurface::closest(const Vector3d& p_O, double reach) const {
  return foot(p_O, 2, height_, 1, reach);
}

std::optional<Spot> SlabSurface::cast(const Vector3d& from_O, const Vector3d& to_O) const {
  return cross(from_O, to_O, 0, std::copysign(half_, from_O.x()), std::copysign(1.0, from_O.x()));
}

std::optional<Spot> SlabSurface::closest(const Vector3d& p_O, double reach) const {
  return foot(p_O, 0, std::copysign(half_, p_O.x()), std::copysign(1.0, p_O.x()), reach);
}

std::optional<Spot> SphereSurface::cast(const Vector3d& from_O, const Vector3d& to_O) const {
  const Vector3d way = to_O - from_O;
  const double a = way.squaredNorm(), b = from_O.dot(way), c = from_O.squaredNorm() - radius_ * radius_;
  const double discriminant = b * b - a * c;
  if (!(a > 0) || c < 0 || b >= 0 || discriminant < 0) return std::nullopt;
  const double t = c / (-b + std::sqrt(discriminant));  // the nearer root, without cancellation
  if (t > 1) return std::nullopt;
  const Vector3d C = from_O + t * way;
  return Spot{C, C.normalized()};
}

std::optional<Spot> SphereSurface::closest(const Vector3d& p_O, double reach) const {
  const double r = p_O.norm();
  if (!(std::abs(r - radius_) <= reach)) return std::nullopt;
  const Vector3d n = r > 0 ? Vector3d(p_O / r) : Vector3d(Vector3d::UnitZ());
  return Spot{radius_ * n, n};
}

}  // namespace handhold::realtime::paper
