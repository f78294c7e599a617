#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/hand_motion.hpp"
#include "cases/model/patch.hpp"

namespace handhold {

/// The contact element of every sample: spring and damper in parallel, in series with a Coulomb slider
/// (docs/contact-law.md).
struct ContactParameters {
  double stiffness{100};  ///< k = γ per sample [N/m], > 0 (Höll et al. 2018, eq. 1; the paper prints no unit)
  double damping{0.5};    ///< c per sample [N s/m], >= 0; 0 is the paper's bare spring
};

void validate(const ContactParameters& contact);

/// How a sample starts at t = 0 if it is inside its object.
struct SampleStart {
  Eigen::Vector3d lag_W{
      Eigen::Vector3d::Zero()};  ///< tangential lag e: the anchor starts at the surface below p − lag [m]
  bool slipping{false};          ///< start in slip (the lag is then the direction of sliding of the hand)
};

/// A patch with given sample points, in place of the seeded ones: for cases with a closed form.
struct GivenPatch {
  int phalanx{};
  std::vector<Eigen::Vector3d> p_P{};  ///< sample points in the phalanx's frame [m]
  std::vector<SampleStart> start{};    ///< empty, or one a sample
};

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
