// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/reference/independent/real.hpp"

namespace handhold::independent {

/// One step of Gragg's modified midpoint rule with 2, 4, ..., 2 K sub-steps, extrapolated to none (Bulirsch and Stoer):
/// order 2 K. `f(t, y, dy)`. The estimate of its error is what the last column changed, component by component.
template <typename Rhs>
class GraggBulirschStoer {
 public:
  GraggBulirschStoer(int columns, Rhs f) : columns_(columns), f_(std::move(f)), table_(std::size_t(columns)) {}

  [[nodiscard]] int order() const { return 2 * columns_; }

  /// From (t, y) with slope `dy` over h.
  void step(Real t, const State& y, const State& dy, Real h, State& out, State& error) {
    for (int k = 0; k < columns_; ++k) {
      State row = midpoint(t, y, dy, h, 2 * (k + 1));
      for (int l = 0; l < k; ++l) {  // Aitken and Neville, in (h / n)²
        const Real ratio = Real(k + 1) / Real(k - l);
        State& above = table_[std::size_t(l)];
        const State better = row + (row - above) / (ratio * ratio - 1);
        above = row;
        row = better;
      }
      if (k == columns_ - 1) error = (row - table_[std::size_t(k - 1)]).cwiseAbs();
      table_[std::size_t(k)] = row;
    }
    out = table_[std::size_t(columns_ - 1)];
  }

 private:
  State midpoint(Real t, const State& y, const State& dy, Real h, int n) {
    const Real s = h / Real(n);
    State before = y, now = y + s * dy, slope(y.size());
    for (int i = 1; i < n; ++i) {
      f_(t + Real(i) * s, now, slope);
      const State next = before + 2 * s * slope;
      before = now;
      now = next;
    }
    f_(t + h, now, slope);
    return (before + now + s * slope) / 2;
  }

  int columns_;
  Rhs f_;
  std::vector<State> table_;
};

}  // namespace handhold::independent
