#pragma once

#include <array>
#include <vector>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"
#include "realtime/contacts.hpp"
#include "realtime/hand_path.hpp"
#include "realtime/implicit_step.hpp"
#include "realtime/proximity.hpp"
#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

struct Options {
  int substeps{4};  ///< a frame, 1 to 1000
  SolverOptions solver{};
};

/// Throws InputError for values out of range.
void validate(const Options& options);

/// The real-time path: contact detection, patches, the implicit element, one body (Höll et al. 2018, sections 3.2
/// to 3.5, with the convergent element of docs/contact-law.md). Deterministic; nothing is allocated after `start`.
///
/// Between two frames the hands move along HandPath.
class World {
 public:
  /// Throws InputError for a scene it cannot express (this version: exactly one body).
  World(const Scene& scene, const Options& options);

  /// Tells where the hands were at frames before t = 0, oldest first; two of them give the first frame its velocities.
  void observe(double dt, const std::vector<HandFrame>& hands);

  /// Places the hands at t = 0, `dt` after the last frame observed; `hands` holds one frame per hand of the scene.
  void start(double dt, const std::vector<HandFrame>& hands);

  /// One frame of `dt` seconds, at whose end the hands are at `hands`.
  void advance(double dt, const std::vector<HandFrame>& hands);

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] const RigidBody& body() const { return body_; }
  [[nodiscard]] const Contacts& contacts() const { return contacts_; }
  [[nodiscard]] ContactState contact(std::size_t slot) const;
  /// Changes of mode since the last `advance` began; times are the ends of sub-steps.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] Energy energy() const;
  /// Sub-steps whose solve did not reach its tolerance, ever.
  [[nodiscard]] long unconverged() const { return unconverged_; }

 private:
  void place_hands(double fraction);
  void substep(double h);
  void detect(double h);
  void seed(PatchSlot& patch, const Pose& X_OP, const Nearest& nearest);
  void drop(PatchSlot& patch);
  void gather(double h, const Eigen::Vector3d& gravity);
  void scatter(double h);
  [[nodiscard]] const VoxelField& field() const;
  bool place_anchor(std::size_t slot, const Eigen::Vector3d& p_O, const Eigen::Vector3d& from_O);
  void update_anchor(std::size_t slot, const StepSample& sample, double h);
  [[nodiscard]] double stored(std::size_t slot) const;
  void set_mode(std::size_t slot, Mode mode, double h);

  const Scene scene_;
  const Options options_;
  RigidBody body_;
  Contacts contacts_;
  std::vector<HandPath> paths_;
  std::vector<Proximity> proximity_;   // of every patch slot
  std::vector<HandFrame> now_, next_;  // start and end of the sub-step
  std::vector<StepSample> samples_;    // of this sub-step, packed
  std::vector<std::size_t> slots_;     // where each of them came from
  std::vector<int> patch_of_slot_;
  std::vector<Event> events_;
  Vector6 velocity_{Vector6::Zero()};
  double t_{};
  double hand_work_{}, dissipated_{}, start_height_{};
  long unconverged_{};
};

}  // namespace handhold::realtime
