// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cases/closed_form/integrate.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

namespace handhold::testing {
namespace {

int gsl_rates(double t, const double y[], double dydt[], void* parameters) {
  const auto& [rates, size] = *static_cast<const std::pair<const Rates*, std::size_t>*>(parameters);
  const State d = (*rates)(t, State(y, y + size));
  std::copy(d.begin(), d.end(), dydt);
  return GSL_SUCCESS;
}

}  // namespace

Point integrate(const Rates& rates, const Point& start, double end) {
  std::pair<const Rates*, std::size_t> parameters{&rates, start.y.size()};
  gsl_odeiv2_system system{gsl_rates, nullptr, start.y.size(), &parameters};
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4, 1e-13, 1e-13);
  Point point = start;
  if (end > point.t && gsl_odeiv2_driver_apply(driver, &point.t, end, point.y.data()) != GSL_SUCCESS)
    ADD_FAILURE() << "GSL could not integrate to " << end;
  gsl_odeiv2_driver_free(driver);
  return point;
}

Point integrate_until(const Rates& rates, const Point& start, const Event& event, double longest) {
  const int steps = 2000;
  Point before = start;
  for (int i = 1; i <= steps; ++i) {
    const Point after = integrate(rates, before, start.t + longest * i / steps);
    if (event(after.t, after.y) <= 0) {
      before = after;
      continue;
    }
    double a = before.t, b = after.t;
    for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) {
      const Point middle = integrate(rates, before, m);
      (event(m, middle.y) > 0 ? b : a) = m;
    }
    return integrate(rates, before, b);
  }
  ADD_FAILURE() << "the event did not happen";
  return before;
}

TEST(Integrate, MatchesTheSineItMustGive) {
  const Rates oscillator = [](double, const State& y) { return State{y[1], -y[0]}; };
  const Point end = integrate(oscillator, {0, {0, 1}}, 3);
  EXPECT_NEAR(end.y[0], std::sin(3.0), 1e-11);
  const Point peak = integrate_until(
      oscillator, {0, {0, 1}}, [](double, const State& y) { return -y[1]; }, 2);
  EXPECT_NEAR(peak.t, std::acos(-1.0) / 2, 1e-11);
}

}  // namespace handhold::testing
