// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace handhold::testing {

using State = std::vector<double>;
using Rates = std::function<State(double t, const State& y)>;
using Event = std::function<double(double t, const State& y)>;

struct Point {
  double t{};
  State y{};
};

/// Integrates y' = rates(t, y) from `start` to time `end` (GSL, Runge-Kutta Prince-Dormand 8(9), absolute and relative
/// 1e-13): the independent computation that every closed form is checked against.
[[nodiscard]] Point integrate(const Rates& rates, const Point& start, double end);

/// The same until `event` rises through 0, located by bisection on re-integrated states to the last bit of t.
[[nodiscard]] Point integrate_until(const Rates& rates, const Point& start, const Event& event, double longest);

}  // namespace handhold::testing
