// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <vector>

#include <Simbody.h>

#include "cases/model/scene.hpp"
#include "reference/contact_data.hpp"
#include "reference/simbody_library.hpp"

namespace handhold::reference::simbody {

/// The bodies of a scene that move, in Simbody; fixed ones are constants.
class Bodies {
 public:
  Bodies(const Scene& scene, SimTK::SimbodyMatterSubsystem& matter);

  /// Initial poses, and velocities of all but held bodies, into a state of the realized model.
  void set_start(SimTK::State& state) const;

  /// Of every body, at a state of stage Velocity. Does not allocate but in the first call with `out`.
  void read_motions(const SimTK::State& state, Motions& out) const;

  void apply(int body, const Wrench& wrench, SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;

 private:
  struct Moving {
    int body;
    SimTK::MobilizedBody mobilized;
  };

  const Scene& scene_;
  std::vector<Moving> moving_{};
  std::vector<int> index_{};  // into moving_, of every body; −1: fixed
  Motions at_start_{};
};

}  // namespace handhold::reference::simbody
