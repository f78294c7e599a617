// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/contact_parameters.hpp"
#include "cases/model/hand_motion.hpp"
#include "cases/model/patch.hpp"

namespace handhold {

/// One hand, ready to simulate.
struct Hand {
  std::shared_ptr<const HandMotion> motion{};
  std::vector<GivenPatch> given{};  ///< empty: patches are seeded where phalanges come near (PatchOptions)
};

/// Everything both engines are given. Poses and vectors in W (z up) unless named otherwise; SI.
struct Scene {
  std::string name{};
  double duration{1};                       ///< [s], > 0; time starts at 0
  Eigen::Vector3d gravity{0, 0, -9.81};     ///< [m/s²]
  ContactParameters contact{};              ///< of hands with bodies
  ContactParameters body_contact{2e4, 20};  ///< of bodies with each other, per sample of `Body::samples_O`
  PatchOptions patch{};
  std::vector<Body> bodies{};
  std::vector<Hand> hands{};
};

/// Throws InputError naming the first thing that cannot be simulated: no body, NaN, mass <= 0, an inertia that no solid
/// can have, mu_d > mu_s, duration <= 0, a hand that is absent throughout.
void validate(const Scene& scene);

}  // namespace handhold
