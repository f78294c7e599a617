// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/catalogue/builders/changed.hpp"
#include "realtime/world.hpp"
#include "tests/realtime/scenes.hpp"

namespace handhold::realtime {

namespace testing {

using catalogue::Change;

/// A scene, changed, and with it the hands' frames.
class ChangedScene {
 public:
  ChangedScene(const Scene& scene, const Change& change) : change_(change), scene_(catalogue::changed(scene, change)) {}

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Change& change() const { return change_; }
  /// Of the hands at time `t` of the changed scene.
  [[nodiscard]] std::vector<HandFrame> frames(double t) const { return testing::frames(scene_, t); }

 private:
  Change change_;
  Scene scene_;
};

}  // namespace testing

/// Makes worlds in the state of another one, so that a single frame of a run may be compared: what an engine does of
/// itself, before chaos has had time to tell roundings apart.
struct WorldTwin {
  /// `world`, in the changed scene. `hands`: the changed scene's frames of the last four frames, the present one last.
  /// Only for sizes and weights, and numbers of phalanges, as they were: those are compared over whole runs.
  static World of(const World& world, const testing::ChangedScene& changed, double dt,
                  const std::vector<std::vector<HandFrame>>& hands) {
    const testing::Change& change = changed.change();
    World twin(world_def_of(changed.scene()), world.options_);
    for (std::size_t i = 0; i < twin.bodies_.size(); ++i) place(world.bodies_[i], change, world.t_, twin.bodies_[i]);
    twin.contacts_ = world.contacts_;
    twin.resize_for_slots();  // the pool may have grown
    Contacts& contacts = twin.contacts_;
    for (std::size_t slot = 0; slot < contacts.size(); ++slot)
      for (Vector3Array* array : {&contacts.p_P, &contacts.C_O, &contacts.n_O, &contacts.f_O})
        array->set(slot, change.own((*array)[slot]));
    for (const auto& frame : hands) twin.observe(dt, frame);
    twin.place_hands(1);
    for (std::size_t i = 0; i < twin.bodies_.size(); ++i) {
      twin.changed_[i] = change.polar(world.changed_[i]);
      twin.moved_[i] = change.polar(world.moved_[i]) + world.last_h_ * change.boost;
    }
    // Directions in bodies' frames and scalars. What the twin looks for anew are pairs, islands, moments and distances.
    twin.role_ = world.role_;
    twin.slid_off_ = world.slid_off_;
    twin.hollow_ = world.hollow_;
    twin.watched_ = world.watched_;
    twin.near_ = world.near_;
    twin.pairs_ = world.pairs_;
    twin.active_patches_ = world.active_patches_;
    twin.active_ = world.active_;
    twin.step_ = world.step_;
    twin.turned_ = world.turned_;
    twin.last_h_ = world.last_h_;
    twin.jumped_ = world.jumped_;
    twin.scheme_ = world.scheme_;
    twin.t_ = world.t_;
    twin.unconverged_ = world.unconverged_;
    return twin;
  }

  /// What a change's own rounding may make of a state, and no more.
  template <class Noise>
  static void disturb(World& world, Noise&& noise) {
    for (RigidBody& body : world.bodies_) {
      if (!body.moves()) continue;
      body.X_WO.p += noise();
      body.v += noise();
      body.w += body.w.norm() * noise();
      const Eigen::Vector3d turn = noise();
      body.X_WO.R = (rotation_by(turn) * body.X_WO.R).normalized();
    }
  }

  /// Whether any sample had this role in the last sub-step.
  static bool any(const World& world, Role role) {
    for (const PatchSlot& patch : world.contacts_.patches)
      for (int i = 0; patch.active && i < patch.count; ++i)
        if (world.role_[patch.slot(i)] == role) return true;
    return false;
  }

 private:
  static void place(const RigidBody& from, const testing::Change& change, double t, RigidBody& body) {
    body.X_WO = change.pose(from.X_WO, t);
    if (!body.moves()) return;
    body.v = change.velocity(from.v);
    body.w = change.axial(from.w);
  }
};

}  // namespace handhold::realtime
