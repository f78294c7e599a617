// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/closed_form/shaken_pinch.hpp"
#include "cases/closed_form/slider_oscillator.hpp"

namespace handhold::closed_form {

/// G06. The shaken pinch carries a weight: by turns one finger presses less, N = K (d0 − Z sin ωt), and slips while the
/// other, pressing more, takes over its load. L1 holds iff 2 μ K d0 >= m g, shaken or not. L2 (tangential stiffness K
/// of each finger, the object only translates, both carry m g/2 at first): shakes down iff μ K (d0 − Z) >= m g/2, else
/// creeps.
struct Ratchet {
  ShakenPinch pinch{};
  double mu{0.5};
  double gravity{9.81};  ///< [m/s²]
  double damping{};      ///< C of each finger, tangential only: not of the law, for error analysis [N s/m]
};

/// Largest Z without slip: d0 − m g/(2 μ K) [m].
[[nodiscard]] double shakedown_amplitude(const Ratchet& ratchet);

/// Creep per cycle for infinitely slow shaking: 2 (m g − 2 μ K (d0 − Z))/K, 0 if it shakes down [m]. A limit that no
/// case shakes slowly enough for; RatchetMotion is tested against it.
[[nodiscard]] double slow_creep(const Ratchet& ratchet);

/// The motion, exact: one slider oscillator each half period, in which the finger that presses less may slip and the
/// other is a spring.
class RatchetMotion {
 public:
  RatchetMotion(const Ratchet& ratchet, int half_periods);

  /// Distance that the object has come down since t = 0, up to the end of the last half period [m].
  [[nodiscard]] double creep(double t) const;

  /// When the first finger slips, and sticks again.
  [[nodiscard]] const SliderEvent& first_breakaway() const { return halves_.front().breakaway(); }
  [[nodiscard]] const SliderEvent& first_restick() const { return halves_.front().restick(); }

  /// Largest tangential over normal force, over μ, of the finger that is taken for a spring; the solution holds while
  /// this is below 1. At 200 instants a half period. Tells whether the truth holds; no number of a case.
  [[nodiscard]] double carrier_load() const;

 private:
  Ratchet ratchet_;
  double half_period_;
  std::vector<SliderMotion> halves_{};
  std::vector<double> carrier_anchor_{};  // of every half
};

}  // namespace handhold::closed_form
