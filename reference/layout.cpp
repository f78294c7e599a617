#include "reference/layout.hpp"

#include <algorithm>
#include <cstdint>

namespace handhold::reference {
namespace {

double reach_of(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

void add_pad(int hand, int phalanx, const Scene& scene, const GivenPatch* given, Layout& layout) {
  const int first = int(layout.id.size());
  const int count = given ? int(given->p_P.size()) : scene.patch.samples;
  const double reach = reach_of(scene.hands[std::size_t(hand)].motion->model().shape(phalanx));
  for (int i = 0; i < count; ++i) {
    layout.id.push_back({std::uint8_t(hand), std::uint8_t(phalanx), 0, std::uint8_t(i)});
    layout.pad_of.push_back(int(layout.pads.size()));
    layout.given_p_P.push_back(given ? given->p_P[std::size_t(i)] : Eigen::Vector3d::Zero());
    layout.start.push_back(given && !given->start.empty() ? &given->start[std::size_t(i)] : nullptr);
  }
  layout.pads.push_back({hand, phalanx, first, count, given != nullptr, reach});
}

}  // namespace

Layout make_layout(const Scene& scene) {
  Layout layout;
  for (int h = 0; h < int(scene.hands.size()); ++h) {
    const std::vector<GivenPatch>& given = scene.hands[std::size_t(h)].given;
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      if (given.empty()) add_pad(h, phalanx, scene, nullptr, layout);
      for (const GivenPatch& patch : given)
        if (patch.phalanx == phalanx) add_pad(h, phalanx, scene, &patch, layout);
    }
  }
  return layout;
}

}  // namespace handhold::reference
