// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// Two opposite undamped samples, each d deep in a block that rests freely at t = 0, move along its faces at constant
/// speed from then on. L2: the block is drawn along by springs, breaks away, slips until it keeps up, and rings.
struct PulledGrip {
  double mass{0.1};       ///< [kg]
  double stiffness{100};  ///< k of each sample [N/m]
  double depth{0.01};     ///< d [m]
  double speed{0.5};      ///< V; fast enough to break away: V >= mu_s d w [m/s]
  Friction friction{0.8, 0.6};
};

/// t1 = asin(μ_s d ω / V) / ω with ω = √(2k/m) [s].
[[nodiscard]] double breakaway_time(const PulledGrip& grip);

/// t2 = t1 + V cos(ω t1) m / (2 μ_d k d): the block, pulled by 2 μ_d k d, has reached V [s].
[[nodiscard]] double restick_time(const PulledGrip& grip);

/// Where the block is [m]: V (t − sin(ωt)/ω) to t1; then uniformly accelerated; from t2 on the lag is μ_d d cos ω(t −
/// t2).
[[nodiscard]] double object_position(const PulledGrip& grip, double t);

/// Two opposite undamped samples hold a rod against gravity, at first in balance; their depth breathes as
/// d(t) = mean + swing cos(ω t). L2: when the cone closes on the weight, the rod slides under decaying friction.
struct BreathingGrip {
  double mass{0.1};       ///< [kg]
  double stiffness{100};  ///< k of each sample [N/m]
  double mean{0.008};     ///< [m]
  double swing{0.004};    ///< [m], < mean
  double rate{8};         ///< ω [rad/s]
  double gravity{9.81};   ///< [m/s²]
  Friction friction{0.8, 0.6};
};

/// [m]
[[nodiscard]] double depth(const BreathingGrip& grip, double t);

/// First t with 2 μ_s k d(t) = m g [s]; NaN if the grip always holds.
[[nodiscard]] double slip_onset(const BreathingGrip& grip);

/// Height of the rod, 0 at first [m]: z'' = −g + 2 μ_d k d(t) / m from the onset on; valid while it slides down.
[[nodiscard]] double height(const BreathingGrip& grip, double t);

}  // namespace handhold::closed_form
