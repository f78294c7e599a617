// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/hand_frame.hpp"
#include "cases/model/recording.hpp"
#include "realtime/contact/contacts.hpp"
#include "realtime/detection/body_pairs.hpp"
#include "realtime/detection/broad_phase.hpp"
#include "realtime/detection/proximity.hpp"
#include "realtime/detection/surface.hpp"
#include "realtime/hand_path.hpp"
#include "realtime/phase_clock.hpp"
#include "realtime/rigid_body.hpp"
#include "realtime/solve/implicit_step.hpp"
#include "realtime/world_def.hpp"

namespace handhold::realtime {

struct Options {
  int substeps{4};  ///< a frame, 1 to 1000
  /// 1: implicit Euler. 2: implicit midpoint, but implicit Euler for bodies in a step in which one of their contacts
  /// changes its mode or one of them its turn by 0.02 rad, and in the next one: there is no second order across a jump,
  /// and an impact must not ring (R. Rannacher, Numer. Math. 43, 1984: damping steps after a discontinuity keep the
  /// order).
  int order{1};
  double longest_bridge{0.1};  ///< a hand that is back after no longer than this came straight [s], >= 0
  /// A sub-step in which a body would turn by more is cut into equal pieces, at most 16: what contacts change of its
  /// turn enters linearly, and would give a body energy that spins by a radian in a step [rad], > 0. Infinity: never.
  double longest_turn{0.25};
  SolverOptions solver{};
};

/// Throws InputError for values out of range.
void validate(const Options& options);

/// Outward direction at each of a body's samples, in O.
[[nodiscard]] std::vector<Eigen::Vector3d> outward_of(const Body& body);

/// The real-time path: contact detection, patches, the implicit element, rigid bodies that touch hands and each other
/// (Höll et al. 2018, sections 3.2 to 3.5, with the convergent element of docs/contact-law.md).
///
/// Deterministic: the same bits for every order of bodies in the definition and of phalanges. Nothing is allocated
/// after `start`, unless bodies have more than 32 neighbours on average, or samples change their mode more often than
/// four times a frame on average. Between two frames the hands move along HandPath.
class World {
 public:
  /// A step that was taken: to `fraction` of the frame, `h` seconds long.
  struct Step {
    double fraction{}, h{};
  };

  /// Throws InputError for a definition or options out of range (`validate`).
  World(const WorldDef& def, const Options& options);

  /// Tells where the hands were at frames before t = 0, oldest first; two of them give the first frame its velocities.
  void observe(double dt, const std::vector<HandFrame>& hands);

  /// Places the hands at t = 0, `dt` after the last frame observed; `hands` holds one frame per hand of the definition.
  void start(double dt, const std::vector<HandFrame>& hands);

  /// One frame of `dt` seconds, at whose end the hands are at `hands`.
  void advance(double dt, const std::vector<HandFrame>& hands);

  /// From now on every step tells `clock` where its time goes; null: none does.
  void watch(PhaseClock* clock);

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] const RigidBody& body() const { return bodies_.front(); }
  /// In the order of the definition.
  [[nodiscard]] const std::vector<RigidBody>& bodies() const { return bodies_; }
  [[nodiscard]] const Contacts& contacts() const { return contacts_; }
  /// The sample of a slot now, its force turned with the object to where that is now: an apart one has its anchor below
  /// it, if the surface is near.
  [[nodiscard]] ContactState contact(std::size_t slot) const;
  /// On the object over the last sub-step, in W, as the balance of momentum has it [N].
  [[nodiscard]] Eigen::Vector3d force(std::size_t slot) const;
  /// Changes of mode since the last `advance` began; times are the ends of sub-steps.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// Those of the last frame: its sub-steps, or their pieces.
  [[nodiscard]] const std::vector<Step>& steps() const { return taken_; }
  [[nodiscard]] Energy energy() const;
  /// The scheme that a body's last sub-step was done with; see Options::order.
  [[nodiscard]] Scheme scheme(std::size_t body) const { return scheme_[body]; }
  /// Solves that did not reach their tolerance, ever.
  [[nodiscard]] long unconverged() const { return unconverged_; }

 private:
  friend struct WorldTwin;  // of the tests: the same world, seen from elsewhere

  /// A patch that takes part in a step, and where in the order of sums it stands.
  struct Active {
    int island{};
    std::uint32_t key{};
    int patch{};
  };

  // world.cpp
  void rank_bodies();
  void resize_for_slots();
  void start_given(const PatchSlot& patch);
  void place_hands(double fraction);
  [[nodiscard]] int pieces_of(double h) const;
  void substep(double h);
  void add_to_island(int index);
  void lap(Phase phase) {
    if (clock_) clock_->lap(phase);
  }
  void release_lost_hands(double h);
  void release_slid_off(double h);
  void predict_body(int body, const Scheme& scheme);
  [[nodiscard]] const Pose& start_pose(const PatchSlot& patch) const;
  [[nodiscard]] const Body& source(int body) const { return scene_.bodies[std::size_t(body)]; }
  [[nodiscard]] PatchSlot& patch(int i) { return contacts_.patches[std::size_t(i)]; }

