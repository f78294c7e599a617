// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "realtime/baselines/carried_body.hpp"
#include "realtime/hand_path.hpp"

namespace handhold::realtime::baselines {

/// How far a phalanx is from a body.
struct Nearness {
  double distance{};  ///< of its skin, < 0 inside [m]; at least `nearest_reach` where nothing is near
  Eigen::Vector3d n_W{Eigen::Vector3d::Zero()};     ///< outward normal of the body there
  Eigen::Vector3d skin_W{Eigen::Vector3d::Zero()};  ///< the skin's nearest point
};

using Nearnesses = std::array<Nearness, phalanx_count>;

/// An interaction without contact forces, as the paper's study compares with (Höll et al. 2018, section 5.1): a rule
/// decides that a hand grasps a body; from then on the body follows the hand; another decides that it is let go. Until
/// then the body rests or falls. It cannot slip, be pushed or be turned between fingers.
///
/// Same stepping as World: observe, start, advance. Deterministic. One hand at a time holds a body; the lower number of
/// hands that ask in the same frame.
class Baseline {
 public:
  explicit Baseline(const Scene& scene);
  virtual ~Baseline() = default;
  Baseline(const Baseline&) = delete;
  Baseline& operator=(const Baseline&) = delete;

  /// Frames before t = 0 mean nothing to a rule that has no velocities.
  void observe(double dt, const std::vector<HandFrame>& hands);
  /// Places the hands at t = 0.
  void start(double dt, const std::vector<HandFrame>& hands);
  /// One frame of `dt` seconds, at whose end the hands are at `hands`.
  void advance(double dt, const std::vector<HandFrame>& hands);

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] std::size_t bodies() const { return bodies_.size(); }
  [[nodiscard]] BodyState state(std::size_t body) const { return bodies_[body].state(); }
  /// The hand that carries the body, −1 if none.
  [[nodiscard]] int holder(std::size_t body) const { return holder_[body]; }
  /// A phalanx inside a body is one sample: sticking while its hand carries the body, slipping otherwise; no force.
  [[nodiscard]] std::vector<ContactState> contacts() const;
  /// `touch` at a grasp, `release` when the hand lets go, in the palm's name (the rule is the hand's as a whole), since
  /// the last `advance` began.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// `hand_work` is whatever the motion took: a kinematic body has no other book.
  [[nodiscard]] Energy energy() const;

 protected:
  /// Whether `hand` takes a body that nobody holds.
  [[nodiscard]] virtual bool grasps(std::size_t body, std::size_t hand, const HandFrame& frame,
                                    const Nearnesses& near) = 0;
  /// Whether the hand that holds it lets go.
  [[nodiscard]] virtual bool releases(std::size_t body, std::size_t hand, const HandFrame& frame,
                                      const Nearnesses& near) = 0;
  /// The frame of the hand that a held body is fixed to.
  [[nodiscard]] virtual Pose grip_frame(std::size_t body, const HandFrame& frame) const = 0;

 private:
  [[nodiscard]] Nearnesses look(std::size_t body, std::size_t hand) const;
  void decide(std::size_t body, double dt);
  void report(std::size_t body, std::size_t hand, EventKind kind, double dt);

  Scene scene_;
  std::vector<CarriedBody> bodies_;
  std::vector<int> holder_;
  std::vector<HandFrame> hands_;
  std::vector<Event> events_;
  double t_{}, start_energy_{};
};

}  // namespace handhold::realtime::baselines
