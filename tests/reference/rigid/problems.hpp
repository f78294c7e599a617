// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What tests of the rigid engine share.

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/rigid.hpp"
#include "reference/rigid/rigid.hpp"

namespace handhold::reference::rigid::testing {

using namespace catalogue::rigid;

/// A run that must come to its end.
inline Trajectory run(const RigidProblem& problem, const Options& options) {
  Trajectory t = simulate(problem, options);
  if (t.outcome != Outcome::complete) throw std::runtime_error("the run stalled: " + t.note);
  return t;
}

}  // namespace handhold::reference::rigid::testing
