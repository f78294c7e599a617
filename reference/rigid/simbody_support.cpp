// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/simbody_support.hpp"

#include "reference/rigid/rigid.hpp"

namespace handhold::reference::rigid::simbody {
namespace {

using Kind = SupportConstraint::Kind;

int position_equations(Kind kind) { return kind == Kind::grip ? 0 : 1; }
int velocity_equations(Kind kind) { return kind == Kind::slide ? 0 : 2; }

}  // namespace

// Ground is constrained too, so that the common ancestor, whose frame everything is expressed in, is Ground and not the
// body itself.
SupportConstraint::SupportConstraint(Kind kind, const Phase& phase, std::size_t index, SimTK::MobilizedBody& ground,
                                     SimTK::MobilizedBody& body)
    : Implementation(body.updMatterSubsystem(), position_equations(kind), velocity_equations(kind), 0),
      kind_(kind),
      phase_(phase),
      index_(index) {
  ground_ = addConstrainedBody(ground);
  body_ = addConstrainedBody(body);
}

ContactPoint SupportConstraint::point(const SimTK::State& state, const SimTK::SpatialVec& V) const {
  return contact_point(support(), state.getTime(), motion_of(getBodyTransformFromState(state, body_), V));
}

ContactPoint SupportConstraint::point_at_rest(const SimTK::State& state) const {
  return point(state, SimTK::SpatialVec(SimTK::Vec3(0)));
}

void SupportConstraint::calcPositionErrors(const SimTK::State& state,
                                           const SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>& X_AB,
                                           const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                           SimTK::Array_<SimTK::Real>& errors) const {
  const Motion body = motion_of(getBodyTransform(X_AB, body_), SimTK::SpatialVec(SimTK::Vec3(0)));
  errors[0] = contact_point(support(), state.getTime(), body).gap;
}

void SupportConstraint::calcPositionDotErrors(const SimTK::State& state,
                                              const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V_AB,
                                              const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                              SimTK::Array_<SimTK::Real>& errors) const {
  errors[0] = point(state, getBodyVelocity(V_AB, body_)).gap_rate;
}

void SupportConstraint::calcPositionDotDotErrors(
    const SimTK::State& state, const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A_AB,
    const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&, SimTK::Array_<SimTK::Real>& errors) const {
  const SimTK::SpatialVec& A = getBodyAcceleration(A_AB, body_);
  const SimTK::SpatialVec& V = getBodyVelocityFromState(state, body_);
  const Motion body = motion_of(getBodyTransformFromState(state, body_), V);
  const ContactRates rates = contact_rates(support(), state.getTime(), body, to_eigen(A[1]), to_eigen(A[0]));
  const ContactPoint c = point(state, V);
  errors[0] = rates.gap_acceleration + 2 * recovery * c.gap_rate + recovery * recovery * c.gap;
}

void SupportConstraint::addInPositionConstraintForces(
    const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
    SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& forces,
    SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&) const {
  // Before stage Dynamics, Simbody asks for the gradient of the equation (to project), not for forces.
  const bool rubs = kind_ == Kind::slide && state.getSystemStage() >= SimTK::Stage::Dynamics;
  const ContactPoint c = rubs ? point(state, getBodyVelocityFromState(state, body_)) : point_at_rest(state);
  Eigen::Vector3d direction = c.normal;
  if (rubs) direction -= support().friction.mu_dynamic * slip_direction(phase_.modes[index_], c, phase_.slow);
  forces[body_] += spatial_force(c.arm, multipliers[0] * direction);
}

void SupportConstraint::calcVelocityErrors(const SimTK::State& state,
                                           const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V_AB,
                                           const SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&,
                                           SimTK::Array_<SimTK::Real>& errors) const {
  const ContactPoint c = point(state, getBodyVelocity(V_AB, body_));
  const Tangents t = tangents(c.normal);
  errors[0] = t.a.dot(c.velocity);
  errors[1] = t.b.dot(c.velocity);
}

// The tangents turn with the normal, but where the equations hold u is zero, and so is what their turning would add.
void SupportConstraint::calcVelocityDotErrors(const SimTK::State& state,
                                              const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A_AB,
                                              const SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&,
                                              SimTK::Array_<SimTK::Real>& errors) const {
  const SimTK::SpatialVec& A = getBodyAcceleration(A_AB, body_);
  const SimTK::SpatialVec& V = getBodyVelocityFromState(state, body_);
  const Motion body = motion_of(getBodyTransformFromState(state, body_), V);
  const ContactRates rates = contact_rates(support(), state.getTime(), body, to_eigen(A[1]), to_eigen(A[0]));
  const ContactPoint c = point(state, V);
  const Tangents t = tangents(c.normal);
  errors[0] = t.a.dot(rates.acceleration + recovery * c.velocity);
  errors[1] = t.b.dot(rates.acceleration + recovery * c.velocity);
}

void SupportConstraint::addInVelocityConstraintForces(
    const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
    SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& forces,
    SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&) const {
  const ContactPoint c = point_at_rest(state);
  const Tangents t = tangents(c.normal);
  forces[body_] += spatial_force(c.arm, multipliers[0] * t.a + multipliers[1] * t.b);
}

Reaction SupportConstraint::forces(const SimTK::Vector& multipliers, const ContactPoint& point) const {
  Reaction r;
  const int first = position_equations(kind_);
  if (first == 1) r.normal_force = -multipliers[0];
  if (kind_ == Kind::slide) {
    r.friction =
        -support().friction.mu_dynamic * r.normal_force * slip_direction(phase_.modes[index_], point, phase_.slow);
    return r;
  }
  const Tangents t = tangents(point.normal);
  r.friction = -multipliers[first] * t.a - multipliers[first + 1] * t.b;
  return r;
}

}  // namespace handhold::reference::rigid::simbody