  // detection.cpp
  void detect(double h);
  void sweep(double h);
  void place_boxes(double h);
  void find_pairs();
  [[nodiscard]] bool is_far(const PatchSlot& patch, double reach, double h) const;
  [[nodiscard]] Pose end_pose(int body, double h) const;
  void watch_hand(int patch, double h);
  void seed(PatchSlot& patch, const Pose& X_OP, const Nearest& nearest);
  void drop(PatchSlot& patch);
  void watch_pair(int a, int b, double h);
  void watch_samples(int target, int from, double coming, double& clearance);
  int take_pair(int target, int from);
  void give_back(int patch);
  void find_islands();
  int root(int body);

  // island_step.cpp
  void step_island(double h);
  void prepare(const Scheme& scheme);
  void prepare_patches(PatchStep& p, const Scheme& scheme);
  [[nodiscard]] PatchMotion motion_of_hand(const PatchSlot& patch, const BodyStep& target, const Scheme& scheme) const;
  [[nodiscard]] PatchMotion motion_of_body(const BodyStep& from, const BodyStep& target, const Scheme& scheme) const;
  [[nodiscard]] bool give_roles(const PatchStep& p, const SlotStep& step, const Scheme& scheme);
  [[nodiscard]] Role role_of(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme);
  [[nodiscard]] Eigen::Vector3d free_end(const PatchStep& p, const SlotStep& step, std::size_t slot,
                                         const Scheme& scheme) const;
  [[nodiscard]] Role role_of_finger(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme,
                                    Anchor& anchor) const;
  [[nodiscard]] Role role_of_corner(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme,
                                    Anchor& anchor) const;
  [[nodiscard]] bool turns_unforeseen(const Scheme& scheme) const;
  [[nodiscard]] bool changes_mode(const Scheme& scheme) const;
  void finish(const Scheme& scheme);
  void finish_slider(const PatchStep& p, const Slider& s, const Scheme& scheme);
  void slip(const PatchStep& p, const Slider& s, const Eigen::Vector3d& reach, const Eigen::Vector3d& step);

  // bookkeeping.cpp
  void set_mode(std::size_t slot, Mode mode, double h);
  void let_go(std::size_t slot, double h);
  [[nodiscard]] Eigen::Vector3d point_at_start(const PatchSlot& patch, std::size_t slot) const;
  [[nodiscard]] double stored(std::size_t slot, const Eigen::Vector3d& p_O) const;
  void book_body(int body, const Scheme& scheme);
  void book_appearance(const Slider& s, const Eigen::Vector3d& start);
  void book_sticking(const PatchStep& p, const Scheme& scheme);
  void book_hand(int body, double power, const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                 const Scheme& scheme);

  const WorldDef scene_;
  const Options options_;
  std::vector<RigidBody> bodies_;
  std::vector<int> rank_, by_rank_;  // of a body in all sums, and the other way round
  Contacts contacts_;
  std::vector<StickMoments> moments_;  // by patch
  std::vector<Role> role_;             // by slot
  std::vector<int> patch_of_slot_;
  std::vector<std::size_t> slid_off_;  // slots to be let go as the next step begins
  std::vector<std::uint8_t> watched_;  // by patch of a pair of bodies: apart samples may touch in this step
  std::vector<std::uint8_t> near_;     // by slot of those: which
  std::vector<std::vector<Eigen::Vector3d>> outward_;  // of a body at each of its samples, in O

  std::vector<HandPath> paths_;
  std::vector<HandFrame> now_, next_;  // start and end of the sub-step
  bool first_substep_{false};
  std::vector<Proximity> proximity_;  // of every patch of a hand
  std::vector<int> patches_from_;     // by (hand, phalanx): first of its patches, one a body; -1: none

  BroadPhase broad_phase_;
  BodyPairs pairs_;
  std::vector<int> hand_pairs_;            // patches of hands whose boxes meet those of bodies
  std::vector<std::uint32_t> body_pairs_;  // bodies whose boxes meet, as rank << 16 | rank
  std::vector<int> candidates_;            // patches of hands that may come near in this step
  std::vector<int> active_patches_;
  bool regroup_{true};  // patches came or went since islands were found
  std::uint32_t step_{};

  std::vector<BodyStep> steps_;
  std::vector<double> turned_;             // by body: angle of the last step
  std::vector<Eigen::Vector3d> pushed_;    // ... change of velocity that contacts gave
  std::vector<Eigen::Vector3d> moved_;     // ... and way of the centre
  std::vector<Eigen::Vector3d> foreseen_;  // by body: velocity at the end of this step, if contacts do what they did
  double last_h_{1};                       // of that step [s]
  std::vector<std::uint8_t> jumped_;       // by body, of the second order: its next step is Euler's, see Options::order
  std::vector<Scheme> scheme_;             // by body: of its last step
  std::vector<int> parent_;                // of a body in its island
  std::vector<Active> active_;
  std::vector<std::pair<int, int>> members_;  // (island, rank), of every body
  Island island_;
  IslandSolver solver_;

  std::vector<Event> events_;
  std::vector<Step> taken_;
  double t_{};
  double hand_work_{}, dissipated_{}, start_height_{};
  long unconverged_{};
  PhaseClock* clock_{};
};

}  // namespace handhold::realtime
