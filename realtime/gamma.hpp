// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace handhold::realtime {

/// What the spring stiffness of a contact must suit. "We also investigated a way to automatically adjust γ with respect
/// to the physical properties of the object (volume, mass, surface material) to ensure that the user can bring up
/// enough force even for small or heavy objects" (Höll et al. 2018, section 3.3, without a formula).
struct GraspDemand {
  double mass{};          ///< of the object [kg], > 0
  double volume{};        ///< [m³]; 0: not known, the depth is not limited by it
  double mu_static{0.5};  ///< > 0
  int samples{16};        ///< that press together: 8 each of a pinch's two phalanges, >= 1
  double depth{0.003};    ///< how deep a user's fingers go into a virtual object without thinking of it [m], > 0
  double margin{3};       ///< s: how many times the weight the grip can carry at that depth, >= 1
  double gravity{9.81};   ///< [m/s²], > 0
};

/// Throws InputError for the first number out of its range.
void validate(const GraspDemand& demand);

/// The depth asked for, or a tenth of the edge of a cube of the object's volume if that is less: two fingers shall not
/// meet inside a small object [m].
[[nodiscard]] double working_depth(const GraspDemand& demand);

/// γ = s m g / (μ_s n d) per sample [N/m].
///
/// n samples at depth d press with n γ d in all and carry up to μ_s n γ d by friction (eq. 4): that shall be s times
/// the weight. s = 1 holds a resting object only; an object let go on unstretched springs overshoots to twice its
/// weight (L3-10), and a hand that lifts with acceleration a asks for 1 + a / g: the default 3 is a lift of g / 2 with
/// the overshoot of undamped springs.
///
/// What follows, whatever the mass: the object sags by m g / (n γ) = μ_s d / s, and in frames of dt its springs have
/// K dt² / m = s g dt² / (μ_s d), so that explicit frame-rate engines are as stable for 10 g as for 10 kg.
[[nodiscard]] double auto_stiffness(const GraspDemand& demand);

/// c per sample so that the object on its n springs has the damping ratio ζ: 2 ζ sqrt(m n γ) / n [N s/m].
[[nodiscard]] double auto_damping(const GraspDemand& demand, double stiffness, double ratio);

/// K dt² / m = s g dt² / (μ_s d) with auto_stiffness: must stay below 4 for semi-implicit frames (L3-08), below 2.7
/// where a cube may turn.
[[nodiscard]] double spring_number(const GraspDemand& demand, double dt);

}  // namespace handhold::realtime
