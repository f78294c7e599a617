// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <functional>

#include "reference/rigid/simbody_support.hpp"

namespace handhold::reference::rigid::simbody {

/// The two integrals of the energy book, auxiliary states of the integration [J].
struct Work {
  double dissipated{}, outside{};
};

/// Weight, springs, the applied load, and what fingers that press with a given force do; and the energy book.
class LoadForce : public SimTK::Force::Custom::Implementation {
 public:
  /// `reactions` gives every support's forces once the multipliers are known (the body's accelerations may be missing).
  using Reactions = std::function<std::vector<Reaction>(const SimTK::State& state)>;

  LoadForce(Phase& phase, const SimTK::GeneralForceSubsystem& forces, const SimTK::MobilizedBody& body,
            const Reactions& reactions);

  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

  [[nodiscard]] Work work(const SimTK::State& state) const;
  void set_work(SimTK::State& state, const Work& work) const;
  [[nodiscard]] double spring_energy(const SimTK::State& state) const;

 private:
  [[nodiscard]] Motion motion(const SimTK::State& state) const;
  [[nodiscard]] Load applied(const SimTK::State& state) const;

  Phase& phase_;
  const SimTK::GeneralForceSubsystem& forces_;
  SimTK::MobilizedBody body_;
  Reactions reactions_;
  mutable SimTK::ZIndex first_z_{};
};

}  // namespace handhold::reference::rigid::simbody
