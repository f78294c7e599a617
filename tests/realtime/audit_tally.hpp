// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What an audit of sub-steps counts, and how it notes a fault.

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>

#include "cases/model/recording.hpp"

namespace handhold::realtime::testing {

/// How kinetic + potential + elastic + dissipated − hand_work changes in one implicit Euler step: exactly by these.
///
/// With u the velocities held during the step, v and ė those of a sample against its body and of its lag, r = p − C ('
/// : as linearised), J the inertia at the pose about which the step is linearised (BodyStep):
///
///   numerical   −½ m |Δu|² − ½ ΔL J⁻¹ ΔL − Σ ½ k (|h v_n|² + |h ė|²): never positive
///   turning     ½ L1 (I1⁻¹ − J⁻¹) L1 − ½ L0 (I0⁻¹ − J⁻¹) L0 + Σ ½ k ((|r1|² − |r1'|²) − (|r0|² − |r0'|²)), of pairs
///               of bodies Σ h f·(v as the target sees it − v straight), of hands −Σ h (mean f − f)·u of the centre:
///               inertia, forces and arms are those of one orientation, the book knows the true ones. Of second order
///               in the angle h w of a step, either sign; none of it in a scene where nothing turns
///   touching    Σ f·r0': the force on a sample that comes in acts over the whole step, on its way outside as well: a
///               loss
///   appearing   Σ ½ k |r0'|² of samples of a body that are inside as the step begins; of a hand's it is booked as its
///               work
///   curving     Σ of sliding anchors that do not go the straight way that was planned. Of second order in the step
///   where
///               the surface is smooth; positive where it comes up to meet the sample
///   relaxing    Σ ½ k (e0 − e1)·slip of springs that relax while they slide: what the numerical term took too much
struct EnergyTerms {
  double numerical{}, turning{}, touching{}, appearing{}, curving{}, relaxing{};  // [J]

  EnergyTerms& operator+=(const EnergyTerms& other) {
    numerical += other.numerical;
    turning += other.turning;
    touching += other.touching;
    appearing += other.appearing;
    curving += other.curving;
    relaxing += other.relaxing;
    return *this;
  }
  [[nodiscard]] double sum() const { return numerical + turning + touching + appearing + curving + relaxing; }
};

/// What an audit saw; ratios are to what is allowed, so 1 is a fault.
struct AuditTally {
  long steps{}, forces{}, slides{};
  long backward{};                ///< slides that ended behind where they began, on the same side of the body
  long unconverged{}, audited{};  ///< steps; audited: with their energy
  double momentum{}, cone{}, element{}, energy{}, touch{}, way_in{};
  double gain{};        ///< most of kinetic + potential − start − what hands gave, ever [J]
  double excess{};      ///< what the terms added in steps in which they added: no gain is larger [J]
  double growth{};      ///< most of book − start, ever [J]
  double throughput{};  ///< Σ |energy that passed| = kinetic energy at the start + Σ |h f·v_p| + springs of hands that
                        ///< appear [J]
  EnergyTerms terms{};  ///< sums
  std::string fault{};  ///< the first; empty: none
};

/// Notes in a tally how near to its bounds all is, and the first fault.
class Faults {
 public:
  explicit Faults(AuditTally& tally) : tally_(tally) {}

  void at(double t) { t_ = t; }
  template <class... Parts>
  void require(bool holds, const Parts&... parts) {
    if (holds || !tally_.fault.empty()) return;
    std::ostringstream text;
    text.precision(9);
    text << "step " << tally_.steps << ", t = " << t_ << ": ";
    (text << ... << parts);
    tally_.fault = text.str();
  }
  /// Notes how near to its bound a quantity is.
  template <class... Parts>
  void bound(double value, double allowed, double& worst, const Parts&... what) {
    const double ratio = allowed > 0 ? value / allowed : (value > 0 ? 1e300 : 0);
    worst = std::max(worst, ratio);
    require(ratio <= 1, what..., ": ", value, " of ", allowed, " allowed");
  }

 private:
  AuditTally& tally_;
  double t_{};
};

/// A sample in a fault's text.
struct Name {
  SampleId id{};
  friend std::ostream& operator<<(std::ostream& out, const Name& name) {
    return out << "sample " << int(name.id.hand) << "/" << int(name.id.phalanx) << "/" << int(name.id.body) << "/"
               << int(name.id.sample);
  }
};

}  // namespace handhold::realtime::testing
