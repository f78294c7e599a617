// SPDX-License-Identifier: Apache-2.0
#include "realtime/world.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "cases/model/input_error.hpp"

namespace handhold::realtime {
namespace {

constexpr double most_pieces = 16;

}  // namespace

void validate(const Options& options) {
  if (options.substeps < 1 || options.substeps > 1000)
    throw InputError("substeps " + std::to_string(options.substeps) + ": must be 1 to 1000");
  if (!(options.longest_turn > 0))
    throw InputError("longest turn of " + std::to_string(options.longest_turn) + " rad: must be positive");
  if (options.order != 1 && options.order != 2)
    throw InputError("order " + std::to_string(options.order) + ": must be 1 or 2");
  if (!(options.longest_bridge >= 0))
    throw InputError("longest_bridge " + std::to_string(options.longest_bridge) + " s: must be >= 0");
}

World::World(const WorldDef& def, const Options& options) : scene_(def), options_(options) {
  validate(options);
  validate(def);
  contacts_ = make_contacts(def);
  for (const Body& body : def.bodies) bodies_.push_back(make_rigid_body(body));
  rank_bodies();
  const std::size_t bodies = bodies_.size(), hands = def.hands.size();
  paths_.assign(hands, HandPath(options.longest_bridge));
  now_.resize(hands);
  next_.resize(hands);
  patches_from_.assign(hands * phalanx_count, -1);
  for (std::size_t i = contacts_.hand_patches; i > 0; --i) {
    const PatchSlot& patch = contacts_.patches[i - 1];
    patches_from_[std::size_t(patch.hand * phalanx_count + patch.phalanx)] = int(i - 1);
  }
  for (std::size_t i = 0; i < contacts_.hand_patches; ++i) {
    const PatchSlot& patch = contacts_.patches[i];
    proximity_.emplace_back(def.hands[std::size_t(patch.hand)].model.shape(patch.phalanx));
    if (patch.active) active_patches_.push_back(int(i));
  }
  broad_phase_.resize(bodies + hands * phalanx_count);
  pairs_.resize(bodies);
  pairs_.add_free(contacts_, contacts_.hand_patches);
  for (const Body& body : def.bodies) outward_.push_back(outward_of(body));
  body_pairs_.reserve(bodies * (bodies - 1) / 2);
  hand_pairs_.reserve(contacts_.hand_patches);
  candidates_.reserve(contacts_.hand_patches);
  steps_.resize(bodies);
  turned_.assign(bodies, 0);
  moved_.assign(bodies, Eigen::Vector3d::Zero());
  pushed_.assign(bodies, Eigen::Vector3d::Zero());
  foreseen_.assign(bodies, Eigen::Vector3d::Zero());
  jumped_.assign(bodies, 0);
  scheme_.resize(bodies);
  parent_.resize(bodies);
  members_.reserve(bodies);
  island_.bodies.reserve(bodies);
  solver_.reserve(int(bodies));
  resize_for_slots();
  for (const int i : by_rank_) {
    const RigidBody& body = bodies_[std::size_t(i)];
    if (body.moves()) start_height_ -= body.mass * def.gravity.dot(body.center());
  }
}

/// Sums over bodies run from low to high, whatever the order of the definition; equal bodies at equal places are all
/// one.
void World::rank_bodies() {
  by_rank_.resize(bodies_.size());
  std::iota(by_rank_.begin(), by_rank_.end(), 0);
  const auto key = [&](int i) {
    const RigidBody& body = bodies_[std::size_t(i)];
    const Eigen::Vector3d c = body.center();
    return std::make_tuple(-scene_.gravity.dot(c), c.x(), c.y(), c.z(), body.mass);
  };
  std::stable_sort(by_rank_.begin(), by_rank_.end(), [&](int i, int j) { return key(i) < key(j); });
  rank_.resize(bodies_.size());
  for (std::size_t r = 0; r < by_rank_.size(); ++r) rank_[std::size_t(by_rank_[r])] = int(r);
}

/// Room for all that there is one of by slot or by patch.
void World::resize_for_slots() {
  const std::size_t slots = contacts_.size(), patches = contacts_.patches.size();
  moments_.resize(patches);
  role_.resize(slots, Role::idle);
  near_.resize(slots);
  watched_.resize(patches);
  patch_of_slot_.assign(slots, -1);
  for (std::size_t i = 0; i < patches; ++i) {
    const PatchSlot& patch = contacts_.patches[i];
    const int end = i + 1 < patches ? contacts_.patches[i + 1].first : int(slots);
    for (int slot = patch.first; slot < end; ++slot) patch_of_slot_[std::size_t(slot)] = int(i);
  }
  active_patches_.reserve(2 * patches);
  active_.reserve(patches);
  island_.patches.reserve(patches);
  island_.slots.reserve(patches);
  island_.sliders.reserve(slots);
  slid_off_.reserve(slots);
  solver_.reserve_slots(slots);
  taken_.reserve(std::size_t(options_.substeps) * std::size_t(most_pieces));
  events_.reserve(slots * std::size_t(std::min(options_.substeps, 4)));
}

void World::observe(double dt, const std::vector<HandFrame>& hands) {
  for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(dt, hands[i]);
}

void World::start(double dt, const std::vector<HandFrame>& hands) {
  observe(dt, hands);
  place_hands(1);
  now_ = next_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) predict_body(int(i), {});
  for (const int i : active_patches_)
    if (next_[std::size_t(patch(i).hand)].present) start_given(patch(i));
  detect(0);
  find_islands();
}

