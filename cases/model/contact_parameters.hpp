// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace handhold {

/// The contact element of every sample: spring and damper in parallel, in series with a Coulomb slider
/// (docs/contact-law.md).
struct ContactParameters {
  double stiffness{100};  ///< k = γ per sample [N/m], > 0 (Höll et al. 2018, eq. 1; the paper prints no unit)
  double damping{0.5};    ///< c per sample [N s/m], >= 0; 0 is the paper's bare spring
};

/// Throws InputError for values out of range.
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

/// Throws InputError, its sentence beginning with `who` ("hand 0"), for a patch without samples or with too many, two
/// patches on one phalanx, or a sample that is not finite.
void validate(const std::vector<GivenPatch>& given, const std::string& who);

}  // namespace handhold
