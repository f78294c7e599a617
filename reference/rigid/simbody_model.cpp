// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/simbody_model.hpp"

namespace handhold::reference::rigid::simbody {
namespace {

SimTK::MobilizedBody make_body(SimTK::SimbodyMatterSubsystem& matter, const RigidProblem& p) {
  const Eigen::Matrix3d& J = p.inertia;
  const SimTK::Inertia inertia(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
  const SimTK::Body::Rigid solid(SimTK::MassProperties(p.mass, SimTK::Vec3(0), inertia));
  if (p.mobility == Mobility::free)
    return SimTK::MobilizedBody::Free(matter.Ground(), SimTK::Transform(), solid, SimTK::Transform());
  // Outboard frame turned back, so that the coordinates are W's.
  const SimTK::Transform turned(~to_simbody(p.X_WB.R));
  return SimTK::MobilizedBody::Translation(matter.Ground(), SimTK::Transform(), solid, turned);
}

void enable(SimTK::State& state, const SimTK::Constraint& constraint, bool wanted) {
  if (constraint.isEmptyHandle() || wanted != constraint.isDisabled(state)) return;
  wanted ? constraint.enable(state) : constraint.disable(state);
}

}  // namespace

Model::Model(const RigidProblem& problem, double slow)
    : phase_{problem, Modes(problem.supports.size()), slow, {}}, body_(make_body(matter_, problem)) {
  using Kind = SupportConstraint::Kind;
  SimTK::MobilizedBody ground = matter_.Ground();
  for (std::size_t i = 0; i < problem.supports.size(); ++i) {
    Constraints c;
    const bool pressed = bool(problem.supports[i].normal_force);
    const auto add = [&](Kind kind, SupportConstraint*& implementation) {
      implementation = new SupportConstraint(kind, phase_, i, ground, body_);
      SimTK::Constraint::Custom handle(implementation);
      handle.setDisabledByDefault(true);
      return handle;
    };
    if (!pressed) c.slide = add(Kind::slide, c.sliding);
    c.stick = add(pressed ? Kind::grip : Kind::hold, c.sticking);
    constraints_.push_back(c);
  }
  load_ = new LoadForce(phase_, forces_, body_, [this](const SimTK::State& state) { return forces(state); });
  SimTK::Force::Custom(forces_, load_);
}

SimTK::State Model::start() {
  const RigidProblem& p = phase_.problem;
  SimTK::State state = system_.realizeTopology();
  system_.realizeModel(state);
  body_.setQToFitTransform(state, SimTK::Transform(to_simbody(p.X_WB.R), to_simbody(p.X_WB.p)));
  body_.setUToFitVelocity(state, SimTK::SpatialVec(to_simbody(p.V_WB.w), to_simbody(p.V_WB.v)));
  return state;
}

void Model::set_modes(SimTK::State& state, const Modes& modes) {
  phase_.modes = modes;
  const SimTK::Vector y = state.getY();
  for (std::size_t i = 0; i < modes.size(); ++i) {
    enable(state, constraints_[i].slide, modes[i].mode == Mode::slip);
    enable(state, constraints_[i].stick, modes[i].mode == Mode::stick);
  }
  system_.realizeModel(state);
  state.updY() = y;
  state.invalidateAllCacheAtOrAbove(SimTK::Stage::Instance);  // a held direction is no part of the state
}

Motion Model::motion(const SimTK::State& state) const {
  system_.realize(state, SimTK::Stage::Velocity);
  return motion_of(body_.getBodyTransform(state), body_.getBodyVelocity(state));
}

BodyState Model::body(const SimTK::State& state) const {
  const Motion m = motion(state);
  return {{Eigen::Quaterniond(m.R), m.p}, {m.w, m.v}};
}

void Model::set_motion(SimTK::State& state, const Motion& motion) const {
  system_.realize(state, SimTK::Stage::Position);
  body_.setQToFitTranslation(state, to_simbody(motion.p));
  system_.realize(state, SimTK::Stage::Position);
  body_.setUToFitVelocity(state, SimTK::SpatialVec(to_simbody(motion.w), to_simbody(motion.v)));
}

std::vector<ContactPoint> Model::points(const SimTK::State& state) const {
  const Motion m = motion(state);
  std::vector<ContactPoint> all;
  for (const RigidSupport& s : phase_.problem.supports) all.push_back(contact_point(s, state.getTime(), m));
  return all;
}

/// Once the multipliers are known; accelerations are left out.
std::vector<Reaction> Model::forces(const SimTK::State& state) const {
  const Motion m = motion_of(body_.getBodyTransform(state), body_.getBodyVelocity(state));
  std::vector<Reaction> all;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const RigidSupport& support = phase_.problem.supports[i];
    const Contact& contact = phase_.modes[i];
    const ContactPoint point = contact_point(support, state.getTime(), m);
    Reaction r;
    if (contact.mode == Mode::stick)
      r = constraints_[i].sticking->forces(constraints_[i].stick.getMultipliersAsVector(state), point);
    if (contact.mode == Mode::slip && !support.normal_force)
      r = constraints_[i].sliding->forces(constraints_[i].slide.getMultipliersAsVector(state), point);
    if (contact.mode != Mode::apart && support.normal_force) r.normal_force = support.normal_force(state.getTime());
    if (contact.mode == Mode::slip && support.normal_force)
      r.friction = -support.friction.mu_dynamic * r.normal_force * slip_direction(contact, point, phase_.slow);
    r.point = point;
    all.push_back(r);
  }
  return all;
}

std::vector<Reaction> Model::reactions(const SimTK::State& state) const {
  system_.realize(state, SimTK::Stage::Acceleration);
  std::vector<Reaction> all = forces(state);
  const Motion m = motion(state);
  const SimTK::SpatialVec& A = body_.getBodyAcceleration(state);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].rates = contact_rates(phase_.problem.supports[i], state.getTime(), m, to_eigen(A[1]), to_eigen(A[0]));
  return all;
}

double Model::kinetic_energy(const Motion& m) const {
  const Eigen::Vector3d w_B = m.R.transpose() * m.w;
  return 0.5 * phase_.problem.mass * m.v.squaredNorm() + 0.5 * w_B.dot(phase_.problem.inertia * w_B);
}

Frame Model::frame(const SimTK::State& state) const {
  const RigidProblem& problem = phase_.problem;
  Frame frame;
  frame.t = state.getTime();
  frame.body = body(state);
  const std::vector<Reaction> all = reactions(state);
  for (std::size_t i = 0; i < all.size(); ++i)
    frame.supports.push_back(
        {phase_.modes[i].mode, all[i].point.gap, all[i].normal_force, all[i].friction, all[i].point.slip});
  const Work work = load_->work(state);
  const Motion m = motion(state);
  frame.energy = {kinetic_energy(m), -problem.mass * problem.gravity.dot(m.p), load_->spring_energy(state),
                  work.dissipated, work.outside};
  return frame;
}

}  // namespace handhold::reference::rigid::simbody
