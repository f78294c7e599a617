// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/unloaded_start.hpp"

#include <cmath>
#include <limits>

namespace handhold::closed_form {
namespace {

struct Motion {
  double x{}, v{}, a{};
};

/// δ, ω0² and ω² = |ω0² − δ²| of the block on its springs.
struct Modes {
  double delta{}, square{}, omega{};
  bool rings{};

  explicit Modes(const UnloadedStart& s)
      : delta(s.damping / (2 * s.mass)),
        square(s.stiffness / s.mass),
        omega(std::sqrt(std::abs(square - delta * delta))),
        rings(square > delta * delta) {}
};

/// e^(−δt) cos ωt and e^(−δt) sin(ωt)/ω, or with cosh and sinh.
struct Decay {
  double cosine{}, sine{};

  Decay(const Modes& m, double t) {
    if (m.rings) {
      const double decay = std::exp(-m.delta * t);
      cosine = decay * std::cos(m.omega * t);
      sine = decay * std::sin(m.omega * t) / m.omega;
    } else if (m.omega == 0) {
      cosine = std::exp(-m.delta * t);
      sine = t * cosine;
    } else {
      const double slow = std::exp(-m.square / (m.delta + m.omega) * t), fast = std::exp(-(m.delta + m.omega) * t);
      cosine = 0.5 * (slow + fast);
      sine = (slow - fast) / (2 * m.omega);
    }
  }
};

double pull(const UnloadedStart& s) { return s.incline.gravity * std::sin(s.incline.slope); }

/// While it sticks.
Motion sticking(const UnloadedStart& s, double t) {
  const Modes m(s);
  const Decay d(m, t);
  const double g = pull(s);
  return {g / m.square * (1 - d.cosine - m.delta * d.sine), g * d.sine, g * (d.cosine - m.delta * d.sine)};
}

/// When x'' is least: 2 δ x'' + ω0² x' = 0.
double time_of_least_acceleration(const UnloadedStart& s) {
  const Modes m(s);
  const double up = 2 * m.delta * m.omega, down = 2 * m.delta * m.delta - m.square;
  if (m.rings) return std::atan2(up, down) / m.omega;
  return m.omega == 0 ? 2 / m.delta : std::atanh(up / down) / m.omega;
}

}  // namespace

double breakaway_time(const UnloadedStart& s) {
  const Incline& i = s.incline;
  const double held = i.gravity * (std::sin(i.slope) - i.friction.mu_static * std::cos(i.slope));
  double before = 0, after = time_of_least_acceleration(s);
  if (sticking(s, after).a >= held) return std::numeric_limits<double>::infinity();
  for (double middle = 0.5 * after; middle > before && middle < after; middle = 0.5 * (before + after))
    (sticking(s, middle).a > held ? before : after) = middle;
  return after;
}

double slip(const UnloadedStart& s, double t) {
  const double begin = breakaway_time(s);
  if (t <= begin) return sticking(s, t).x;
  const Motion at = sticking(s, begin);
  const Incline& i = s.incline;
  const double a = i.gravity * (std::sin(i.slope) - i.friction.mu_dynamic * std::cos(i.slope)), tau = t - begin;
  return at.x + at.v * tau + 0.5 * a * tau * tau;
}

}  // namespace handhold::closed_form
