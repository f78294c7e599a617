// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <vector>

namespace handhold::closed_form {

// Serve slider_oscillator.hpp, whose cases are G01, C04 and the like; no case asks them directly.

/// A prescribed function of time: constant + rate t + curvature t²/2 + amplitude sin(frequency t + phase). Units are
/// those of what it drives (N for a force, m for a place) and seconds.
struct Drive {
  double constant{}, rate{}, curvature{};
  double amplitude{}, frequency{}, phase{};

  [[nodiscard]] double value(double t) const;
  [[nodiscard]] double derivative(double t) const;

  /// The same, `ahead` seconds earlier: value(t) of the result is value(t + ahead) of this.
  [[nodiscard]] Drive advanced(double ahead) const;
};

/// A sum of drives and their derivatives: the right-hand side of a linear equation.
class Forcing {
 public:
  /// Adds factor · drive.
  Forcing& add(double factor, const Drive& drive);
  /// Adds factor · d(drive)/dt.
  Forcing& add_derivative(double factor, const Drive& drive);
  Forcing& add(double constant);

  /// A wave: the imaginary part of amplitude · e^(i frequency t).
  struct Wave {
    std::complex<double> amplitude{};
    double frequency{};
  };
  [[nodiscard]] const std::array<double, 3>& polynomial() const { return polynomial_; }  ///< of 1, t, t²
  [[nodiscard]] const std::vector<Wave>& waves() const { return waves_; }

 private:
  std::array<double, 3> polynomial_{};
  std::vector<Wave> waves_{};
};

/// Coefficients of m x'' + c x' + k x = f(t). Either k > 0, or c = k = 0 < m.
struct LinearEquation {
  double m{}, c{}, k{};
};

/// The forced solution of a linear equation, by undetermined coefficients. Undamped resonance (k = m ω²) has none and
/// gives infinities.
class ForcedSolution {
 public:
  ForcedSolution() = default;
  ForcedSolution(const LinearEquation& equation, const Forcing& forcing);

  [[nodiscard]] double value(double t) const;
  [[nodiscard]] double derivative(double t) const;

 private:
  std::array<double, 5> polynomial_{};
  std::vector<Forcing::Wave> waves_{};
};

/// x(t) of m x'' + c x' + k x = f(t), m > 0, from x and x' at `begin`: any damping, also critical and none, also k = 0.
class LinearMotion {
 public:
  LinearMotion() = default;
  LinearMotion(const LinearEquation& equation, const Forcing& forcing, double begin, double x, double v);

  [[nodiscard]] double x(double t) const;
  [[nodiscard]] double v(double t) const;

 private:
  /// e^(−δτ) cos ωτ and e^(−δτ) sin(ωτ)/ω, or their hyperbolic or critical likes.
  struct Basis {
    double even{}, odd{};
  };
  [[nodiscard]] Basis basis(double tau) const;

  ForcedSolution forced_{};
  double begin_{}, decay_{}, square_{};  // δ [1/s]; ω² [1/s²], negative when overdamped
  double x_{}, v_{};                     // of the free solution at `begin`
};

/// q(t) of c q' + k q = f(t), c, k > 0, from q at `begin`.
class Relaxation {
 public:
  Relaxation() = default;
  Relaxation(double c, double k, const Forcing& forcing, double begin, double q);

  [[nodiscard]] double q(double t) const;

 private:
  ForcedSolution forced_{};
  double begin_{}, rate_{}, q_{};
};

}  // namespace handhold::closed_form
