// SPDX-License-Identifier: Apache-2.0
#include "realtime/contact/contacts.hpp"

#include <algorithm>

namespace handhold::realtime {
namespace {

const GivenPatch* find_given(const HandDef& hand, int phalanx) {
  for (const GivenPatch& given : hand.given)
    if (given.phalanx == phalanx) return &given;
  return nullptr;
}

void resize(Contacts& contacts, std::size_t size) {
  contacts.id.resize(size);
  contacts.mode.resize(size, Mode::apart);
  contacts.p_P.resize(size);
  contacts.C_O.resize(size);
  contacts.n_O.resize(size);
  contacts.from_O.resize(size);
  contacts.from_n_O.resize(size);
  contacts.face.resize(size, -1);
  contacts.hollow.resize(size);
  contacts.kept.resize(size);
  contacts.f_O.resize(size);
}

int even(int count) { return count + count % 2; }

int most_samples(const WorldDef& def) {
  std::size_t most = 0;
  for (const Body& body : def.bodies) most = std::max(most, body.samples_O.size());
  return int(most);
}

void add_pool(const WorldDef& def, std::size_t patches, Contacts& contacts) {
  const int count = most_samples(def);
  int next = int(contacts.size());
  for (std::size_t i = 0; i < patches; ++i, next += even(count))
    contacts.patches.push_back({.hand = SampleId::of_body, .first = next});
  resize(contacts, std::size_t(next));
}

/// Patches that pairs of bodies can need at one time: two a pair of neighbours. However one big body may be surrounded,
/// bodies that do not overlap have few neighbours on average: a cube in a block of cubes has 26, if edges and corners
/// count, and every other packing fewer. On top of that one body, the ground, may be near all others.
std::size_t most_pairs(std::size_t bodies) {
  constexpr std::size_t neighbours = 32;
  return std::min(bodies * (bodies - 1), neighbours * bodies + 2 * (bodies - 1));
}

}  // namespace

Contacts make_contacts(const WorldDef& def) {
  Contacts contacts;
  int next = 0;
  for (std::size_t hand = 0; hand < def.hands.size(); ++hand)
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      const GivenPatch* given = find_given(def.hands[hand], phalanx);
      if (!given && !def.hands[hand].given.empty()) continue;
      for (std::size_t body = 0; body < def.bodies.size(); ++body) {
        const int count = given ? int(given->p_P.size()) : def.patch.samples;
        contacts.patches.push_back({int(hand), phalanx, int(body), next, count, given != nullptr, given != nullptr});
        next += even(count);
      }
    }
  contacts.hand_patches = contacts.patches.size();
  resize(contacts, std::size_t(next));
  for (const PatchSlot& patch : contacts.patches)
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      contacts.id[slot] = {std::uint8_t(patch.hand), std::uint8_t(patch.phalanx), std::uint8_t(patch.body),
                           std::uint8_t(i)};
      if (patch.given) contacts.p_P.set(slot, find_given(def.hands[patch.hand], patch.phalanx)->p_P[i]);
    }
  if (most_samples(def) > 0) add_pool(def, most_pairs(def.bodies.size()), contacts);
  return contacts;
}

void grow_pool(const WorldDef& def, Contacts& contacts) {
  add_pool(def, contacts.patches.size() - contacts.hand_patches, contacts);
}

}  // namespace handhold::realtime
