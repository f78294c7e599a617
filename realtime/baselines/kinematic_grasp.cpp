// SPDX-License-Identifier: Apache-2.0
#include "realtime/baselines/kinematic_grasp.hpp"

#include <cmath>
#include <string>

#include "cases/model/input_error.hpp"

namespace handhold::realtime::baselines {

void validate(const KinematicGraspOptions& o) {
  const auto require = [](bool holds, const char* what, double given, const char* rule) {
    if (!holds) throw InputError("kinematic grasp: " + std::string(what) + "=" + std::to_string(given) + ": " + rule);
  };
  require(std::isfinite(o.stiffness) && o.stiffness > 0, "stiffness", o.stiffness, "must be above 0 (try 800 N/m)");
  require(std::isfinite(o.threshold) && o.threshold > 0, "threshold", o.threshold, "must be above 0 (try 1 N)");
  require(o.release_share >= 0 && o.release_share <= 1, "release_share", o.release_share, "must be 0 to 1 (try 0.3)");
}

KinematicGrasp::KinematicGrasp(const Scene& scene, const KinematicGraspOptions& options)
    : Baseline(scene), options_(options) {
  validate(options);
}

double KinematicGrasp::squeeze(const Nearnesses& near) const {
  double sum = 0;
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const Nearness& place : near) {
    if (!(place.distance < 0)) continue;
    const double force = -options_.stiffness * place.distance;
    sum += force;
    total -= force * place.n_W;
  }
  return (sum - total.norm()) / 2;
}

}  // namespace handhold::realtime::baselines
