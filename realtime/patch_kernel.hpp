#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "realtime/contacts.hpp"
#include "realtime/rigid_body.hpp"

// The work that every sample of every touching patch costs in a step, two samples at a time in vector registers. All
// of it is plain IEEE arithmetic in a fixed order: the same bits at every level of optimisation.

namespace handhold::realtime {

/// How the samples of one patch move against its body, in W: arms are taken at `Scheme::place`, what forces are made of
/// at θ h, where the body has turned (and points seen from it with it).
struct PatchMotion {
  Eigen::Matrix3d R_a{Eigen::Matrix3d::Zero()};  ///< arm = R_a p_P + t_a, p less the body's centre of mass
  Eigen::Vector3d t_a{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_v{Eigen::Matrix3d::Zero()};  ///< v = R_v p_P + t_v, of p less that of the body's material point at
  Eigen::Vector3d t_v{Eigen::Vector3d::Zero()};  ///< p, if no velocity changed in this step
  Eigen::Matrix3d R_r{Eigen::Matrix3d::Zero()};  ///< p − C = R_r p_P + t_r − R C
  Eigen::Vector3d t_r{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R{Eigen::Matrix3d::Identity()};  ///< of the body
};

/// Samples in one step, by slot, in W.
struct SampleSteps {
  Vector3Array arm{};                ///< p − centre of mass
  Vector3Array reach{};              ///< p − C at θ h
  Vector3Array v{};                  ///< relative velocity
  Vector3Array n{};                  ///< at the anchor
  std::vector<double> linear{};      ///< 1: sticks, so its force is linear in the change of velocity; else 0
  std::vector<std::uint8_t> used{};  ///< takes any part in the step

  void resize(std::size_t slots);
};

/// Fills the samples of a patch.
void project(const PatchMotion& motion, const Contacts& contacts, const PatchSlot& patch, SampleSteps& samples);

/// Spring and damper of sticking samples, and how their force falls with a change δ of relative velocity:
/// f = k reach + c v − slope δ, slope = k θ h + c.
struct Stiffness {
  double k{}, c{}, slope{};
};

/// Sums over the linear samples of a patch: all that the solve needs of them. f is the force at no change.
struct StickSums {
  double count{};
  Eigen::Vector3d arm{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d arm_arm{Eigen::Matrix3d::Zero()};  ///< Σ a aᵀ
  Eigen::Vector3d force{Eigen::Vector3d::Zero()}, torque{Eigen::Vector3d::Zero()};
};

[[nodiscard]] StickSums sum_sticking(const PatchSlot& patch, const Stiffness& stiffness, const SampleSteps& samples);

/// What the linear samples do once the change of relative velocity is known: δ(p) = dv + dw × arm.
struct StickResult {
  bool holds{true};  ///< all press, and inside their static cones
  Eigen::Vector3d force{Eigen::Vector3d::Zero()}, torque{Eigen::Vector3d::Zero()};
  double power{};      ///< Σ f·v, v relative [W]
  double squared_v{};  ///< Σ |v|²
};

[[nodiscard]] StickResult evaluate_sticking(const PatchSlot& patch, const Stiffness& stiffness, double mu_static,
                                            const Eigen::Vector3d& dv, const Eigen::Vector3d& dw,
                                            const SampleSteps& samples, Vector3Array& f_W);

}  // namespace handhold::realtime
