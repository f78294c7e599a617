#include "realtime/proximity.hpp"

#include <algorithm>
#include <variant>

namespace handhold::realtime {
namespace {

double reach_of(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

}  // namespace

Proximity::Proximity(const PhalanxShape& shape) : shape_(shape), reach_(reach_of(shape)) {}

Proximity::Verdict Proximity::update(const VoxelField& field, const Pose& X_OP, bool active, double offset) {
  if (field.bounds().exteriorDistance(X_OP.p) > reach_ + 2 * offset) return active ? Verdict::far : Verdict::same;
  if (known_) {  // no point of the shape can have moved farther than this
    const double moved = (X_OP.p - X_OP_.p).norm() + reach_ * X_OP.R.angularDistance(X_OP_.R);
    const bool settled = active ? place_.distance + moved <= 2 * offset : place_.distance - moved >= offset;
    if (settled) return Verdict::same;
  }
  place_ = nearest(shape_, X_OP, field);
  X_OP_ = X_OP;
  known_ = true;
  if (active) return place_.distance > 2 * offset ? Verdict::far : Verdict::same;
  // Beyond its reach `nearest` gives a bound and no place.
  return place_.distance < std::min(offset, nearest_reach) ? Verdict::near : Verdict::same;
}

}  // namespace handhold::realtime
