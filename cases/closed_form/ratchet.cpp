// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/ratchet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handhold::closed_form {

double shakedown_amplitude(const Ratchet& r) {
  return r.pinch.preload - r.pinch.mass * r.gravity / (2 * r.mu * r.pinch.stiffness);
}

double slow_creep(const Ratchet& r) {
  const double least = r.mu * r.pinch.stiffness * (r.pinch.preload - relative_amplitude(r.pinch));
  return std::max(0.0, 2 * (r.pinch.mass * r.gravity - 2 * least) / r.pinch.stiffness);
}

RatchetMotion::RatchetMotion(const Ratchet& r, int half_periods)
    : ratchet_(r), half_period_(std::numbers::pi / r.pinch.frequency) {
  const double K = r.pinch.stiffness, weight = r.pinch.mass * r.gravity;
  SliderOscillator o{.mass = r.pinch.mass,
                     .stiffness = K,
                     .damping = r.damping,
                     .friction = {r.mu, r.mu},
                     .tether = K,
                     .tether_damping = r.damping};
  o.normal_force = {
      .constant = K * r.pinch.preload, .amplitude = -K * relative_amplitude(r.pinch), .frequency = r.pinch.frequency};
  o.force.constant = weight;
  o.stretch = weight / (2 * K);
  o.tether_end.constant = -weight / (2 * K);  // the carrier's anchor
  for (int i = 0; i < half_periods; ++i) {
    halves_.emplace_back(o, half_period_);
    carrier_anchor_.push_back(o.tether_end.constant);
    const SliderState end = halves_.back().at(half_period_);
    o.x = end.x;
    o.v = end.v;
    o.stretch = end.x - o.tether_end.constant;  // the fingers change roles
    o.tether_end.constant = end.x - end.stretch;
  }
}

double RatchetMotion::creep(double t) const {
  const double turn = std::floor(t / half_period_);
  const auto half = std::min(halves_.size() - 1, std::size_t(std::max(0.0, turn)));
  return halves_[half].at(t - double(half) * half_period_).x;
}

double RatchetMotion::carrier_load() const {
  const ShakenPinch& p = ratchet_.pinch;
  double largest = 0;
  for (std::size_t i = 0; i < halves_.size(); ++i)
    for (int k = 0; k <= 200; ++k) {
      const double t = half_period_ * k / 200;
      const double N = p.stiffness * (p.preload + relative_displacement(p, t));
      const double load = p.stiffness * (halves_[i].at(t).x - carrier_anchor_[i]);
      largest = std::max(largest, std::abs(load) / (ratchet_.mu * N));
    }
  return largest;
}

}  // namespace handhold::closed_form
