// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace handhold::closed_form {

/// F03, F04. A rigid object moves in a plane under gravity, undamped samples at points of the hand that is at rest:
/// some stick to it, some slip. L2, one ordinary differential equation as long as no mode changes: a slipping sample p
/// pulls with μ_d N along its leash ρ û = p − C, and its anchor moves along û only, so that with v the velocity of the
/// object's material at C
///   û' = −(v − (v·û) û) / ρ.
/// Solved numerically (GSL, Runge-Kutta Prince-Dormand 8(9)): pedigree "converged".
///
/// Coordinates (u, v) of the plane, turns counted from u to v.
struct PlanarSlide {
  struct Slipping {
    Eigen::Vector2d p{Eigen::Vector2d::Zero()};  ///< [m]
    double friction{};                           ///< μ_d N of all samples at this place [N]
    double leash{};                              ///< ρ = μ_d N / k of each [m]
    double direction{};                          ///< of û at t = 0, from the u axis [rad]
  };
  struct Sticking {
    Eigen::Vector2d p{Eigen::Vector2d::Zero()};         ///< [m]
    Eigen::Vector2d anchor_B{Eigen::Vector2d::Zero()};  ///< from the centre of mass, in the body's frame [m]
    double stiffness{};                                 ///< of all samples at this place [N/m]
  };
  double mass{};                                     ///< [kg]
  double inertia{};                                  ///< about the centre of mass [kg m²]
  Eigen::Vector2d gravity{Eigen::Vector2d::Zero()};  ///< [m/s²]
  std::vector<Slipping> slipping{};
  std::vector<Sticking> sticking{};
  Eigen::Vector2d center{Eigen::Vector2d::Zero()};    ///< of mass, at t = 0 [m]
  Eigen::Vector2d velocity{Eigen::Vector2d::Zero()};  ///< [m/s]
  double angle{}, spin{};                             ///< [rad], [rad/s]
};

struct PlanarState {
  double t{};
  Eigen::Vector2d center{Eigen::Vector2d::Zero()};
  Eigen::Vector2d velocity{Eigen::Vector2d::Zero()};
  double angle{}, spin{};
};

/// State at t, presuming that no mode changes before. `accuracy`: of a step, absolute and relative.
[[nodiscard]] PlanarState planar_state(const PlanarSlide& slide, double t, double accuracy = 1e-13);

/// When the first of the slipping samples would stop to move forwards, to the last bit of t; its state. Looks up to
/// `longest` in steps of a thousandth of it; t = NaN if none does.
[[nodiscard]] PlanarState first_restick(const PlanarSlide& slide, double longest, double accuracy = 1e-13);

}  // namespace handhold::closed_form
