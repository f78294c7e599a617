// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/printed_grasp.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

double cos_turn(const SpringFrames& s) { return 1 - spring_number(s) / 2; }

double pinch_stiffness(const PrintedPinch& p) { return p.samples * p.face.gamma; }

}  // namespace

double spring_number(const SpringFrames& s) { return s.stiffness * s.frame * s.frame / s.mass; }

double spring_rate(const SpringFrames& s) { return std::sqrt(s.stiffness / s.mass); }

double attracted_depth(const SpringFrames& s, double first_depth, int n) {
  const double turn = std::acosh(1 + spring_number(s) / 2);
  return first_depth * std::cosh((n + 0.5) * turn) / std::cosh(turn / 2);
}

double repelled_depth(const SpringFrames& s, double first_depth, int n) {
  const double turn = std::acos(cos_turn(s));
  return first_depth * std::cos((n + 0.5) * turn) / std::cos(turn / 2);
}

double explicit_growth(const SpringFrames& s) { return std::sqrt(1 + spring_number(s)); }
double delayed_growth(const SpringFrames& s) { return std::sqrt(1 + spring_number(s)); }
double held_growth(const SpringFrames& s, int substeps) {
  return std::sqrt(1 + spring_number(s) * (substeps - 1) / (2 * substeps));
}
double exact_hold_growth(const SpringFrames& s) { return std::sqrt(1 + spring_number(s) / 2); }

double least_stable_mass(double stiffness, double frame) { return stiffness * frame * frame / 4; }

double released_lag(const SpringFrames& s, double gravity, int n) {
  const double turn = std::acos(cos_turn(s));
  return s.mass * gravity / s.stiffness * (1 - std::cos((n + 0.5) * turn) / std::cos(turn / 2));
}

double largest_released_lag(const SpringFrames& s, double gravity) {
  return s.mass * gravity / s.stiffness * (1 + 1 / std::sqrt(1 - least_stable_mass(s.stiffness, s.frame) / s.mass));
}

std::optional<MassWindow> release_window(double stiffness, double frame, double gravity, double static_lag) {
  const double least = least_stable_mass(stiffness, frame);
  const double a = static_lag * stiffness / (least * gravity);
  if (a < 4) return std::nullopt;
  const double root = std::sqrt(1 - 4 / a), u = (1 + root) / 2, v = (1 - root) / 2;
  return MassWindow{least / (1 - v * v), least / (1 - u * u)};
}

double release_mass(double stiffness, double gravity, double static_lag) {
  return static_lag * stiffness / (2 * gravity);
}

PinchFrame next_pinch(const PrintedPinch& p, const PinchFrame& before) {
  const PrintedFace& f = p.face;
  PinchFrame next = before;
  double force = 0;
  next.slips = false;
  if (f.depth > 0) {
    next.slips = std::abs(before.lag) > f.friction.mu_static * f.depth;
    const double after = next.slips ? contraction(f) * before.lag : before.lag;
    const double used = p.order == FrameOrder::force_first ? before.lag : after;
    force = pinch_stiffness(p) * used * (next.slips ? f.friction.mu_dynamic : 1);
    next.lag = after;
  }
  next.speed += f.frame * (p.gravity - force / p.mass);
  next.fall += f.frame * next.speed;
  next.lag += f.frame * next.speed;
  return next;
}

double terminal_speed(const PrintedPinch& p) {
  const PrintedFace& f = p.face;
  const double v =
      p.mass * p.gravity * f.offset / (pinch_stiffness(p) * f.friction.mu_dynamic * f.frame * (f.depth + f.offset));
  return p.order == FrameOrder::force_first ? v : v / contraction(f);
}

double holding_mass(const PrintedPinch& p) {
  return pinch_stiffness(p) * p.face.friction.mu_static * p.face.depth / p.gravity;
}

double sliding_mass(const PrintedPinch& p) { return p.face.friction.mu_dynamic * holding_mass(p); }

double opening_onset(const PrintedPinch& p, double rate) {
  const double onset_depth = p.mass * p.gravity / (pinch_stiffness(p) * p.face.friction.mu_static);
  return (p.face.depth - onset_depth) / rate;
}

double opening_creep(const PrintedPinch& p, double rate) {
  const PrintedFace& f = p.face;
  const double onset_depth = p.mass * p.gravity / (pinch_stiffness(p) * f.friction.mu_static);
  return p.mass * p.gravity * f.offset / (pinch_stiffness(p) * f.friction.mu_dynamic * f.frame * rate) *
         std::log((onset_depth + f.offset) / f.offset);
}

double drag_lag_speed(const PrintedDrag& d) {
  const PrintedFace& f = d.face;
  const double load = d.mu_table * (d.samples * f.gamma * f.depth + d.mass * d.gravity);
  return load * f.offset / (d.samples * f.friction.mu_dynamic * f.gamma * f.frame * (f.depth + f.offset));
}

bool drag_slides(const PrintedDrag& d) { return drag_lag_speed(d) > steady_slide_speed(d.face); }

double dead_time(double radius, double speed) { return radius / speed; }

double largest_pull(double gamma, int samples, double radius) { return gamma * samples * radius; }

double holding_penetration(const PrintedPinch& p, double radius) {
  return radius + p.mass * p.gravity / (pinch_stiffness(p) * p.face.friction.mu_static);
}

}  // namespace handhold::closed_form
