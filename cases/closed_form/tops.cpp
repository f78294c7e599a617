// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/tops.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include "cases/closed_form/quadrature.hpp"
#include "cases/model/defect.hpp"

namespace handhold::closed_form {
namespace {

/// The elliptic motion of a top, about axis 3 (or, swapped, axis 1).
struct Ellipse {
  bool swapped{};
  double p{}, m{};    // rate [rad/s], parameter k²
  double w2{};        // amplitude A2 [rad/s]
  double momentum{};  // L
};

Ellipse ellipse(const AsymmetricTop& top) {
  const Eigen::Vector3d& I = top.moments;
  const double E2 = I[0] * top.w1 * top.w1 + I[2] * top.w3 * top.w3;  // 2 E
  const double L2 = std::pow(I[0] * top.w1, 2) + std::pow(I[2] * top.w3, 2);
  // (I3 − I2)(L² − 2 E I1) and (I2 − I1)(2 E I3 − L²), without the cancellation: ω2 = 0 at the start.
  const double about3 = (I[2] - I[1]) * I[2] * (I[2] - I[0]) * top.w3 * top.w3;
  const double about1 = (I[1] - I[0]) * I[0] * (I[2] - I[0]) * top.w1 * top.w1;
  Ellipse e;
  e.swapped = L2 < E2 * I[1];
  e.p = std::sqrt(std::max(about1, about3) / (I[0] * I[1] * I[2]));
  e.m = std::min(about1, about3) / std::max(about1, about3);
  e.w2 = (I[2] - I[0]) / I[1] * top.w1 * top.w3 / e.p;  // from ω2' = (I3 − I1)/I2 ω3 ω1 at t = 0
  e.momentum = std::sqrt(L2);
  return e;
}

/// φ' of the precession about L.
double precession_rate(const AsymmetricTop& top, double t) {
  const Eigen::Vector3d w = rates(top, t);
  const Eigen::Vector3d& I = top.moments;
  const double a = I[0] * w[0] * w[0] + I[1] * w[1] * w[1];
  const double b = std::pow(I[0] * w[0], 2) + std::pow(I[1] * w[1], 2);
  return ellipse(top).momentum * a / b;
}

/// From 0 to t, in pieces of a 64th of the period: a flip is short against it.
double precession(const AsymmetricTop& top, double t) {
  const auto rate = [&](double x) { return precession_rate(top, x); };
  const double piece = period(top) / 64;
  double angle = 0, from = 0;
  for (; from + piece < t; from += piece) angle += gauss_legendre(rate, from, from + piece);
  return angle + gauss_legendre(rate, from, t);
}

/// Attitude of the body in a frame with z along L; L sin θ sin ψ = I1 ω1, L sin θ cos ψ = I2 ω2, L cos θ = I3 ω3.
Eigen::Matrix3d from_momentum(const AsymmetricTop& top, double t) {
  const Eigen::Vector3d L = top.moments.cwiseProduct(rates(top, t));
  const double theta = std::atan2(std::hypot(L[0], L[1]), L[2]), psi = std::atan2(L[0], L[1]);
  return (Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(psi, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

}  // namespace

Eigen::Vector3d rates(const SymmetricTop& top, double t) {
  const double angle = (top.along - top.across) / top.across * top.spin * t;
  return {top.wobble * std::cos(angle), top.wobble * std::sin(angle), top.spin};
}

Eigen::Matrix3d attitude(const SymmetricTop& top, double t) {
  const Eigen::Vector3d L(top.across * top.wobble, 0, top.along * top.spin);
  const double own = top.spin * (1 - top.along / top.across) * t;
  return (Eigen::AngleAxisd(L.norm() * t / top.across, L.normalized()) *
          Eigen::AngleAxisd(own, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

Eigen::Vector3d rates(const AsymmetricTop& top, double t) {
  const Ellipse e = ellipse(top);
  double sn = 0, cn = 0, dn = 0;
  const double turns = std::remainder(e.p * t, e.p * period(top));  // the library is exact near zero only
  gsl_sf_elljac_e(turns, e.m, &sn, &cn, &dn);
  return {top.w1 * (e.swapped ? DEFECT(swapped_top, dn, cn) : cn), e.w2 * sn,
          top.w3 * (e.swapped ? DEFECT(swapped_top, cn, dn) : dn)};
}

double period(const AsymmetricTop& top) {
  const Ellipse e = ellipse(top);
  return 4 * gsl_sf_ellint_Kcomp(std::sqrt(e.m), GSL_PREC_DOUBLE) / e.p;
}

Eigen::Matrix3d attitude(const AsymmetricTop& top, double t) {
  const Eigen::AngleAxisd about(precession(top, t), Eigen::Vector3d::UnitZ());
  return from_momentum(top, 0).transpose() * about.toRotationMatrix() * from_momentum(top, t);
}

}  // namespace handhold::closed_form
