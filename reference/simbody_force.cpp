#include "reference/simbody_force.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace handhold::reference::simbody {
namespace {

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d to_eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d to_eigen(const SimTK::Rotation& R) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = R.asMat33()(i, j);
  return out;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const ModesVariable& variable) {
  return out << "modes, revision " << variable.revision;
}

ContactForce::ContactForce(const Scene& scene, Contacts& contacts, const SimTK::GeneralForceSubsystem& forces,
                           const SimTK::MobilizedBody& body)
    : scene_(scene), contacts_(contacts), forces_(forces), body_(body) {}

void ContactForce::realizeTopology(SimTK::State& state) const {
  first_z_ = forces_.allocateZ(state, SimTK::Vector(3 * contacts_.slots() + 2, 0.0));
  modes_index_ = forces_.allocateDiscreteVariable(state, SimTK::Stage::Position, new SimTK::Value<ModesVariable>());
}

const ModesVariable& ContactForce::variable(const SimTK::State& state) const {
  return SimTK::Value<ModesVariable>::downcast(forces_.getDiscreteVariable(state, modes_index_)).get();
}

const Modes& ContactForce::modes(const SimTK::State& state) const { return variable(state).modes; }

Anchors ContactForce::anchors(const SimTK::State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  Anchors anchors(3, contacts_.slots());
  for (int i = 0; i < 3 * contacts_.slots(); ++i) anchors.data()[i] = z[first_z_ + i];
  return anchors;
}

Work ContactForce::work(const SimTK::State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  const int i = first_z_ + 3 * contacts_.slots();
  return {z[i], z[i + 1]};
}

BodyMotion ContactForce::motion(const SimTK::State& state) const {
  const SimTK::Transform& X = body_.getBodyTransform(state);
  const SimTK::SpatialVec& V = body_.getBodyVelocity(state);
  return {to_eigen(X.R()), to_eigen(X.p()), to_eigen(V[0]), to_eigen(V[1])};
}

void ContactForce::set(SimTK::State& state, const Modes& modes, const Anchors& anchors, const Work& work) const {
  ModesVariable& variable =
      SimTK::Value<ModesVariable>::updDowncast(forces_.updDiscreteVariable(state, modes_index_)).upd();
  variable.modes = modes;
  ++variable.revision;
  SimTK::Vector& z = forces_.updZ(state);
  const int n = 3 * contacts_.slots();
  for (int i = 0; i < n; ++i) z[first_z_ + i] = anchors.data()[i];
  z[first_z_ + n] = work.dissipated;
  z[first_z_ + n + 1] = work.hand;
}

const Evaluation& ContactForce::evaluate(const SimTK::State& state) const {
  const SimTK::Vector& y = state.getY();
  const double* values = y.size() > 0 ? &y[0] : nullptr;
  const long revision = variable(state).revision;
  Memory& m = memory_;
  const bool known = m.revision == revision && m.t == state.getTime() && int(m.y.size()) == y.size() &&
                     std::equal(m.y.begin(), m.y.end(), values);
  if (known) return m.evaluation;
  m.revision = -1;  // should the evaluation throw
  contacts_.evaluate(state.getTime(), motion(state), modes(state), anchors(state), m.evaluation);
  m.t = state.getTime();
  m.y.assign(values, values + y.size());
  m.revision = revision;
  return m.evaluation;
}

const Evaluation& ContactForce::checked(const SimTK::State& state) const {
  const Evaluation& e = evaluate(state);
  if (e.singular_slot < 0) return e;
  failure_ = contacts_.describe(e.singular_slot) +
             ": undamped slip round an edge sharper than its depth has no solution (give the contact damping)";
  throw std::domain_error(failure_);
}

void ContactForce::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                             SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const {
  const Evaluation& e = checked(state);
  const Body& body = scene_.bodies.front();
  if (body.mobility == Mobility::fixed) return;  // a body at rest stays to the last bit
  const Wrench other = modes(state).held ? support(state) : weight(state);
  const Eigen::Vector3d force = e.force_W + other.force;
  const Eigen::Vector3d torque = e.torque_W + other.torque;
  body_forces[body_.getMobilizedBodyIndex()] += SimTK::SpatialVec(to_simbody(torque), to_simbody(force));
}

Eigen::Vector3d ContactForce::arm(const SimTK::State& state) const {
  return to_eigen(body_.getBodyRotation(state)) * scene_.bodies.front().inertia.center;
}

ContactForce::Wrench ContactForce::weight(const SimTK::State& state) const {
  const Eigen::Vector3d force = scene_.bodies.front().inertia.mass * scene_.gravity;
  return {force, arm(state).cross(force)};
}

/// Thick oil; the weight is carried.
ContactForce::Wrench ContactForce::support(const SimTK::State& state) const {
  const Inertia& inertia = scene_.bodies.front().inertia;
  const BodyMotion m = motion(state);
  const Eigen::Vector3d v = m.v_WO + m.w_WO.cross(arm(state));  // of the centre of mass
  const Eigen::Vector3d force = -inertia.mass / support_time * v;
  const Eigen::Vector3d spin = m.R_WO * (inertia.about_center * (m.R_WO.transpose() * m.w_WO));
  return {force, arm(state).cross(force) - spin / support_time};
}

/// Power that the oil takes, and that the carrier of the weight gives [W].
Work ContactForce::support_power(const SimTK::State& state) const {
  if (!modes(state).held || scene_.bodies.front().mobility == Mobility::fixed) return {};
  const BodyMotion m = motion(state);
  const Wrench oil = support(state), carried = weight(state);
  return {-oil.force.dot(m.v_WO) - oil.torque.dot(m.w_WO), -carried.force.dot(m.v_WO) - carried.torque.dot(m.w_WO)};
}

void ContactForce::realizeAcceleration(const SimTK::State& state) const {
  const Evaluation& e = checked(state);
  SimTK::Vector& z_dot = forces_.updZDot(state);
  int i = first_z_;
  for (const Sample& s : e.samples)
    for (int axis = 0; axis < 3; ++axis) z_dot[i++] = s.response.anchor_rate[axis];
  const Work support = support_power(state);
  z_dot[i++] = e.dissipation + support.dissipated;
  z_dot[i++] = e.hand_power + support.hand;
}

Witness::Witness(const ContactForce& force, Kind kind, int index, double time_window)
    : SimTK::TriggeredEventHandler(SimTK::Stage::Velocity), force_(force), kind_(kind), index_(std::size_t(index)) {
  getTriggerInfo().setTriggerOnRisingSignTransition(true);
  getTriggerInfo().setTriggerOnFallingSignTransition(false);
  getTriggerInfo().setRequiredLocalizationTimeWindow(time_window);
}

SimTK::Real Witness::getValue(const SimTK::State& state) const {
  const Evaluation& e = force_.evaluate(state);
  double value = 0;
  if (kind_ == Kind::gap) value = e.samples[index_].gap;
  if (kind_ == Kind::friction) value = e.samples[index_].friction;
  if (kind_ == Kind::nearness) value = e.nearness[index_];
  // A witness that starts at exactly 0 would never fire: Simbody looks for changes of sign.
  return value == 0 ? -std::numeric_limits<double>::min() : value;
}

}  // namespace handhold::reference::simbody