/// Samples that are inside at t = 0 are in contact from the start.
void World::start_given(const PatchSlot& patch) {
  const HandDef& hand = scene_.hands[std::size_t(patch.hand)];
  const auto given = std::find_if(hand.given.begin(), hand.given.end(),
                                  [&](const GivenPatch& g) { return g.phalanx == patch.phalanx; });
  const Pose X_OW = bodies_[std::size_t(patch.body)].X_WO.inverse();
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    const SampleStart begin = given->start.empty() ? SampleStart{} : given->start[std::size_t(i)];
    const Eigen::Vector3d p_O = X_OW * point_at_start(patch, slot);
    Anchor anchor;
    const bool near = foot(*source(patch.body).field, p_O - X_OW.R * begin.lag_W, anchor);
    if (!near || (p_O - anchor.C_O).dot(anchor.n_O) >= 0) continue;  // outside: nothing to lag behind
    contacts_.C_O.set(slot, anchor.C_O);
    contacts_.n_O.set(slot, anchor.n_O);
    contacts_.mode[slot] = begin.slipping ? Mode::slip : Mode::stick;
  }
}

void World::advance(double dt, const std::vector<HandFrame>& hands) {
  events_.clear();
  observe(dt, hands);
  taken_.clear();
  const double h = dt / options_.substeps, begin = t_;
  for (int i = 0; i < options_.substeps; ++i) {
    const int pieces = pieces_of(h);
    for (int j = 1; j <= pieces; ++j) {
      const double at = i + double(j) / pieces;
      std::swap(now_, next_);
      first_substep_ = i == 0 && j == 1;
      taken_.push_back({at / options_.substeps, h / pieces});
      place_hands(taken_.back().fraction);
      lap(Phase::hands);
      substep(taken_.back().h);
      last_h_ = taken_.back().h;
      t_ = begin + dt * at / options_.substeps;
    }
  }
}

int World::pieces_of(double h) const {
  double squared = 0;  // of what may touch: turning alone is exact
  const auto look_at = [&](int body) { squared = std::max(squared, bodies_[std::size_t(body)].w.squaredNorm()); };
  for (const Active& active : active_) {
    const PatchSlot& slot = contacts_.patches[std::size_t(active.patch)];
    look_at(slot.body);
    if (slot.of_body()) look_at(slot.phalanx);
  }
  const double pieces = std::ceil(h * std::sqrt(squared) / options_.longest_turn);
  return pieces > 1 ? int(std::min(pieces, most_pieces)) : 1;
}

void World::watch(PhaseClock* clock) {
  clock_ = clock;
  solver_.watch(clock);
}

void World::place_hands(double fraction) {
  for (std::size_t hand = 0; hand < paths_.size(); ++hand) {
    next_[hand].present = paths_[hand].present();
    if (!next_[hand].present) continue;
    for (int i = 0; i < phalanx_count; ++i) next_[hand].X_WP[std::size_t(i)] = paths_[hand].pose(i, fraction);
    if (!now_[hand].present) now_[hand] = next_[hand];
  }
}

/// Where a phalanx came from in this sub-step: of a hand that is back after a short gap, from before the gap.
const Pose& World::start_pose(const PatchSlot& patch) const {
  const HandPath& path = paths_[std::size_t(patch.hand)];
  if (first_substep_ && path.is_back()) return path.last_seen(patch.phalanx);
  return now_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)];
}

void World::predict_body(int body, const Scheme& scheme) {
  const RigidBody& rigid = bodies_[std::size_t(body)];
  const auto& load = source(body).load;
  predict(rigid, scheme, scene_.gravity, load && rigid.moves() ? load(t_ + scheme.reach()) : Load{},
          rigid.held(t_ + scheme.h), steps_[std::size_t(body)]);
}

void World::substep(double h) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) predict_body(int(i), {.h = h});
  lap(Phase::bodies);
  release_slid_off(h);
  release_lost_hands(h);
  detect(h);
  lap(Phase::detection);
  find_islands();
  std::size_t member = 0, patch = 0;
  while (member < members_.size()) {
    const int island = members_[member].first;
    island_.bodies.clear();
    island_.patches.clear();
    island_.slots.clear();
    for (; member < members_.size() && members_[member].first == island; ++member) {
      const int body = by_rank_[std::size_t(members_[member].second)];
      if (bodies_[std::size_t(body)].moves()) island_.bodies.push_back(body);
    }
    for (; patch < active_.size() && active_[patch].island == island; ++patch) add_to_island(active_[patch].patch);
    lap(Phase::islands);
    step_island(h);
  }
}

/// Patches come sorted, those between the same two bodies in a row.
void World::add_to_island(int index) {
  const PatchSlot& slot = patch(index);
  const int from = slot.of_body() ? slot.phalanx : -1;
  std::vector<PatchStep>& steps = island_.patches;
  if (steps.empty() || steps.back().target != slot.body || steps.back().source != from)
    steps.push_back({.target = slot.body, .source = from, .first_patch = int(island_.slots.size())});
  ++steps.back().patch_count;
  island_.slots.emplace_back(index);
}

/// What slid off an edge has had the force of that step; it ends with it.
void World::release_slid_off(double h) {
  for (const std::size_t slot : slid_off_) let_go(slot, h);
  slid_off_.clear();
}

void World::release_lost_hands(double h) {
  for (const int i : active_patches_) {
    PatchSlot& lost = patch(i);
    if (lost.of_body() || next_[std::size_t(lost.hand)].present) continue;
    for (int k = 0; k < lost.count; ++k) let_go(lost.slot(k), h);
    if (!lost.given) drop(lost);
  }
}

}  // namespace handhold::realtime
