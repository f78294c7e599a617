// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/printed_law.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace handhold::closed_form {
namespace {

/// e^{iφ} − q and e^{iφ} − 1 for φ = ω dt.
std::complex<double> turned(double angle, double minus) { return std::polar(1.0, angle) - minus; }

double steady_lag(const PrintedFace& f, double v) { return v * f.frame * (f.depth + f.offset) / f.offset; }

}  // namespace

double contraction(const PrintedFace& f) { return f.depth / (f.depth + f.offset); }

PrintedSlide next_slide(const PrintedFace& f, double lag, double v, FrameOrder order) {
  const double before = lag + v * f.frame;
  if (std::abs(before) <= f.friction.mu_static * f.depth) return {before, f.gamma * before, false};
  const double after = contraction(f) * before;
  const double used = order == FrameOrder::force_first ? before : after;
  return {after, f.friction.mu_dynamic * f.gamma * used, true};
}

double sliding_lag(const PrintedFace& f, double v, double first_lag, int n) {
  const double steady = steady_lag(f, v);
  return steady + (first_lag - steady) * std::pow(contraction(f), n);
}

double steady_slide_force(const PrintedFace& f, double v, FrameOrder order) {
  const double lag = steady_lag(f, v);
  return f.friction.mu_dynamic * f.gamma * (order == FrameOrder::force_first ? lag : contraction(f) * lag);
}

double steady_slide_speed(const PrintedFace& f) {
  return f.friction.mu_static * f.depth * f.offset / (f.frame * (f.depth + f.offset));
}

double chatter_friction(const PrintedFace& f) { return f.friction.mu_static * (1 + contraction(f)) / 2; }

double chatter_error(const PrintedFace& f, double v) {
  const double q = contraction(f), x = v * f.frame, S = f.friction.mu_static * f.depth;
  const double below = (1 - f.friction.mu_dynamic) * (S + x) * x / ((1 - q) * S - q * x) - x / 2;
  return std::max(x * (q + 2) / 2, below) / (S * (1 + q) / 2);
}

double chatter_share(const PrintedFace& f, double v) { return v / steady_slide_speed(f); }

double slip_impulse(const PrintedFace& f, double v, int n, double first_lag, double last_lag) {
  const double way = n * v * f.frame + first_lag - last_lag;
  return f.friction.mu_dynamic * f.gamma * way * (f.depth + f.offset) / f.offset;
}

PatchCollapse patch_collapse(const PrintedFace& f, double radius) {
  PatchCollapse collapse{radius, 0};
  for (; collapse.radius > f.friction.mu_static * f.depth; ++collapse.frames) collapse.radius *= contraction(f);
  return collapse;
}

double stick_torque(double gamma, int samples, double radius, double angle) {
  return samples * gamma * radius * radius * std::sin(angle);
}

double spin_torque(const PrintedFace& f, int samples, double radius, double spin) {
  const double q = contraction(f), angle = spin * f.frame;
  return samples * f.friction.mu_dynamic * f.gamma * radius * radius * (1 - q) * std::sin(angle) /
         std::norm(turned(angle, q));
}

double spin_lag(const PrintedFace& f, double radius, double spin) {
  const double angle = spin * f.frame;
  return radius * std::abs(turned(angle, 1)) / std::abs(turned(angle, contraction(f)));
}

TiltedPress tilted_press(const PrintedFace& f, double slope) {
  const double pull = f.gamma * f.depth, mu_d = f.friction.mu_dynamic;
  if (std::tan(slope) <= f.friction.mu_static) return {true, pull, 0, 0};
  const double s = std::sin(slope), c = std::cos(slope);
  const double normal = pull * (c * c + mu_d * s * s), tangent = pull * (1 - mu_d) * s * c;
  return {false, normal, tangent, std::atan2(tangent, normal)};
}

double cycle_gain(const PrintedFace& f, double shear) {
  const double first = f.friction.mu_static * f.depth;
  return f.gamma * (1 - f.friction.mu_dynamic) * (shear * shear - first * first) / 2;
}

double ball_anchor(double radius, double depth, double offset, double angle) {
  const double ox = (radius + offset) * std::sin(angle), oy = (radius + offset) * std::cos(angle);
  const double wx = -ox, wy = radius - depth - oy;
  const double a = wx * wx + wy * wy, b = ox * wx + oy * wy;
  const double c = offset * (2 * radius + offset);  // (R + ε)² − R² without cancellation
  const double t = c / (-b + std::sqrt(b * b - a * c));
  return std::atan2(ox + t * wx, oy + t * wy);
}

}  // namespace handhold::closed_form
