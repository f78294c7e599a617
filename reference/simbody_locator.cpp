// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/simbody_locator.hpp"

#include <algorithm>

namespace handhold::reference::simbody {

Locator::Values Locator::values(const Evaluation& e) { return {e.touch, e.release, e.friction, e.edge, e.nearness}; }

void Locator::read(const SimTK::State& state, Point& point) const {
  system_.realize(state, SimTK::Stage::Acceleration);
  point.t = state.getTime();
  point.y = state.getY();
  point.rate = state.getYDot();
  point.values = values(force_.watch(state).contacts);
}

void Locator::begin(const SimTK::State& state) { read(state, begin_); }

bool Locator::rises(const SimTK::State& end) {
  system_.realize(end, SimTK::Stage::Velocity);
  const Values now = values(force_.watch(end).contacts);
  bool any = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    rising_[i] = begin_.values[i] <= 0 && now[i] > 0;
    any = any || rising_[i];
  }
  if (!any) return false;
  read(end, end_);
  scratch_ = end;  // the modes have not changed within the step
  return true;
}

/// The largest of the rising witnesses, each in units of what it is at the end of the step.
double Locator::value_at(double t) {
  const double h = end_.t - begin_.t, s = (t - begin_.t) / h;
  const double a = (1 + 2 * s) * (1 - s) * (1 - s), b = s * (1 - s) * (1 - s) * h;
  const double c = s * s * (3 - 2 * s), d = s * s * (s - 1) * h;
  scratch_.setTime(t);
  SimTK::Vector& y = scratch_.updY();
  const int n = y.size();
  const double *y0 = &begin_.y[0], *f0 = &begin_.rate[0], *y1 = &end_.y[0], *f1 = &end_.rate[0];
  double* out = &y[0];
  for (int i = 0; i < n; ++i) out[i] = a * y0[i] + b * f0[i] + c * y1[i] + d * f1[i];
  system_.realize(scratch_, SimTK::Stage::Velocity);
  const Values now = values(force_.watch(scratch_).contacts);
  double largest = -1e300;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (rising_[i]) largest = std::max(largest, now[i] / end_.values[i]);
  return largest;
}

/// False position with Illinois' halving; a bisection at every third step, because the largest of several has kinks.
Locator::Window Locator::narrow(double width) {
  Window w{begin_.t, end_.t};
  double at_low = -1e300, at_high = 1;
  for (std::size_t i = 0; i < rising_.size(); ++i)
    if (rising_[i]) at_low = std::max(at_low, begin_.values[i] / end_.values[i]);
  double weight_low = at_low, weight_high = at_high;
  for (int step = 1; w.high - w.low > width; ++step) {
    const double guess = w.low - weight_low * (w.high - w.low) / (weight_high - weight_low);
    const double inner = 0.4 * width;  // so that a root that is met exactly is bracketed by the next two steps
    double t = step % 3 == 0 || !(weight_high > weight_low) ? (w.low + w.high) / 2 : guess;
    t = std::clamp(t, w.low + inner, w.high - inner);
    if (!(t > w.low && t < w.high)) break;  // round-off of times
    const double value = value_at(t);
    if (value > 0) {
      w.high = t, weight_high = value, weight_low /= 2;
    } else {
      w.low = t, weight_low = value, weight_high /= 2;
    }
  }
  return w;
}

bool Locator::at_end(double width) { return end_.t - begin_.t <= width || value_at(end_.t - width) <= 0; }

void Locator::rewind(SimTK::State& state) const {
  state.setTime(begin_.t);
  state.updY() = begin_.y;
}

}  // namespace handhold::reference::simbody
