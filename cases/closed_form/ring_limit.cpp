// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/ring_limit.hpp"

#include <cmath>
#include <numbers>

namespace handhold::closed_form {
namespace {

/// Power of friction over the power of a unit weight, per unit spin about a centre at −c; and its derivative by c times
/// (L + c)², which grows with c and whose root is the minimum.
struct Ratio {
  double value{}, slope{};
};

Ratio ratio(const EccentricLoad& l, double c) {
  double sum = 0, rate = 0;
  for (int i = 0; i < l.samples; ++i) {
    const double angle = 2 * std::numbers::pi * i / l.samples;
    const double x = l.radius * std::cos(angle) + c, z = l.radius * std::sin(angle);
    const double distance = std::hypot(x, z);
    sum += distance;
    rate += distance > 0 ? x / distance : 0;
  }
  const double each = 2 * l.mu * l.normal_force / l.samples, arm = l.arm + c;
  return {each * sum / arm, each * (rate * arm - sum)};
}

}  // namespace

LimitLoad limit_load(const EccentricLoad& l) {
  // Σ distance is convex in c, so the slope's sign changes once: from − to +.
  double low = 0, high = l.radius;
  for (int i = 0; i < 60 && ratio(l, high).slope < 0; ++i) high *= 2;
  for (double m = 0.5 * (low + high); m > low && m < high; m = 0.5 * (low + high))
    (ratio(l, m).slope < 0 ? low : high) = m;
  return {ratio(l, high).value, high};
}

}  // namespace handhold::closed_form
