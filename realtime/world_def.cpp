// SPDX-License-Identifier: Apache-2.0
#include "realtime/world_def.hpp"

#include "cases/model/limits.hpp"
#include "cases/model/scene.hpp"

namespace handhold::realtime {
namespace {

constexpr std::size_t most_bodies = 255;  // SampleId has one byte, and 255 hands are a body's
constexpr std::size_t most_hands = 254;

std::string name_of(const Body& body, std::size_t index) {
  return body.name.empty() ? sentence("body ", index) : sentence("body '", body.name, "'");
}

}  // namespace

void validate(const WorldDef& def) {
  if (def.bodies.empty()) throw InputError("a world without bodies: must have one (nothing can touch nothing)");
  if (def.bodies.size() > most_bodies || def.hands.size() > most_hands)
    throw InputError(sentence("a world of ", def.bodies.size(), " bodies and ", def.hands.size(),
                              " hands: at most 255 and 254 (leave some out)"));
  check_vector("gravity", def.gravity, "m/s^2", most_gravity);
  validate(def.contact);
  validate(def.body_contact);
  validate(def.patch);
  for (std::size_t i = 0; i < def.bodies.size(); ++i) validate(def.bodies[i], name_of(def.bodies[i], i));
  for (std::size_t i = 0; i < def.hands.size(); ++i) {
    validate(def.hands[i].model, sentence("hand ", i));
    validate(def.hands[i].given, sentence("hand ", i));
  }
}

WorldDef world_def_of(const Scene& scene) {
  WorldDef def{scene.gravity, scene.contact, scene.body_contact, scene.patch, scene.bodies, {}};
  for (const Hand& hand : scene.hands) def.hands.push_back({hand.motion->model(), hand.given});
  return def;
}

}  // namespace handhold::realtime
