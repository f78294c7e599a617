// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/drawn_hand.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"
#include "compare/engine/stepped.hpp"
#include "realtime/visual_hand.hpp"

namespace handhold::compare {
namespace {

using Poses = std::array<Pose, phalanx_count>;

realtime::VisualOptions options_of(DrawnMode mode) {
  return {.mode = mode == DrawnMode::whole ? realtime::FreezeMode::whole_hand : realtime::FreezeMode::per_finger};
}

/// The body that the phalanx is deepest in, or nearest to, and that depth.
realtime::PhalanxTouch touch_of(const Scene& scene, const PhalanxShape& shape, const Pose& X_WP,
                                std::span<const Pose> X_WO) {
  realtime::PhalanxTouch touch{.depth = -std::numeric_limits<double>::infinity()};
  for (std::size_t b = 0; b < X_WO.size(); ++b) {
    const double depth = -nearest(shape, X_WO[b].inverse() * X_WP, *scene.bodies[b].field).distance;
    if (depth > touch.depth) touch = {int(b), depth};
  }
  if (!(touch.depth > 0)) touch.body = -1;
  return touch;
}

void deepen(Deepest& deepest, double depth, int phalanx, double t) {
  if (depth > deepest.depth) deepest = {depth, phalanx, t};
}

/// One hand of the scene, from frame to frame.
class Player {
 public:
  Player(const Scene& scene, std::size_t hand, DrawnMode mode, double bound)
      : scene_(scene), motion_(*scene.hands[hand].motion), bound_(bound), visual_(options_of(mode)) {}

  HandSample advance(double t, std::span<const Pose> X_WO) {
    const double dt = samples_ > 0 ? t - t_ : 0;
    t_ = t;
    ++samples_;
    const realtime::VisualInput input = look(X_WO);
    HandSample sample{.X_WP = visual_.advance(dt, input, X_WO), .confidence = 1, .tracked = input.present};
    if (!input.present) sample.confidence = 0;
    for (std::size_t b = 0; b < X_WO.size() && input.present; ++b)
      realtime::keep_out(motion_.model(), *scene_.bodies[b].field, X_WO[b], bound_, sample.X_WP);
    if (input.present) book_depths(sample.X_WP, X_WO);
    book_frozen(input.present);
    book_release(sample.X_WP, input);
    last_drawn_ = sample.X_WP;
    last_ = input;
    return sample;
  }

  [[nodiscard]] const DrawnHand& figures() const { return figures_; }

 private:
  realtime::VisualInput look(std::span<const Pose> X_WO) {
    realtime::VisualInput input{.present = motion_.present(t_)};
    for (int i = 0; i < phalanx_count && input.present; ++i) {
      const auto at = std::size_t(i);
      input.X_WP[at] = motion_.pose(i, t_);
      input.touch[at] = touch_of(scene_, motion_.model().shape(i), input.X_WP[at], X_WO);
      deepen(figures_.tracked, input.touch[at].depth, i, t_);
    }
    return input;
  }

  void book_depths(const Poses& drawn, std::span<const Pose> X_WO) {
    for (int i = 0; i < phalanx_count; ++i)
      deepen(figures_.drawn, touch_of(scene_, motion_.model().shape(i), drawn[std::size_t(i)], X_WO).depth, i, t_);
  }

  void book_frozen(bool present) {
    bool any = false;
    for (int i = 0; i < phalanx_count; ++i) any |= present && visual_.frozen(i);
    if (any && !was_frozen_) figures_.frozen.push_back({t_, t_});
    if (any || was_frozen_) figures_.frozen.back().end = t_;
    was_frozen_ = any;
  }

  void book_release(const Poses& drawn, const realtime::VisualInput& input) {
    for (std::size_t i = 0; i < phalanx_count; ++i) {
      const bool stands = visual_.frozen(int(i)), was_standing = stood_[i];
      const Eigen::Vector3d way = drawn[i].p - last_drawn_[i].p, before = way_[i];
      stood_[i] = stands;
      way_[i] = way;
      if (!input.present || !last_.present || stands) {
        gliding_[i] = false;
        continue;
      }
      if (!gliding_[i] && !was_standing) continue;
      gliding_[i] = visual_.blending(int(i));
      figures_.release_jump = std::max(figures_.release_jump, (way - before).norm());
      if (way.norm() <= figures_.release_step) continue;
      figures_.release_step = way.norm();
      figures_.tracked_step = (input.X_WP[i].p - last_.X_WP[i].p).norm();
    }
  }

  const Scene& scene_;
  const HandMotion& motion_;
  double bound_;
  realtime::VisualHand visual_;
  DrawnHand figures_{};
  std::size_t samples_{};
  double t_{};
  bool was_frozen_{false};
  std::array<bool, phalanx_count> stood_{}, gliding_{};
  Poses last_drawn_{};
  std::array<Eigen::Vector3d, phalanx_count> way_{};  // of the last frame
  realtime::VisualInput last_{};
};

}  // namespace

void check_drawable(const Scene& scene) {
  const auto prescribed = [](const Hand& hand) { return !hand.given.empty(); };
  if (!scene.hands.empty() && std::ranges::none_of(scene.hands, prescribed)) return;
  throw InputError(fmt::format("drawn hand: scene '{}' has {}: there must be a hand with a shape (take a trace)",
                               scene.name, scene.hands.empty() ? "no hand" : "prescribed samples for a hand"));
}

DrawnHands draw_hands(const Scene& scene, const Recording& recording, DrawnMode mode, double bound) {
  check_drawable(scene);
  DrawnHands out{.trace = {.name = "drawn hand", .source_frame = "m, z up, right-handed"}, .bound = bound};
  std::vector<Player> players;
  for (std::size_t h = 0; h < scene.hands.size(); ++h) {
    players.emplace_back(scene, h, mode, bound);
    out.trace.hands.push_back({scene.hands[h].motion->side(), scene.hands[h].motion->model(), {}});
  }
  for (const Frame& frame : recording.frames) {
    if (!is_finite(frame)) break;
    std::vector<Pose> X_WO;
    for (const BodyState& body : frame.bodies) X_WO.push_back(body.X_WO);
    out.trace.t.push_back(frame.t);
    for (std::size_t h = 0; h < players.size(); ++h)
      out.trace.hands[h].samples.push_back(players[h].advance(frame.t, X_WO));
  }
  for (const Player& player : players) {
    out.hands.push_back(player.figures());
    out.hands.back().bound_kept = out.hands.back().drawn.depth <= bound + 1e-6;
  }
  return out;
}

}  // namespace handhold::compare
