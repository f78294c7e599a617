// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/model/friction.hpp"
#include "cases/model/recording.hpp"

namespace handhold::reference {

/// Depth at which an undamped contact begins [m]; it ends at half of it, so that round-off cannot toggle it. The force
/// there, 1e-12 k, is far below every tolerance, and slip (singular at depth 0) stays regular.
inline constexpr double touch_depth = 1e-12;

/// One contact sample: spring and damper in parallel, in series with a Coulomb slider (docs/contact-law.md).
struct Element {
  double stiffness{};  ///< k [N/m]
  double damping{};    ///< c [N s/m]; 0: the slider is rate independent
  Friction friction{};
  /// Undamped slip less deep than this is not asked to stick again [m]: its lag, mu_d d, is not longer than the error
  /// of the anchor, so that its direction is noise. The force there is as far below tolerance as the accuracy.
  double shallow{1e-8};
};

/// The surface at an anchor C.
struct AnchorSurface {
  double phi{};                                ///< signed distance of the anchor from the surface: its drift [m]
  Eigen::Vector3d n{Eigen::Vector3d::Zero()};  ///< unit, outward
  Eigen::Matrix3d curvature{Eigen::Matrix3d::Zero()};  ///< Hessian of the distance over its slope [1/m]; used if c = 0
  Eigen::Vector3d edge{Eigen::Vector3d::Zero()};       ///< unit, of a hollow edge that holds the anchor; zero: none
};

/// A sample point p seen from its anchor C, all in the object's frame O.
struct Approach {
  Eigen::Vector3d r{Eigen::Vector3d::Zero()};  ///< p − C [m]
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< of p in O: its velocity less that of O's material point at p [m/s]
};

/// What the element does in a given mode, continued smoothly past the switch, so that trial steps across it are
/// harmless.
struct Response {
  double depth{};                                        ///< d = −r·n [m]
  double depth_rate{};                                   ///< d' = −v·n, while C rests [m/s]
  double normal_force{};                                 ///< N = k d + c d' [N]; negative only past `release`
  Eigen::Vector3d lag{Eigen::Vector3d::Zero()};          ///< e = r + d n [m]
  Eigen::Vector3d trial{Eigen::Vector3d::Zero()};        ///< t* = k e + c v_t [N]
  Eigen::Vector3d force{Eigen::Vector3d::Zero()};        ///< on the object, along the line through p [N]
  Eigen::Vector3d anchor_rate{Eigen::Vector3d::Zero()};  ///< of C in O [m/s]
  double dissipation{};                                  ///< by damper and slider [W]
  double release{};                                      ///< > 0: goes apart
  double friction{};                                     ///< > 0: stick breaks away, slip sticks again
  bool singular{false};  ///< undamped slip round an edge sharper than the depth: no solution
};

/// Evaluates the element in `mode` (stick or slip).
[[nodiscard]] Response respond(const Element& element, Mode mode, const Approach& approach,
                               const AnchorSurface& surface);

}  // namespace handhold::reference
