// SPDX-License-Identifier: Apache-2.0
#include "realtime/gamma.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/model/defect.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::realtime {
namespace {

constexpr double most_of_edge = 0.1;

void require(bool holds, const char* what, double given, const char* rule) {
  if (!holds) throw InputError("grasp demand: " + std::string(what) + "=" + std::to_string(given) + ": " + rule);
}

bool positive(double x) { return std::isfinite(x) && x > 0; }

}  // namespace

void validate(const GraspDemand& d) {
  require(positive(d.mass), "mass", d.mass, "must be above 0 kg (give the object's mass)");
  require(std::isfinite(d.volume) && d.volume >= 0, "volume", d.volume, "must not be negative (0: not known)");
  require(positive(d.mu_static), "mu_static", d.mu_static, "must be above 0 (nothing holds without friction)");
  require(d.samples >= 1, "samples", d.samples, "must be at least 1 (a pinch of two phalanges has 16)");
  require(positive(d.depth), "depth", d.depth, "must be above 0 m (try 0.003)");
  require(std::isfinite(d.margin) && d.margin >= 1, "margin", d.margin, "must be at least 1 (3 is the default)");
  require(positive(d.gravity), "gravity", d.gravity, "must be above 0 (9.81 m/s^2 on earth)");
}

double working_depth(const GraspDemand& d) {
  validate(d);
  return d.volume > 0 ? std::min(d.depth, most_of_edge * std::cbrt(d.volume)) : d.depth;
}

double auto_stiffness(const GraspDemand& d) {
  return d.margin * d.mass * d.gravity / (d.mu_static * d.samples * working_depth(d));
}

double auto_damping(const GraspDemand& d, double stiffness, double ratio) {
  return 2 * ratio * std::sqrt(d.mass * DEFECT(damping_of_one_sample, d.samples, 1) * stiffness) / d.samples;
}

double spring_number(const GraspDemand& d, double dt) {
  return d.margin * d.gravity * dt * dt / (d.mu_static * working_depth(d));
}

}  // namespace handhold::realtime
