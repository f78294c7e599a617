// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/modes.hpp"

namespace handhold::reference::rigid {

Eigen::Vector3d slip_direction(const Contact& contact, const ContactPoint& point, double slow) {
  const double speed = point.slip.norm();
  if (speed > slow) return (point.slip.dot(contact.held) < 0 ? -1 : 1) / speed * point.slip;
  const Eigen::Vector3d level = contact.held - point.normal * point.normal.dot(contact.held);
  return level.isZero(0) ? level : Eigen::Vector3d(level.normalized());
}

double cone_margin(const RigidSupport& support, const Reaction& reaction) {
  return support.friction.mu_static * reaction.normal_force - reaction.friction.norm();
}

}  // namespace handhold::reference::rigid
