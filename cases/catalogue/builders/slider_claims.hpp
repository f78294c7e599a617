// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <Eigen/Core>

#include "cases/catalogue/case.hpp"
#include "cases/closed_form/slider_oscillator.hpp"

namespace handhold::catalogue {

/// Makes the expectations of a run whose truth is a closed_form::SliderOscillator.
///
/// Their limits for a stepped engine come from backward error analysis: to first order, a fully implicit step of length
/// h solves the equation of an element whose damping is larger by h K, under a force h/2 ahead and on a base h/2
/// behind, shows positions h/2 times the gained speed ahead (R03), and breaks away up to h too early. The same closed
/// form is evaluated with these changes; the limit is twice the largest shift (twice for what is of second order: a
/// stick phase may last a few sub-steps only), for events one sub-step more, at whose end they show, and after a stop
/// what one sub-step changes.
class SliderClaims {
 public:
  /// `axis`: where x of the oscillator points in W; `samples`: how many samples take part in every event.
  SliderClaims(const closed_form::SliderOscillator& oscillator, double until, const Eigen::Vector3d& axis, int samples);

  /// Time of the n-th breakaway or re-stick.
  [[nodiscard]] Claim breakaway(int n, const std::string& quantity) const;
  [[nodiscard]] Claim restick(int n, const std::string& quantity) const;
  /// Displacement against the base since t = 0, at t or at the n-th re-stick.
  [[nodiscard]] Claim slip(double t, const std::string& quantity) const;
  [[nodiscard]] Claim slip_at_restick(int n, const std::string& quantity) const;
  /// Speed against the base.
  [[nodiscard]] Claim speed(double t, const std::string& quantity) const;

  [[nodiscard]] Curve curve(const std::string& label) const;
  [[nodiscard]] const closed_form::SliderMotion& truth() const { return truth_.motion; }

 private:
  struct View {
    closed_form::SliderMotion motion;
    double ahead;  // a stepped engine shows positions this long times the gained speed ahead [s]
  };
  template <typename Read>
  [[nodiscard]] double shift(const Read& read) const;
  [[nodiscard]] Claim event(EventKind kind, int n, const std::string& quantity) const;
  [[nodiscard]] double slip_of(const View& view, double t) const;
  [[nodiscard]] double speed_of(const View& view, double t) const;
  [[nodiscard]] double kink() const;
  [[nodiscard]] double stopped(double t) const;

  closed_form::SliderOscillator o_;
  Eigen::Vector3d axis_;
  int samples_;
  View truth_, on_time_, early_;
};

}  // namespace handhold::catalogue
