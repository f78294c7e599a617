// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/simbody_force.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

namespace handhold::reference::simbody {

std::ostream& operator<<(std::ostream& out, const ModesVariable& variable) {
  return out << "modes, revision " << variable.revision;
}

ContactForce::ContactForce(const Scene& scene, Contacts& contacts, const Bodies& bodies,
                           const SimTK::GeneralForceSubsystem& forces)
    : scene_(scene), contacts_(contacts), bodies_(bodies), forces_(forces) {}

void ContactForce::realizeTopology(SimTK::State& state) const {
  first_z_ = forces_.allocateZ(state, SimTK::Vector(3 * contacts_.slots() + 2, 0.0));
  modes_index_ = forces_.allocateDiscreteVariable(state, SimTK::Stage::Position, new SimTK::Value<ModesVariable>());
}

const ModesVariable& ContactForce::variable(const SimTK::State& state) const {
  return SimTK::Value<ModesVariable>::downcast(forces_.getDiscreteVariable(state, modes_index_)).get();
}

const Modes& ContactForce::modes(const SimTK::State& state) const { return *variable(state).modes; }

/// The auxiliary states of the subsystem are one piece of memory.
Eigen::Map<const Anchors> ContactForce::anchors(const SimTK::State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  return Eigen::Map<const Anchors>(&z[first_z_], 3, contacts_.slots());
}

Work ContactForce::work(const SimTK::State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  const int i = first_z_ + 3 * contacts_.slots();
  return {z[i], z[i + 1]};
}

void ContactForce::set(SimTK::State& state, Modes modes, const Anchors& anchors, const Work& work) const {
  ModesVariable& variable =
      SimTK::Value<ModesVariable>::updDowncast(forces_.updDiscreteVariable(state, modes_index_)).upd();
  variable.modes = std::make_shared<const Modes>(std::move(modes));
  ++variable.revision;
  SimTK::Vector& z = forces_.updZ(state);
  const int n = 3 * contacts_.slots();
  for (int i = 0; i < n; ++i) z[first_z_ + i] = anchors.data()[i];
  z[first_z_ + n] = work.dissipated;
  z[first_z_ + n + 1] = work.hand;
}

bool ContactForce::remembers(const SimTK::State& state) const {
  const SimTK::Vector& y = state.getY();  // never empty: there are the two integrals
  return memory_.revision == variable(state).revision && memory_.t == state.getTime() &&
         int(memory_.y.size()) == y.size() &&
         std::memcmp(memory_.y.data(), &y[0], memory_.y.size() * sizeof(double)) == 0;
}

const Instant& ContactForce::evaluate(const SimTK::State& state) const {
  Memory& m = memory_;
  if (remembers(state)) return m.instant;
  m.revision = -1;  // should the evaluation throw
  try {
    compute(state, m.instant);
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
  const SimTK::Vector& y = state.getY();
  m.t = state.getTime();
  m.y.assign(&y[0], &y[0] + y.size());
  m.revision = variable(state).revision;
  return m.instant;
}

void ContactForce::compute(const SimTK::State& state, Instant& out) const {
  const double t = state.getTime();
  const Modes& now = modes(state);
  bodies_.read_motions(state, out.motions);
  contacts_.evaluate(t, out.motions, now, anchors(state), out.contacts);
  out.wrench = out.contacts.wrench;
  out.dissipation = out.contacts.dissipation;
  out.given = out.contacts.hand_power;
  for (std::size_t i = 0; i < out.wrench.size(); ++i) {
    const Applied applied = applied_to(scene_.bodies[i], scene_.gravity, out.motions[i], now.held[i], t);
    out.wrench[i].force += applied.wrench.force;
    out.wrench[i].torque += applied.wrench.torque;
    out.dissipation += applied.dissipation;
    out.given += applied.given;
  }
}

const Instant& ContactForce::watch(const SimTK::State& state) const {
  const Instant& instant = evaluate(state);
  if (!instant.contacts.watched)
    contacts_.watch(state.getTime(), instant.motions, modes(state), anchors(state), memory_.instant.contacts);
  return instant;
}

const Instant& ContactForce::checked(const SimTK::State& state) const {
  const Instant& instant = evaluate(state);
  const int slot = instant.contacts.singular_slot;
  if (slot < 0) return instant;
  const CannotAdvance error(contacts_.describe(slot) +
                            ": undamped slip round an edge sharper than its depth has no solution (give the contact "
                            "damping)");
  failure_ = std::make_exception_ptr(error);
  throw error;
}

void ContactForce::calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                             SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const {
  const Instant& instant = checked(state);
  for (int i = 0; i < int(instant.wrench.size()); ++i) bodies_.apply(i, instant.wrench[std::size_t(i)], body_forces);
}

void ContactForce::realizeAcceleration(const SimTK::State& state) const {
  const Instant& instant = checked(state);
  const Modes& now = modes(state);
  SimTK::Vector& z_dot = forces_.updZDot(state);
  const int n = contacts_.slots();
  Eigen::Map<Anchors> rates(&z_dot[first_z_], 3, n);  // Simbody's own element access is a virtual call
  for (int slot = 0; slot < n; ++slot) {
    if (now.mode[std::size_t(slot)] == Mode::slip)
      rates.col(slot) = instant.contacts.samples[std::size_t(slot)].response.anchor_rate;
    else
      rates.col(slot).setZero();
  }
  z_dot[first_z_ + 3 * n] = instant.dissipation;
  z_dot[first_z_ + 3 * n + 1] = instant.given;
}

std::string ContactForce::failure_text(const std::string& otherwise) const {
  if (!failure_) return otherwise;
  try {
    std::rethrow_exception(failure_);
  } catch (const CannotAdvance& error) {
    return error.what();
  } catch (const SimTK::Exception::Base& error) {
    return error.getMessage();
  }
}

}  // namespace handhold::reference::simbody
