#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <ostream>
#include <string>
#include <vector>

#include <Simbody.h>

#include "reference/contacts.hpp"
#include "reference/recorder.hpp"

namespace handhold::reference::simbody {

/// The modes as a discrete variable of Simbody's state.
struct ModesVariable {
  Modes modes{};
  long revision{};  ///< changes with every change
};

std::ostream& operator<<(std::ostream& out, const ModesVariable& variable);

/// All contacts of the body, and its weight, as one Simbody force with auxiliary states: three coordinates of every
/// anchor, then the two integrals of the energy book.
///
/// A body held up by its support has no weight and moves as in thick oil (support_time); a fixed one is given no force
/// at all.
class ContactForce : public SimTK::Force::Custom::Implementation {
 public:
  ContactForce(const Scene& scene, Contacts& contacts, const SimTK::GeneralForceSubsystem& forces,
               const SimTK::MobilizedBody& body);

  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

  /// All samples at the state's instant (stage Velocity or later); computed once per state.
  [[nodiscard]] const Evaluation& evaluate(const SimTK::State& state) const;

  [[nodiscard]] const Modes& modes(const SimTK::State& state) const;
  [[nodiscard]] Anchors anchors(const SimTK::State& state) const;
  [[nodiscard]] Work work(const SimTK::State& state) const;
  [[nodiscard]] BodyMotion motion(const SimTK::State& state) const;

  void set(SimTK::State& state, const Modes& modes, const Anchors& anchors, const Work& work) const;

  /// What was last thrown inside the force: the integrator only says that it cannot advance.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  void forget_failure() { failure_.clear(); }

 private:
  struct Memory {  // of the last evaluation, recognised by value
    double t{};
    long revision{-1};
    std::vector<double> y{};
    Evaluation evaluation{};
  };

  struct Wrench {  // about O's origin, in W
    Eigen::Vector3d force{}, torque{};
  };

  [[nodiscard]] Eigen::Vector3d arm(const SimTK::State& state) const;  // from O's origin to the centre of mass, in W
  [[nodiscard]] Wrench weight(const SimTK::State& state) const;
  [[nodiscard]] Wrench support(const SimTK::State& state) const;
  [[nodiscard]] Work support_power(const SimTK::State& state) const;
  [[nodiscard]] const ModesVariable& variable(const SimTK::State& state) const;
  [[nodiscard]] const Evaluation& checked(const SimTK::State& state) const;

  const Scene& scene_;
  Contacts& contacts_;
  const SimTK::GeneralForceSubsystem& forces_;
  SimTK::MobilizedBody body_;
  mutable SimTK::ZIndex first_z_{};
  mutable SimTK::DiscreteVariableIndex modes_index_{};
  mutable Memory memory_{};
  mutable std::string failure_{};
};

/// One of the witness functions of the contacts; the run itself acts on their zeros.
class Witness : public SimTK::TriggeredEventHandler {
 public:
  enum class Kind { gap, friction, nearness };

  Witness(const ContactForce& force, Kind kind, int index, double time_window);

  SimTK::Real getValue(const SimTK::State& state) const override;
  void handleEvent(SimTK::State&, SimTK::Real, bool&) const override {}

 private:
  const ContactForce& force_;
  Kind kind_;
  std::size_t index_;
};

}  // namespace handhold::reference::simbody
