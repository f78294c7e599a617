// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/body_forces.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/model/defect.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

Wrench at_center(const Vector3d& force, const Vector3d& torque, const Vector3d& arm) {
  return {force, arm.cross(force) + torque};
}

double power(const Wrench& wrench, const Motion& m) { return wrench.force.dot(m.v) + wrench.torque.dot(m.w); }

void add(const Wrench& wrench, Applied& sum) {
  sum.wrench.force += wrench.force;
  sum.wrench.torque += wrench.torque;
}

/// Thick oil.
Wrench oil(const Inertia& inertia, const Motion& m, const Vector3d& arm) {
  const Vector3d v = m.v + m.w.cross(arm);  // of the centre of mass
  const Vector3d angular_momentum = m.R * (inertia.about_center * (m.R.transpose() * m.w));
  return at_center(-inertia.mass / support_time * v,
                   -DEFECT(reference_support_turns_freely, 1.0, 0.0) * angular_momentum / support_time, arm);
}

}  // namespace

Applied applied_to(const Body& body, const Vector3d& gravity, const Motion& motion, bool held, double t) {
  Applied applied;
  if (body.mobility == Mobility::fixed) return applied;
  const Vector3d arm = motion.R * body.inertia.center;
  const Wrench weight = at_center(body.inertia.mass * gravity, Vector3d::Zero(), arm);
  if (held) {
    const Wrench resistance = oil(body.inertia, motion, arm);
    add(resistance, applied);
    applied.dissipation = -power(resistance, motion);
    applied.given = -power(weight, motion);  // the weight's potential is in the energy book
  } else {
    add(weight, applied);
  }
  if (!body.load) return applied;
  const Load load = body.load(t);
  if (!load.force_W.allFinite() || !load.torque_W.allFinite())
    throw InputError(
        fmt::format("body '{}': its load at t = {:.9g} s: must be finite (correct Body::load)", body.name, t));
  const Wrench given = at_center(load.force_W, load.torque_W, arm);
  add(given, applied);
  applied.given += power(given, motion);
  return applied;
}

}  // namespace handhold::reference
