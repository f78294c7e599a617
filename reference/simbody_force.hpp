// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <exception>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <Simbody.h>

#include "reference/body_forces.hpp"
#include "reference/contacts.hpp"
#include "reference/recorder.hpp"
#include "reference/simbody_bodies.hpp"

namespace handhold::reference::simbody {

/// The modes as a discrete variable of Simbody's state. Shared, because the integrator copies states.
struct ModesVariable {
  std::shared_ptr<const Modes> modes{};
  long revision{};  ///< changes with every change
};

std::ostream& operator<<(std::ostream& out, const ModesVariable& variable);

/// Everything at one state.
struct Instant {
  Motions motions{};
  Evaluation contacts{};
  std::vector<Wrench> wrench{};  ///< of all forces on every body
  double dissipation{};          ///< [W]
  double given{};                ///< by hands, loads and supports [W]
};

/// All contacts, weights, supports and loads as one Simbody force with auxiliary states: three coordinates of every
/// anchor, then the two integrals of the energy book.
class ContactForce : public SimTK::Force::Custom::Implementation {
 public:
  ContactForce(const Scene& scene, Contacts& contacts, const Bodies& bodies,
               const SimTK::GeneralForceSubsystem& forces);

  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

  /// At the state's instant (stage Velocity or later); computed once per state.
  [[nodiscard]] const Instant& evaluate(const SimTK::State& state) const;

  /// With all witnesses.
  [[nodiscard]] const Instant& watch(const SimTK::State& state) const;

  [[nodiscard]] const Modes& modes(const SimTK::State& state) const;
  [[nodiscard]] Eigen::Map<const Anchors> anchors(const SimTK::State& state) const;
  [[nodiscard]] Work work(const SimTK::State& state) const;

  void set(SimTK::State& state, Modes modes, const Anchors& anchors, const Work& work) const;

  /// What was last thrown inside the force, for the integrator only says that it cannot advance; `otherwise` if
  /// nothing. Wrong input found on the way, such as a load that is not finite, is thrown again.
  [[nodiscard]] std::string failure_text(const std::string& otherwise) const;
  void forget_failure() { failure_ = nullptr; }

 private:
  struct Memory {  // of the last evaluation, recognised by value
    double t{};
    long revision{-1};
    std::vector<double> y{};
    Instant instant{};
  };

  [[nodiscard]] const ModesVariable& variable(const SimTK::State& state) const;
  [[nodiscard]] bool remembers(const SimTK::State& state) const;
  void compute(const SimTK::State& state, Instant& out) const;
  [[nodiscard]] const Instant& checked(const SimTK::State& state) const;

  const Scene& scene_;
  Contacts& contacts_;
  const Bodies& bodies_;
  const SimTK::GeneralForceSubsystem& forces_;
  mutable SimTK::ZIndex first_z_{};
  mutable SimTK::DiscreteVariableIndex modes_index_{};
  mutable Memory memory_{};
  mutable std::exception_ptr failure_{};
};

}  // namespace handhold::reference::simbody
