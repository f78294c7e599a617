// SPDX-License-Identifier: Apache-2.0
#include "realtime/detection/proximity.hpp"

#include <algorithm>
#include <variant>

namespace handhold::realtime {
namespace {

constexpr int most_advances = 64;
constexpr double least_advance = 1e-5;  // [m]

double reach_of(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

/// `fraction` of the straight way from X to Y.
Pose between(const Pose& X, const Pose& Y, double fraction) {
  if (fraction <= 0) return X;
  if (fraction >= 1) return Y;
  return {X.R.slerp(fraction, Y.R), X.p + fraction * (Y.p - X.p)};
}

}  // namespace

Proximity::Proximity(const PhalanxShape& shape) : shape_(shape), reach_(reach_of(shape)) {}

double Proximity::motion(const Pose& X, const Pose& Y) const {
  // The arc is the angle times the reach; |q1 − q2| = 2 sin(angle / 4) and the angle is at most π, so that the angle is
  // at most 2 · 1.111 of it.
  const double same = (X.R.coeffs() - Y.R.coeffs()).norm(), opposite = (X.R.coeffs() + Y.R.coeffs()).norm();
  return (X.p - Y.p).norm() + 2.23 * reach_ * std::min(same, opposite);
}

double Proximity::measure(const VoxelField& field, const Pose& X_OP) {
  place_ = nearest(shape_, X_OP, field);
  X_OP_ = X_OP;
  known_ = true;
  return place_.distance;
}

std::optional<Pose> Proximity::approach(const VoxelField& field, const Pose& X_OP, const Pose& Y_OP, double offset) {
  const double way = motion(X_OP, Y_OP);
  if (field.bounds().exteriorDistance(X_OP.p) > reach_ + offset + way) return std::nullopt;
  double distance = known_ ? place_.distance - motion(X_OP_, X_OP) : 0;
  if (distance - way >= offset) return std::nullopt;
  // Beyond its reach `nearest` gives a bound and no place.
  const double near = std::min(offset, nearest_reach);
  // How far the bound reaches is no business of the place that is found.
  const double most = std::max(5 * offset, way / (most_advances / 2));
  double fraction = 0;
  for (int i = 0; i < most_advances; ++i) {
    const Pose X = between(X_OP, Y_OP, fraction);
    distance = measure(field, X);
    if (distance < near) return X;
    if (fraction >= 1 || distance - (1 - fraction) * way >= offset) return std::nullopt;
    // To where it may be as near as half the offset: the place found there is outside, unless the way ends inside.
    fraction = std::min(1.0, fraction + std::max(std::min(distance, most) - 0.5 * near, least_advance) / way);
  }
  return std::nullopt;
}

bool Proximity::leaves(const VoxelField& field, const Pose& X_OP, double limit) {
  if (field.bounds().exteriorDistance(X_OP.p) > reach_ + limit) return true;
  if (known_ && place_.distance + motion(X_OP_, X_OP) <= limit) return false;
  return measure(field, X_OP) > limit;
}

}  // namespace handhold::realtime
