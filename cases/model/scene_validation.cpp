// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "cases/model/limits.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold {
namespace {

constexpr std::size_t most_bodies = std::numeric_limits<std::uint8_t>::max();  // SampleId has one byte for each
constexpr std::size_t most_hands = SampleId::of_body;
constexpr double most_duration = 24 * 3600;  // [s]

[[noreturn]] void reject(const std::string& what) { throw InputError(what); }

void check_hand(const Hand& hand, std::size_t index, double duration) {
  const std::string who = sentence("hand ", index);
  if (!hand.motion) reject(who + ": has no motion (give it a trace)");
  const auto overlaps = [&](const Interval& i) { return i.begin <= duration && i.end >= 0; };
  const auto& presence = hand.motion->presence();
  if (std::none_of(presence.begin(), presence.end(), overlaps)) {
    reject(sentence(who, ": is never present in 0 to ", duration, " s (shift the trace, or remove the hand)"));
  }
  validate(hand.given, who);
}

}  // namespace

void validate(const Scene& scene) {
  if (!std::isfinite(scene.duration) || scene.duration <= 0) {
    reject(sentence("duration ", scene.duration, " s: must be finite and > 0 (time starts at 0)"));
  }
  if (scene.duration > most_duration) {
    reject(sentence("duration ", scene.duration, " s: at most ", most_duration, " (a day)"));
  }
  check_vector("gravity", scene.gravity, "m/s^2", most_gravity);
  validate(scene.contact);
  validate(scene.body_contact);
  validate(scene.patch);
  if (scene.bodies.empty()) reject(sentence("scene '", scene.name, "': has no body (add at least one)"));
  if (scene.bodies.size() > most_bodies) {
    reject(sentence(scene.bodies.size(), " bodies: at most ", most_bodies, " (split the scene)"));
  }
  if (scene.hands.size() > most_hands) {
    reject(sentence(scene.hands.size(), " hands: at most ", most_hands, " (split the scene)"));
  }
  std::set<std::string> names;
  for (const Body& body : scene.bodies) {
    if (body.name.empty()) reject("a body without name: every body has one (set its name)");
    validate(body, sentence("body '", body.name, "'"));
    if (!names.insert(body.name).second) {
      reject(sentence("body '", body.name, "': the name is taken (give every body its own)"));
    }
  }
  for (std::size_t i = 0; i < scene.hands.size(); ++i) check_hand(scene.hands[i], i, scene.duration);
}

}  // namespace handhold
