// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/horizon.hpp"

#include <algorithm>

namespace handhold::compare {
namespace {

/// Of any of its points between two poses, at most [m].
double distance(const Body& body, const Pose& a, const Pose& b) {
  const Eigen::AlignedBox3d bounds = body.field->bounds();
  const double reach = bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).norm();
  return (a.p - b.p).norm() + a.R.angularDistance(b.R) * reach;
}

Scene beside(const Scene& scene) {
  Scene other = scene;
  const auto moves = [](const Body& body) { return body.mobility != Mobility::fixed; };
  auto body = std::find_if(other.bodies.begin(), other.bodies.end(), moves);
  if (body == other.bodies.end()) body = other.bodies.begin();
  body->X_WO.p += horizon_shift * Eigen::Vector3d::Ones().normalized();
  return other;
}

}  // namespace

Horizon horizon(const Scene& scene, const Recording& run, const Recording& beside) {
  Horizon h;
  const std::size_t frames = std::min(run.frames.size(), beside.frames.size());
  for (std::size_t i = 0; i < frames && !h.forks; ++i) {
    const Frame &a = run.frames[i], &b = beside.frames[i];
    double apart = 0;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      const double d = distance(scene.bodies[k], a.bodies[k].X_WO, b.bodies[k].X_WO);
      h.forks = h.forks || !(d <= horizon_fork);  // also if it is not a number
      apart = std::max(apart, d);
    }
    if (!h.forks) h.t = a.t, h.apart = std::max(h.apart, apart);
  }
  return h;
}

Horizon horizon(const Scene& scene, const Engine& engine, const EngineOptions& options, const Recording& run,
                const Progress& progress) {
  return horizon(scene, run, engine.play(beside(scene), options, progress));
}

}  // namespace handhold::compare
