// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "realtime/contact/contacts.hpp"
#include "realtime/solve/body_step.hpp"

// What touching patches cost in a step. Samples that stick do not move on their phalanx, nor their anchors on the
// object: what the solve needs of them are sums that their moments give, whatever their number. They are looked at one
// by one only at the solution, where each of them has to hold.

namespace handhold::realtime {

/// What the solve makes of a sample.
enum class Role : std::uint8_t {
  idle,     ///< out of reach
  watch,    ///< apart, and to stay so unless the solution brings it in
  linear,   ///< stuck before, and so far in this step
  free,     ///< may stick, or let go: just came in, or was found to pull
  sliding,  ///< slid before, or left its static cone: at most μ_d N
};

/// How the points of a patch move against its body in a step, in W. Arms are taken at `Scheme::place`.
struct PatchMotion {
  Eigen::Matrix3d R;  ///< arm = R p_P + t, p less the body's centre of mass
  Eigen::Vector3d t;
  Eigen::Matrix3d W;  ///< v = W R p_P + u: of p as its body sees it, if no velocity changed in this step
  Eigen::Vector3d u;
};

/// Spring and damper of sticking samples, and how their force falls with a change δ of relative velocity:
/// f = k (p − C) + ahead v − slope δ with p and C at `Scheme::place`.
struct Stiffness {
  double k{}, c{};
  double slope{};  ///< k θ h + c
  double ahead{};  ///< k (θ h − place) + c
};

/// One sample at θ h, in W, if no velocity changed in this step.
struct SampleStep {
  Eigen::Vector3d arm;    ///< p − centre of mass, at `place`
  Eigen::Vector3d reach;  ///< p − C
  Eigen::Vector3d v;      ///< relative velocity
  Eigen::Vector3d n;      ///< at the anchor
};
[[nodiscard]] SampleStep sample_step(const PatchMotion& motion, const BodyStep& target, double lead,
                                     const Contacts& contacts, std::size_t slot);

/// Of a patch's linear samples, points in P and anchors in O: they change only when one of them starts or ends to
/// stick.
struct StickMoments {
  double count{};
  Eigen::Vector3d p{Eigen::Vector3d::Zero()}, C{Eigen::Vector3d::Zero()};  ///< means
  Eigen::Matrix3d pp{Eigen::Matrix3d::Zero()}, pC{Eigen::Matrix3d::Zero()};  ///< Σ (p − mean)(p − mean)ᵀ, with C − mean
  bool stale{true};  ///< a sample's mode or role has changed since
};

/// Brings the moments of a patch up to date.
void update(const PatchSlot& patch, const Contacts& contacts, const std::vector<Role>& role, StickMoments& moments);

/// A patch in a step.
struct SlotStep {
  explicit SlotStep(int index) : patch(index) {}  // leaves the motion as it is: zeros would cost as much as the motion

  int patch;         ///< in Contacts
  bool holds{true};  ///< out: see evaluate_sticking
  PatchMotion motion;
};

/// Sums over the linear samples of all patches between two bodies: all that the solve needs of them. In W; f and v are
/// force and relative velocity at no change.
struct StickSums {
  double count{};
  Eigen::Vector3d arm{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d arm_arm{Eigen::Matrix3d::Zero()};  ///< Σ a aᵀ
  Eigen::Vector3d force{Eigen::Vector3d::Zero()}, torque{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v{Eigen::Vector3d::Zero()}, arm_v{Eigen::Vector3d::Zero()};  ///< Σ v, Σ a × v
  double power{}, squared_v{};                                                 ///< Σ f·v, Σ |v|²
  double size{};  ///< Σ |Σ f| over the patches: opposite fingers do not cancel
};

[[nodiscard]] StickSums sum_sticking(const SlotStep* begin, const SlotStep* end, const Stiffness& stiffness,
                                     const BodyStep& target, const std::vector<StickMoments>& moments);

/// What the linear samples do once the change of relative velocity is known: δ(p) = dv + dw × arm.
struct StickResult {
  Eigen::Vector3d force{Eigen::Vector3d::Zero()}, torque{Eigen::Vector3d::Zero()};
  double power{};      ///< Σ f·v, v relative [W]
  double squared_v{};  ///< Σ |v|²
};

[[nodiscard]] StickResult result_of(const StickSums& sums, const Stiffness& stiffness, const Eigen::Vector3d& dv,
                                    const Eigen::Vector3d& dw);

/// Forces of the patches' linear samples at the solution, to `contacts.f_O`; `holds` of each patch tells whether all of
/// its press and are inside their static cones.
void evaluate_sticking(SlotStep* begin, SlotStep* end, const Stiffness& stiffness, double mu_static,
                       const Eigen::Vector3d& dv, const Eigen::Vector3d& dw, const BodyStep& target,
                       const std::vector<Role>& role, const std::vector<StickMoments>& moments, Contacts& contacts);

}  // namespace handhold::realtime
