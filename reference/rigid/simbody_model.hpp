// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <vector>

#include "reference/rigid/rigid.hpp"
#include "reference/rigid/simbody_load.hpp"

namespace handhold::reference::rigid::simbody {

/// The problem as a Simbody system. Its modes belong to the model, not to a state: a state is of use only under the
/// modes it was given last.
class Model {
 public:
  Model(const RigidProblem& problem, double slow);

  [[nodiscard]] const SimTK::MultibodySystem& system() const { return system_; }
  [[nodiscard]] SimTK::State start();

  /// Switches the constraints of a state; time, place, velocity and work stay.
  void set_modes(SimTK::State& state, const Modes& modes);
  [[nodiscard]] const Modes& modes() const { return phase_.modes; }
  /// Forward directions only, which change no force.
  void hold_directions(const Modes& modes) { phase_.modes = modes; }

  [[nodiscard]] Motion motion(const SimTK::State& state) const;
  [[nodiscard]] BodyState body(const SimTK::State& state) const;
  /// Place and velocities, not the attitude.
  void set_motion(SimTK::State& state, const Motion& motion) const;

  [[nodiscard]] std::vector<ContactPoint> points(const SimTK::State& state) const;
  [[nodiscard]] std::vector<Reaction> reactions(const SimTK::State& state) const;
  [[nodiscard]] Frame frame(const SimTK::State& state) const;
  [[nodiscard]] double kinetic_energy(const Motion& motion) const;
  [[nodiscard]] const LoadForce& load() const { return *load_; }

  [[nodiscard]] const std::string& failure() const { return phase_.failure; }

 private:
  struct Constraints {                          // of one support; those of the other kind are empty handles
    SupportConstraint *sliding{}, *sticking{};  // owned by the handles
    SimTK::Constraint slide{}, stick{};
  };

  [[nodiscard]] std::vector<Reaction> forces(const SimTK::State& state) const;

  Phase phase_;
  SimTK::MultibodySystem system_{};
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody body_;
  std::vector<Constraints> constraints_{};
  LoadForce* load_;  // owned by forces_
};

}  // namespace handhold::reference::rigid::simbody
