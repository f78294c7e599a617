// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/jenkins_loop.hpp"

#include <algorithm>

namespace handhold::closed_form {

double yield_lag(const JenkinsLoop& l) { return l.mu * l.normal_force / l.stiffness; }

double loss_per_cycle(const JenkinsLoop& l) {
  return 4 * l.mu * l.normal_force * std::max(0.0, l.amplitude - yield_lag(l));
}

double greatest_force(const JenkinsLoop& l) { return std::min(l.stiffness * l.amplitude, l.mu * l.normal_force); }

double returning_force(const JenkinsLoop& l, double x) {
  return std::max(greatest_force(l) - l.stiffness * (l.amplitude - x), -l.mu * l.normal_force);
}

double reversal_distance(const JenkinsLoop& l) { return 2 * yield_lag(l); }

}  // namespace handhold::closed_form
