// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/linear_motion.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

constexpr std::complex<double> i{0, 1};

}  // namespace

double Drive::value(double t) const {
  return constant + t * (rate + 0.5 * curvature * t) + amplitude * std::sin(frequency * t + phase);
}

double Drive::derivative(double t) const {
  return rate + curvature * t + amplitude * frequency * std::cos(frequency * t + phase);
}

Drive Drive::advanced(double ahead) const {
  return {constant + ahead * (rate + 0.5 * curvature * ahead),
          rate + curvature * ahead,
          curvature,
          amplitude,
          frequency,
          phase + frequency * ahead};
}

Forcing& Forcing::add(double factor, const Drive& drive) {
  polynomial_[0] += factor * drive.constant;
  polynomial_[1] += factor * drive.rate;
  polynomial_[2] += factor * drive.curvature / 2;
  if (drive.amplitude != 0)
    waves_.push_back({std::polar(1.0, drive.phase) * (factor * drive.amplitude), drive.frequency});
  return *this;
}

Forcing& Forcing::add_derivative(double factor, const Drive& drive) {
  polynomial_[0] += factor * drive.rate;
  polynomial_[1] += factor * drive.curvature;
  if (drive.amplitude != 0)
    waves_.push_back(
        {i * std::polar(1.0, drive.phase) * (factor * drive.amplitude * drive.frequency), drive.frequency});
  return *this;
}

Forcing& Forcing::add(double constant) {
  polynomial_[0] += constant;
  return *this;
}

ForcedSolution::ForcedSolution(const LinearEquation& equation, const Forcing& forcing) : waves_(forcing.waves()) {
  const auto& [m, c, k] = equation;
  const auto& p = forcing.polynomial();
  if (k > 0) {
    polynomial_[2] = p[2] / k;
    polynomial_[1] = (p[1] - 2 * c * polynomial_[2]) / k;
    polynomial_[0] = (p[0] - c * polynomial_[1] - 2 * m * polynomial_[2]) / k;
  } else {
    for (std::size_t n = 0; n < p.size(); ++n) polynomial_[n + 2] = p[n] / (m * double((n + 1) * (n + 2)));
  }
  for (Forcing::Wave& wave : waves_) {
    const double w = wave.frequency;
    wave.amplitude /= (k - m * w * w) + i * (c * w);
  }
}

double ForcedSolution::value(double t) const {
  double sum = 0;
  for (auto a = polynomial_.rbegin(); a != polynomial_.rend(); ++a) sum = sum * t + *a;
  for (const Forcing::Wave& wave : waves_) sum += (wave.amplitude * std::polar(1.0, wave.frequency * t)).imag();
  return sum;
}

double ForcedSolution::derivative(double t) const {
  double sum = 0;
  for (std::size_t n = polynomial_.size() - 1; n > 0; --n) sum = sum * t + double(n) * polynomial_[n];
  for (const Forcing::Wave& wave : waves_)
    sum += (i * wave.frequency * wave.amplitude * std::polar(1.0, wave.frequency * t)).imag();
  return sum;
}

LinearMotion::LinearMotion(const LinearEquation& equation, const Forcing& forcing, double begin, double x, double v)
    : forced_(equation, forcing),
      begin_(begin),
      decay_(equation.c / (2 * equation.m)),
      square_(equation.k / equation.m - decay_ * decay_),
      x_(x - forced_.value(begin)),
      v_(v - forced_.derivative(begin)) {}

LinearMotion::Basis LinearMotion::basis(double tau) const {
  const double fade = std::exp(-decay_ * tau);
  const double w = std::sqrt(std::abs(square_));
  if (w * tau < 1e-8) return {fade, fade * tau};  // the next terms are (w τ)²/2 of these: rounding
  if (square_ > 0) return {fade * std::cos(w * tau), fade * std::sin(w * tau) / w};
  // Overdamped: decay and growth must meet in the exponent, or the one underflows while the other overflows.
  const double slow = std::exp((w - decay_) * tau), fast = std::exp(-(w + decay_) * tau);
  return {0.5 * (slow + fast), 0.5 * (slow - fast) / w};
}

double LinearMotion::x(double t) const {
  const Basis b = basis(t - begin_);
  return forced_.value(t) + x_ * b.even + (v_ + decay_ * x_) * b.odd;
}

double LinearMotion::v(double t) const {
  const Basis b = basis(t - begin_);
  return forced_.derivative(t) + v_ * b.even - (decay_ * v_ + (square_ + decay_ * decay_) * x_) * b.odd;
}

Relaxation::Relaxation(double c, double k, const Forcing& forcing, double begin, double q)
    : forced_({.c = c, .k = k}, forcing), begin_(begin), rate_(k / c), q_(q - forced_.value(begin)) {}

double Relaxation::q(double t) const { return forced_.value(t) + q_ * std::exp(-rate_ * (t - begin_)); }

}  // namespace handhold::closed_form
