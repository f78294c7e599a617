// SPDX-License-Identifier: Apache-2.0
#include "realtime/detection/body_pairs.hpp"

#include <algorithm>

namespace handhold::realtime {

void BodyPairs::resize(std::size_t bodies) {
  bodies_ = bodies;
  patch_.assign(bodies * bodies, -1);
  clearance_.assign(bodies * bodies, -1);
  known_at_.assign(bodies * bodies, 0);
}

void BodyPairs::add_free(const Contacts& contacts, std::size_t first_patch) {
  free_.reserve(contacts.patches.size() - contacts.hand_patches);
  for (std::size_t i = contacts.patches.size(); i > first_patch; --i) free_.push_back(int(i - 1));
}

int BodyPairs::take(const WorldDef& def, int target, int source, Contacts& contacts) {
  const int taken = free_.back();
  free_.pop_back();
  patch_[index(target, source)] = taken;
  const std::vector<Eigen::Vector3d>& points = def.bodies[std::size_t(source)].samples_O;
  PatchSlot& patch = contacts.patches[std::size_t(taken)];
  patch.phalanx = source;
  patch.body = target;
  patch.count = int(points.size());
  patch.active = true;
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    contacts.id[slot] = {SampleId::of_body, std::uint8_t(source), std::uint8_t(target), std::uint8_t(i)};
    contacts.mode[slot] = Mode::apart;
    contacts.kept[slot] = false;
    contacts.p_P.set(slot, points[std::size_t(i)]);
    contacts.f_O.set(slot, Eigen::Vector3d::Zero());
  }
  return taken;
}

void BodyPairs::give_back(int patch, Contacts& contacts) {
  PatchSlot& slot = contacts.patches[std::size_t(patch)];
  slot.active = false;
  patch_[index(slot.body, slot.phalanx)] = -1;
  free_.push_back(patch);
}

double BodyPairs::clearance(int a, int b, std::uint32_t step) const {
  const std::size_t i = index(std::min(a, b), std::max(a, b));
  return known_at_[i] + 1 == step ? clearance_[i] : -1;
}

void BodyPairs::set_clearance(int a, int b, std::uint32_t step, double clearance) {
  const std::size_t i = index(std::min(a, b), std::max(a, b));
  clearance_[i] = clearance;
  known_at_[i] = step;
}

}  // namespace handhold::realtime
