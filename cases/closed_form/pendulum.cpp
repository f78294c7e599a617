// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pendulum.hpp"

#include <cmath>
#include <limits>

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

namespace handhold::closed_form {
namespace {

struct Jacobi {
  double sn{}, cn{}, dn{};
};

/// GSL takes the parameter m = κ².
Jacobi jacobi(double u, double modulus) {
  Jacobi j;
  gsl_sf_elljac_e(u, modulus * modulus, &j.sn, &j.cn, &j.dn);
  return j;
}

}  // namespace

double swing_from_bottom(double frequency, double spin, double t) {
  const double modulus = spin / (2 * frequency);
  return 2 * std::asin(modulus * jacobi(frequency * t, modulus).sn);
}

double swing_from_rest(double frequency, double start, double t) {
  const double modulus = std::sin(start / 2);
  const Jacobi j = jacobi(frequency * t, modulus);
  return 2 * std::asin(modulus * j.cn / j.dn);
}

double time_to_angle(double frequency, double spin, double angle) {
  const double modulus = spin / (2 * frequency);
  const double sine = std::sin(angle / 2) / modulus;
  if (!(sine <= 1)) return std::numeric_limits<double>::quiet_NaN();
  return gsl_sf_ellint_F(std::asin(sine), modulus, GSL_PREC_DOUBLE) / frequency;
}

double swing_period(double frequency, double start) {
  return 4 * gsl_sf_ellint_Kcomp(std::sin(start / 2), GSL_PREC_DOUBLE) / frequency;
}

}  // namespace handhold::closed_form
