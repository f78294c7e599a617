// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/layout.hpp"

#include <algorithm>
#include <cstdint>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_slots = 100'000;  // a state of 100 MB with the copies the integrator makes

double reach_of(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

void bound(const std::vector<Vector3d>& points, Pad& pad) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  pad.middle = box.center();
  for (const Vector3d& p : points) pad.reach = std::max(pad.reach, (p - pad.middle).norm());
}

/// `points`: null if seeded. `starts`: null or empty if none.
void add_pad(Pad pad, int count, const std::vector<Vector3d>* points, const std::vector<SampleStart>* starts,
             Layout& layout) {
  pad.first = int(layout.id.size());
  pad.count = count;
  pad.given = points != nullptr;
  if (points) bound(*points, pad);
  if (layout.id.size() + std::size_t(count) > most_slots)
    throw InputError(fmt::format(
        "scene: more than {} samples, counting every one once for each body it can touch (space surface samples wider)",
        most_slots));
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    layout.id.push_back({std::uint8_t(pad.hand), std::uint8_t(pad.carrier), std::uint8_t(pad.body), std::uint8_t(i)});
    layout.pad_of.push_back(int(layout.pads.size()));
    layout.given_p_P.push_back(points ? (*points)[i] : Vector3d::Zero());
    layout.start.push_back(starts && !starts->empty() ? &(*starts)[i] : nullptr);
  }
  layout.pads.push_back(pad);
}

void add_phalanx(int h, int phalanx, const Scene& scene, Layout& layout) {
  const Hand& hand = scene.hands[std::size_t(h)];
  for (int body = 0; body < int(scene.bodies.size()); ++body) {
    Pad pad;
    pad.hand = h;
    pad.carrier = phalanx;
    pad.body = body;
    for (const GivenPatch& patch : hand.given)
      if (patch.phalanx == phalanx) add_pad(pad, int(patch.p_P.size()), &patch.p_P, &patch.start, layout);
    if (!hand.given.empty()) continue;
    pad.reach = reach_of(hand.motion->model().shape(phalanx));
    add_pad(pad, scene.patch.samples, nullptr, nullptr, layout);
  }
}

void add_body(int source, const Scene& scene, Layout& layout) {
  const Body& from = scene.bodies[std::size_t(source)];
  if (from.samples_O.empty()) return;
  for (int body = 0; body < int(scene.bodies.size()); ++body) {
    const bool both_fixed =
        from.mobility == Mobility::fixed && scene.bodies[std::size_t(body)].mobility == Mobility::fixed;
    if (body == source || both_fixed) continue;
    Pad pad;
    pad.hand = SampleId::of_body;
    pad.carrier = source;
    pad.body = body;
    add_pad(pad, int(from.samples_O.size()), &from.samples_O, nullptr, layout);
  }
}

}  // namespace

Layout make_layout(const Scene& scene) {
  Layout layout;
  for (int h = 0; h < int(scene.hands.size()); ++h)
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) add_phalanx(h, phalanx, scene, layout);
  for (int source = 0; source < int(scene.bodies.size()); ++source) add_body(source, scene, layout);
  return layout;
}

}  // namespace handhold::reference
