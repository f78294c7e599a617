// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/simbody_load.hpp"

#include <stdexcept>

namespace handhold::reference::rigid::simbody {

LoadForce::LoadForce(Phase& phase, const SimTK::GeneralForceSubsystem& forces, const SimTK::MobilizedBody& body,
                     const Reactions& reactions)
    : phase_(phase), forces_(forces), body_(body), reactions_(reactions) {}

void LoadForce::realizeTopology(SimTK::State& state) const {
  first_z_ = forces_.allocateZ(state, SimTK::Vector(2, 0.0));
}

Motion LoadForce::motion(const SimTK::State& state) const {
  return motion_of(body_.getBodyTransform(state), body_.getBodyVelocity(state));
}

Load LoadForce::applied(const SimTK::State& state) const {
  if (!phase_.problem.load) return {};
  const Motion m = motion(state);
  return phase_.problem.load(state.getTime(), {{Eigen::Quaterniond(m.R), m.p}, {m.w, m.v}});
}

void LoadForce::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                          SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const {
  const RigidProblem& problem = phase_.problem;
  const double t = state.getTime();
  const Motion m = motion(state);
  const Load load = applied(state);
  SimTK::SpatialVec total(to_simbody(load.torque_W), to_simbody(load.force_W + problem.mass * problem.gravity));
  for (const RigidSpring& s : problem.springs) {
    const Eigen::Vector3d arm = m.R * s.point_B;
    total += spatial_force(arm, s.stiffness * (s.anchor_W + at(s.motion, t).p - m.p - arm));
  }
  for (std::size_t i = 0; i < problem.supports.size(); ++i) {
    const RigidSupport& support = problem.supports[i];
    if (!support.normal_force || phase_.modes[i].mode == Mode::apart) continue;
    const ContactPoint c = contact_point(support, t, m);
    Eigen::Vector3d direction = c.normal;
    if (phase_.modes[i].mode == Mode::slip)
      direction -= support.friction.mu_dynamic * slip_direction(phase_.modes[i], c, phase_.slow);
    total += spatial_force(c.arm, support.normal_force(t) * direction);
  }
  if (!to_eigen(total[0]).allFinite() || !to_eigen(total[1]).allFinite()) {
    phase_.failure = "a load, spring path or normal force is not finite at t = " + std::to_string(t) + " s";
    throw std::domain_error(phase_.failure);
  }
  body_forces[body_.getMobilizedBodyIndex()] += total;
}

void LoadForce::realizeAcceleration(const SimTK::State& state) const {
  const RigidProblem& problem = phase_.problem;
  const Motion m = motion(state);
  const Load load = applied(state);
  double dissipation = 0;
  double power = load.force_W.dot(m.v) + load.torque_W.dot(m.w);
  for (const RigidSpring& s : problem.springs) {
    const PathPoint anchor = at(s.motion, state.getTime());
    power += s.stiffness * (s.anchor_W + anchor.p - m.p - m.R * s.point_B).dot(anchor.v);
  }
  const std::vector<Reaction> reactions = reactions_(state);
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    const Reaction& r = reactions[i];
    const Eigen::Vector3d force = r.normal_force * r.point.normal + r.friction;
    power += force.dot(r.point.surface_velocity);
    if (problem.supports[i].normal_force) power += r.normal_force * r.point.normal.dot(r.point.velocity);
    if (phase_.modes[i].mode == Mode::slip) dissipation -= r.friction.dot(r.point.slip);
  }
  SimTK::Vector& z_dot = forces_.updZDot(state);
  z_dot[first_z_] = dissipation;
  z_dot[first_z_ + 1] = power;
}

Work LoadForce::work(const SimTK::State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  return {z[first_z_], z[first_z_ + 1]};
}

void LoadForce::set_work(SimTK::State& state, const Work& work) const {
  SimTK::Vector& z = forces_.updZ(state);
  z[first_z_] = work.dissipated;
  z[first_z_ + 1] = work.outside;
}

double LoadForce::spring_energy(const SimTK::State& state) const {
  const Motion m = motion(state);
  double energy = 0;
  for (const RigidSpring& s : phase_.problem.springs) {
    const Eigen::Vector3d stretch = s.anchor_W + at(s.motion, state.getTime()).p - m.p - m.R * s.point_B;
    energy += 0.5 * s.stiffness * stretch.squaredNorm();
  }
  return energy;
}

}  // namespace handhold::reference::rigid::simbody
