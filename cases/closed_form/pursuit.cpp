// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pursuit.hpp"

#include <cmath>

namespace handhold::closed_form {

// With u = tan(ψ/2) the equation is du/dθ = (u² − 2 q u + 1) / 2: a Riccati equation with constant coefficients.

double pursuit_angle(double ratio, double start, double turn) {
  const double u = std::tan(start / 2);
  const double square = ratio * ratio - 1;
  const double s = std::sqrt(std::abs(square));
  if (s * turn < 1e-7) {  // both branches tend to (u − q)' = (u − q)²/2 there; the next terms are (s θ)²
    const double gap = u - ratio;
    return 2 * std::atan(ratio + (gap - square * turn / 2) / (1 - gap * turn / 2));
  }
  if (square < 0) return 2 * std::atan(ratio + s * std::tan(s * turn / 2 + std::atan((u - ratio) / s)));
  const double low = 1 / (ratio + s), high = ratio + s;  // the roots; their product is 1
  const double r = (u - low) / (u - high) * std::exp(-s * turn);
  return 2 * std::atan((low - high * r) / (1 - r));
}

double pursuit_turn(double ratio, double start, double end) {
  const double s = std::sqrt(ratio * ratio - 1);
  const double low = 1 / (ratio + s), high = ratio + s;
  const auto quotient = [&](double psi) {
    const double u = std::tan(psi / 2);
    return (u - low) / (u - high);
  };
  return std::log(quotient(start) / quotient(end)) / s;
}

double pursuit_after_work(double ratio, double start, double work) {
  return std::asin((1 - (1 - ratio * std::sin(start)) * std::exp(-ratio * work)) / ratio);
}

}  // namespace handhold::closed_form
