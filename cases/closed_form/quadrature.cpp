// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/quadrature.hpp"

#include <memory>

#include <gsl/gsl_integration.h>

namespace handhold::closed_form {

double gauss_legendre(const std::function<double(double)>& f, double a, double b) {
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(128), gsl_integration_glfixed_table_free);
  double sum = 0;
  for (std::size_t i = 0; i < table->n; ++i) {
    double x = 0, weight = 0;
    gsl_integration_glfixed_point(a, b, i, &x, &weight, table.get());
    sum += weight * f(x);
  }
  return sum;
}

}  // namespace handhold::closed_form
