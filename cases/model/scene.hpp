#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/geometry/mass_properties.hpp"
#include "cases/hand/hand_motion.hpp"
#include "cases/hand/trace.hpp"
#include "cases/model/friction.hpp"
#include "cases/model/patch.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// The contact element of every sample: spring and damper in parallel, in series with a Coulomb slider
/// (docs/contact-law.md).
struct ContactParameters {
  double stiffness{100};  ///< k = γ per sample [N/m], > 0 (Höll et al. 2018, eq. 1; the paper prints no unit)
  double damping{0.5};    ///< c per sample [N s/m], >= 0; 0 is the paper's bare spring
};

void validate(const ContactParameters& contact);

/// Which of a body's six degrees of freedom exist.
enum class Mobility { free, translation, fixed };

/// Mass properties about the centre of mass, in the body's (object's) frame O.
struct Inertia {
  double mass{};                                          ///< [kg], > 0
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};        ///< centre of mass in O [m]
  Eigen::Matrix3d about_center{Eigen::Matrix3d::Zero()};  ///< [kg m²], axes of O
};

/// The support that holds a body up until `Body::held_until`: it carries the body's weight and resists its motion like
/// thick oil, with force −m v / τ at the centre of mass and torque −I ω / τ. So a hand that closes moves the body to
/// where its fingers are in balance; a rigid support would let it go under whatever force the fingers happen to leave
/// over. τ [s]:
inline constexpr double support_time = 0.01;

/// A force at a body's centre of mass and a torque, both in W.
struct Load {
  Eigen::Vector3d force_W{Eigen::Vector3d::Zero()};   ///< [N]
  Eigen::Vector3d torque_W{Eigen::Vector3d::Zero()};  ///< [N m]
};

/// One object, ready to simulate.
struct Body {
  std::string name{};
  std::shared_ptr<const VoxelField> field{};
  Inertia inertia{};
  Mobility mobility{Mobility::free};
  Friction friction{};   ///< against skin; two bodies have `combined` of theirs
  Pose X_WO{};           ///< at t = 0
  Twist V_WO{};          ///< at t = 0; v is the velocity of O's origin
  double held_until{0};  ///< a support (see support_time) holds the body up until then [s]
  /// Points of the body's surface, in O, that touch the surfaces of the other bodies, at most 255; none: it is touched
  /// by others' samples only. See surface_samples (geometry/surface_samples.hpp).
  std::vector<Eigen::Vector3d> samples_O{};
  std::function<Load(double t)> load{};  ///< applied besides gravity, smooth in t; empty: none
};

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
