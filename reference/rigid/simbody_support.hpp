// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <string>

#include "reference/rigid/modes.hpp"
#include "reference/rigid/simbody_convert.hpp"

namespace handhold::reference::rigid::simbody {

/// What constraints and forces of one run share.
struct Phase {
  const RigidProblem& problem;
  Modes modes{};
  double slow{};          ///< see slip_direction [m/s]
  std::string failure{};  ///< what was last thrown inside a force: the integrator only says that it cannot advance
};

/// The equations of a support that holds or guides the body. Multipliers are minus the forces.
class SupportConstraint : public SimTK::Constraint::Custom::Implementation {
 public:
  enum class Kind {
    slide,  ///< gap = 0, with a force along n − μ_d d: not the gradient of the gap, so that friction comes with N
    hold,   ///< gap = 0 and no sliding (two equations)
    grip,   ///< no sliding: the normal force is given
  };

  SupportConstraint(Kind kind, const Phase& phase, std::size_t index, SimTK::MobilizedBody& ground,
                    SimTK::MobilizedBody& body);

  Implementation* clone() const override { return new SupportConstraint(*this); }

  void calcPositionErrors(const SimTK::State& state,
                          const SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>& X_AB,
                          const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                          SimTK::Array_<SimTK::Real>& errors) const override;
  void calcPositionDotErrors(const SimTK::State& state,
                             const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V_AB,
                             const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                             SimTK::Array_<SimTK::Real>& errors) const override;
  void calcPositionDotDotErrors(const SimTK::State& state,
                                const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A_AB,
                                const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                SimTK::Array_<SimTK::Real>& errors) const override;
  void addInPositionConstraintForces(const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
                                     SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& forces,
                                     SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&) const override;
  void calcVelocityErrors(const SimTK::State& state,
                          const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V_AB,
                          const SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&,
                          SimTK::Array_<SimTK::Real>& errors) const override;
  void calcVelocityDotErrors(const SimTK::State& state,
                             const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A_AB,
                             const SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&,
                             SimTK::Array_<SimTK::Real>& errors) const override;
  void addInVelocityConstraintForces(const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
                                     SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& forces,
                                     SimTK::Array_<SimTK::Real, SimTK::ConstrainedUIndex>&) const override;

  /// N and friction on the body from this constraint's multipliers, at the point as it is.
  [[nodiscard]] Reaction forces(const SimTK::Vector& multipliers, const ContactPoint& point) const;

 private:
  [[nodiscard]] const RigidSupport& support() const { return phase_.problem.supports[index_]; }
  [[nodiscard]] ContactPoint point(const SimTK::State& state, const SimTK::SpatialVec& V) const;
  [[nodiscard]] ContactPoint point_at_rest(const SimTK::State& state) const;

  Kind kind_;
  const Phase& phase_;
  std::size_t index_;
  SimTK::ConstrainedBodyIndex ground_{}, body_{};
};

}  // namespace handhold::reference::rigid::simbody
