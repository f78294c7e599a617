#include "realtime/contacts.hpp"

namespace handhold::realtime {
namespace {

const GivenPatch* find_given(const Hand& hand, int phalanx) {
  for (const GivenPatch& given : hand.given)
    if (given.phalanx == phalanx) return &given;
  return nullptr;
}

void resize(Contacts& contacts, std::size_t size) {
  contacts.id.resize(size);
  contacts.mode.assign(size, Mode::apart);
  contacts.p_P.resize(size);
  contacts.C_O.resize(size);
  contacts.n_O.resize(size);
  contacts.lag_O.resize(size);
  contacts.f_W.resize(size);
  contacts.depth.assign(size, 0);
  contacts.near.assign(size, 0);
}

}  // namespace

Contacts make_contacts(const Scene& scene) {
  Contacts contacts;
  int next = 0;
  for (std::size_t hand = 0; hand < scene.hands.size(); ++hand)
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      const GivenPatch* given = find_given(scene.hands[hand], phalanx);
      if (!given && !scene.hands[hand].given.empty()) continue;
      for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const int count = given ? int(given->p_P.size()) : scene.patch.samples;
        contacts.patches.push_back({int(hand), phalanx, int(body), next, count, given != nullptr, given != nullptr});
        next += count;
      }
    }
  resize(contacts, std::size_t(next));
  for (const PatchSlot& patch : contacts.patches)
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      contacts.id[slot] = {std::uint8_t(patch.hand), std::uint8_t(patch.phalanx), std::uint8_t(patch.body),
                           std::uint8_t(i)};
      if (patch.given) contacts.p_P.set(slot, find_given(scene.hands[patch.hand], patch.phalanx)->p_P[i]);
    }
  return contacts;
}

}  // namespace handhold::realtime
