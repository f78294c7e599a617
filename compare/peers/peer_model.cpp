// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/peer_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::compare::peers {
namespace {

PeerBody body_of(const Body& body, const std::vector<catalogue::SolidBox>& boxes) {
  const Eigen::Matrix3d& J = body.inertia.about_center;
  const Eigen::Matrix3d off_diagonal = J - Eigen::Matrix3d(J.diagonal().asDiagonal());
  if (boxes.empty() || !body.inertia.center.isZero(1e-9) || off_diagonal.norm() > 1e-9 * J.norm())
    throw InputError(fmt::format(
        "body '{}': needs boxes, its centre of mass at the origin and principal axes (give them in the scene)",
        body.name));
  if (body.friction.mu_static != body.friction.mu_dynamic)
    throw InputError(
        fmt::format("body '{}': these engines know one coefficient of friction (make them equal)", body.name));
  PeerBody made{.name = body.name, .role = body.mobility == Mobility::fixed ? Role::fixed : Role::free};
  made.mass = body.inertia.mass;
  made.moments = J.diagonal();
  made.mu = body.friction.mu_dynamic;
  made.X_WB = body.X_WO;
  made.V_WB = body.V_WO;
  for (const catalogue::SolidBox& box : boxes)
    made.shapes.push_back({.kind = PeerShape::Kind::box, .half_extents = box.half_extents, .X_BS = box.X_OB});
  return made;
}

PeerShape shape_of(const PhalanxShape& shape) {
  if (const PalmBox* box = std::get_if<PalmBox>(&shape))
    return {.kind = PeerShape::Kind::box, .half_extents = box->half_extents};
  const Capsule& capsule = std::get<Capsule>(shape);
  return {.kind = PeerShape::Kind::capsule, .radius = capsule.radius, .half_length = capsule.half_length};
}

}  // namespace

double PeerModel::mu(std::size_t a, std::size_t b) const {
  if (bodies[a].role == Role::driven) return bodies[b].mu;
  if (bodies[b].role == Role::driven) return bodies[a].mu;
  return std::sqrt(bodies[a].mu * bodies[b].mu);
}

PeerModel make_peer_model(const catalogue::BenchmarkScene& benchmark) {
  const Scene& scene = benchmark.scene;
  if (!scene.hands.empty() && benchmark.phalanges.empty())
    throw InputError(fmt::format("scene '{}': its patches are given, and phalanges of no shape", scene.name) +
                     " (only handhold can play it)");
  PeerModel model{.scene_bodies = scene.bodies.size(), .phalanges = benchmark.phalanges, .gravity = scene.gravity};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    model.bodies.push_back(body_of(scene.bodies[i], benchmark.boxes[i]));
    model.gravity_from = std::max(model.gravity_from, scene.bodies[i].held_until);
  }
  for (const auto& [hand, phalanx] : benchmark.phalanges) {
    const HandMotion& motion = *scene.hands[std::size_t(hand)].motion;
    PeerBody made{.name = fmt::format("hand {} {}", hand, phalanx_name(phalanx)), .role = Role::driven};
    made.shapes = {shape_of(motion.model().shape(phalanx))};
    made.X_WB = motion.pose(phalanx, 0);
    model.bodies.push_back(std::move(made));
  }
  return model;
}

}  // namespace handhold::compare::peers
