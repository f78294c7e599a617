// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/closed_form/linear_motion.hpp"
#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// A mass that moves along one line x, held by one contact element (docs/contact-law.md: spring K and damper C in
/// parallel, in series with a Coulomb slider) against a base that moves, optionally by a tether (spring and damper in
/// parallel), under a force. L2; exact: every phase is a linear equation with a closed solution, the ends of phases are
/// roots of known functions.
///
///   m x'' = F(t) − f − K₂ (x − y(t)) − C₂ (x' − y'(t)),  f = K q + C q' of the element, q its stretch
///   stick: q = x − b(t) − anchor, until |K q + C (x' − b')| > μ_s N;
///   slip in direction s = ±1 (of the object against the base): f = s μ_d N; C q' + K q = s μ_d N, or q = s μ_d N / K
///   at once if C = 0; until s (K q + C (x' − b')) < μ_d N, or if C = 0 until the anchor's speed s (x' − b') − μ_d N'/K
///   is below 0.
///
/// With K → ∞ it is L1. All samples together: K, C and N are sums over samples that share one load and motion.
struct SliderOscillator {
  double mass{0.2};        ///< [kg]
  double stiffness{4000};  ///< K > 0 [N/m]
  double damping{};        ///< C >= 0 [N s/m]
  Friction friction{};
  Drive normal_force{};     ///< N(t) >= 0 as long as is asked for [N]
  Drive force{};            ///< F(t) on the mass [N]
  Drive base{};             ///< b(t) [m]
  double tether{};          ///< K₂ >= 0 [N/m]
  double tether_damping{};  ///< C₂ >= 0, 0 if K₂ is [N s/m]
  Drive tether_end{};       ///< y(t), where the tether is slack [m]
  double x{}, v{};          ///< at t = 0 [m], [m/s]
  double stretch{};         ///< q at t = 0 [m]; of no meaning if it slips and C = 0
  int direction{0};         ///< at t = 0: 0 sticks, ±1 slips that way
};

struct SliderState {
  double x{}, v{};    ///< of the mass [m], [m/s]
  double stretch{};   ///< q [m]
  double friction{};  ///< f, the element's force on the mass is −f [N]
  int direction{};    ///< 0 sticks, ±1 slips
};

/// A change of mode.
struct SliderEvent {
  double t{};           ///< [s]
  int direction{};      ///< after it: ±1 breakaway, 0 re-stick
  SliderState state{};  ///< after it
  double rate{};  ///< how fast what decides crosses its limit: the force [N/s], or the speed if C = 0 re-sticks [m/s²]
};

/// The motion from t = 0 to `until`.
class SliderMotion {
 public:
  /// Throws InputError for parameters out of range, and when modes change more often than 10000 times. With `lead` > 0
  /// [s] the mass breaks away that much before it is due (but not below the kinetic limit), as in an engine of this
  /// step, which slides through the whole step at whose end the static limit is passed.
  SliderMotion(const SliderOscillator& oscillator, double until, double lead = 0);

  [[nodiscard]] const std::vector<SliderEvent>& events() const { return events_; }

  /// The n-th (from 1) event of that kind: breakaway, or re-stick. Throws InputError if there is none.
  [[nodiscard]] const SliderEvent& breakaway(int n = 1) const;
  [[nodiscard]] const SliderEvent& restick(int n = 1) const;

  /// `t` in [0, until]; at an event, the state after it.
  [[nodiscard]] SliderState at(double t) const;

 private:
  struct Phase {
    double begin{};
    int direction{};
    double anchor{};  // stick
    LinearMotion motion{};
    Relaxation stretch{};  // damped slip
  };

  [[nodiscard]] Phase phase(double begin, const SliderState& start) const;
  [[nodiscard]] SliderState state(const Phase& phase, double t) const;
  [[nodiscard]] double trial(const SliderState& state, double t) const;
  [[nodiscard]] double witness(const Phase& phase, double t) const;
  [[nodiscard]] double end_of(const Phase& phase, double until) const;
  [[nodiscard]] double rate_at(const Phase& phase, double end) const;
  [[nodiscard]] double led(const Phase& phase, double end) const;
  [[nodiscard]] const SliderEvent& event(bool restick, int n) const;

  SliderOscillator o_;
  double lead_{};
  double scan_{};  // step of the search for events [s]
  std::vector<Phase> phases_{};
  std::vector<SliderEvent> events_{};
};

}  // namespace handhold::closed_form
