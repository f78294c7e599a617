// SPDX-License-Identifier: Apache-2.0
#include "realtime/baselines/baseline.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"

namespace handhold::realtime::baselines {
namespace {

double extent(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

Nearness nearness(const PhalanxShape& shape, const Pose& X_WP, const VoxelField& field, const Pose& X_WO) {
  const Pose X_OP = X_WO.inverse() * X_WP;
  const double least = field.distance(X_OP.p).distance - extent(shape) - 2 * field.grid().spacing;
  if (least > nearest_reach) return {least, Eigen::Vector3d::UnitZ(), X_WP.p};
  const Nearest place = nearest(shape, X_OP, field);
  return {place.distance, X_WO.R * place.n_O, X_WO * place.skin_O};
}

}  // namespace

Baseline::Baseline(const Scene& scene) : scene_(scene), holder_(scene.bodies.size(), -1), hands_(scene.hands.size()) {
  for (const Body& body : scene.bodies) {
    if (!body.field) throw InputError("body '" + body.name + "': has no shape (give it a voxel field)");
    bodies_.emplace_back(body);
  }
  for (const Hand& hand : scene.hands)
    if (!hand.motion) throw InputError("scene '" + scene.name + "': a hand has no motion (give it a trace)");
}

void Baseline::observe(double, const std::vector<HandFrame>& hands) { hands_ = hands; }

void Baseline::start(double dt, const std::vector<HandFrame>& hands) {
  observe(dt, hands);
  const Energy energy = this->energy();
  start_energy_ = energy.kinetic + energy.potential;
  for (std::size_t b = 0; b < bodies_.size(); ++b) decide(b, 0);
}

void Baseline::advance(double dt, const std::vector<HandFrame>& hands) {
  events_.clear();
  hands_ = hands;
  t_ += dt;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const int holder = holder_[b];
    if (holder >= 0 && hands_[std::size_t(holder)].present)
      bodies_[b].follow(grip_frame(b, hands_[std::size_t(holder)]), dt);
    else
      bodies_[b].fly(scene_.gravity, t_, dt);
    decide(b, dt);
  }
}

void Baseline::decide(std::size_t body, double dt) {
  if (scene_.bodies[body].mobility == Mobility::fixed) return;
  if (const int holder = holder_[body]; holder >= 0) {
    const auto hand = std::size_t(holder);
    const Nearnesses near = hands_[hand].present ? look(body, hand) : Nearnesses{};
    if (hands_[hand].present && !releases(body, hand, hands_[hand], near)) return;
    holder_[body] = -1;
    bodies_[body].detach();
    return report(body, hand, EventKind::release, dt);
  }
  for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
    if (!hands_[hand].present) continue;
    const Nearnesses near = look(body, hand);
    if (!grasps(body, hand, hands_[hand], near)) continue;
    holder_[body] = int(hand);
    bodies_[body].attach(grip_frame(body, hands_[hand]));
    return report(body, hand, EventKind::touch, dt);
  }
}

Nearnesses Baseline::look(std::size_t body, std::size_t hand) const {
  Nearnesses near;
  const HandModel& model = scene_.hands[hand].motion->model();
  for (int i = 0; i < phalanx_count; ++i)
    near[std::size_t(i)] =
        nearness(model.shape(i), hands_[hand].X_WP[std::size_t(i)], *scene_.bodies[body].field, bodies_[body].X_WO());
  return near;
}

void Baseline::report(std::size_t body, std::size_t hand, EventKind kind, double dt) {
  events_.push_back({t_, dt, kind, {std::uint8_t(hand), std::uint8_t(palm), std::uint8_t(body), 0}, state(body)});
}

std::vector<ContactState> Baseline::contacts() const {
  std::vector<ContactState> contacts;
  for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
    if (!hands_[hand].present) continue;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const Nearnesses near = look(body, hand);
      for (int i = 0; i < phalanx_count; ++i) {
        const Nearness& place = near[std::size_t(i)];
        if (place.distance > 0) continue;
        ContactState c;
        c.id = {std::uint8_t(hand), std::uint8_t(i), std::uint8_t(body), 0};
        c.mode = holder_[body] == int(hand) ? Mode::stick : Mode::slip;
        c.depth = -place.distance;
        c.p_W = place.skin_W;
        c.n_W = place.n_W;
        c.C_W = place.skin_W - place.distance * place.n_W;
        contacts.push_back(c);
      }
    }
  }
  std::sort(contacts.begin(), contacts.end(), [](const ContactState& a, const ContactState& b) { return a.id < b.id; });
  return contacts;
}

Energy Baseline::energy() const {
  Energy e;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    e.kinetic += bodies_[b].kinetic();
    e.potential +=
        scene_.bodies[b].inertia.mass * (bodies_[b].height(scene_.gravity) +
                                         scene_.gravity.dot(scene_.bodies[b].X_WO * scene_.bodies[b].inertia.center));
  }
  e.hand_work = e.kinetic + e.potential - start_energy_;
  return e;
}

}  // namespace handhold::realtime::baselines
