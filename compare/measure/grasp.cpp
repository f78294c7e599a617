// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace handhold::compare {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The larger one; NaN if either is, where std::max would drop it.
double larger(double a, double b) { return b > a || std::isnan(b) ? b : a; }

bool touches(const ContactState& c) { return c.mode != Mode::apart; }

bool touching(const Frame& frame) { return std::ranges::any_of(frame.contacts, touches); }

int phalanges_touching(const Frame& frame) {
  std::set<std::pair<int, int>> seen;
  for (const ContactState& c : frame.contacts)
    if (touches(c)) seen.insert({c.id.hand, c.id.phalanx});
  return int(seen.size());
}

int count(const Recording& recording, EventKind kind) {
  return int(std::ranges::count_if(recording.events, [&](const Event& e) { return e.kind == kind; }));
}

/// The longest way that one sample's anchor has gone on the object, seen from frame to frame. Only between frames that
/// both show it in contact: apart, an anchor follows the sample without friction, and a new touch starts elsewhere.
double longest_slip(const Recording& recording) {
  struct Track {
    Eigen::Vector3d C_O{Eigen::Vector3d::Zero()};
    double path{};
    std::size_t frame{};
  };
  std::map<SampleId, Track> tracks;
  double longest = 0;
  for (std::size_t i = 0; i < recording.frames.size(); ++i)
    for (const ContactState& c : recording.frames[i].contacts) {
      if (!touches(c)) continue;
      const Eigen::Vector3d C_O = recording.frames[i].bodies[c.id.body].X_WO.inverse() * c.C_W;
      auto [found, fresh] = tracks.try_emplace(c.id);
      Track& track = found->second;
      if (!fresh && track.frame + 1 == i) track.path += (C_O - track.C_O).norm();
      track.C_O = C_O;
      track.frame = i;
      longest = larger(longest, track.path);
    }
  return longest;
}

/// Place of the object's centre of mass in the palm's frame.
Eigen::Vector3d in_hand(const Scene& scene, const Frame& frame) {
  const Pose X_WP = scene.hands.front().motion->pose(palm, frame.t);
  return X_WP.inverse() * (frame.bodies.front().X_WO * scene.bodies.front().inertia.center);
}

double elastic_lag(const Scene& scene, const Frame& frame) {
  const auto n = std::ranges::count_if(frame.contacts, touches);
  return n > 0 ? scene.bodies.front().inertia.mass * scene.gravity.norm() / (scene.contact.stiffness * double(n)) : 0;
}

}  // namespace

std::string_view to_string(Hold hold) {
  switch (hold) {
    case Hold::held:
      return "held";
    case Hold::slipped:
      return "slipped";
    case Hold::dropped:
      return "dropped";
    case Hold::never_touched:
      return "never touched";
  }
  return "?";
}

GraspSummary summarize(const Scene& scene, const Recording& recording) {
  GraspSummary s{.engine = recording.engine};
  s.touches = count(recording, EventKind::touch);
  s.breakaways = count(recording, EventKind::breakaway);
  s.resticks = count(recording, EventKind::restick);
  s.releases = count(recording, EventKind::release);
  s.frame = frame_times(recording.frame_time);
  if (recording.frames.empty()) return s;
  s.slip_distance = longest_slip(recording);
  s.energy_unexplained = energy_residual(recording);
  bool touched = false;
  const Frame* let_go = nullptr;  // the frame from which the hand alone holds the object
  for (const Frame& frame : recording.frames) {
    s.phalanges_in_contact = std::max(s.phalanges_in_contact, phalanges_touching(frame));
    for (const ContactState& c : frame.contacts)
      if (touches(c)) s.max_depth = larger(s.max_depth, c.depth);
    const bool in_contact = touching(frame);
    touched |= in_contact;
    if (in_contact) s.dropped_at.reset();
    if (touched && !in_contact && !s.dropped_at) s.dropped_at = frame.t;
    if (!let_go && frame.t >= scene.bodies.front().held_until && in_contact) let_go = &frame;
  }
  if (!touched) return s;
  const Frame& end = recording.frames.back();
  if (let_go && !scene.hands.empty()) s.drift = (in_hand(scene, end) - in_hand(scene, *let_go)).norm();
  if (let_go) s.carried = std::max(0.0, s.dropped_at.value_or(end.t) - let_go->t);
  if (!touching(end))
    s.hold = Hold::dropped;
  else
    s.hold = s.drift < 0.002 + elastic_lag(scene, end) ? Hold::held : Hold::slipped;
  return s;
}

Difference difference(const Recording& a, const Recording& b, double until) {
  Difference d{.first_divergence = nan};
  std::size_t frames = 0, pairs = 0, same = 0;
  double squares = 0;
  auto other = b.frames.begin();
  for (const Frame& frame : a.frames) {
    if (frame.t > until) break;
    while (other != b.frames.end() && other->t < frame.t - 1e-9) ++other;
    if (other == b.frames.end()) break;
    if (std::abs(other->t - frame.t) > 1e-9) continue;
    const Pose& A = frame.bodies.front().X_WO;
    const Pose& B = other->bodies.front().X_WO;
    const double gap = (A.p - B.p).norm();
    ++frames;
    squares += gap * gap;
    d.max_translation = larger(d.max_translation, gap);
    d.max_rotation = larger(d.max_rotation, A.R.angularDistance(B.R));
    if (std::isnan(d.first_divergence) && !(gap <= 1e-3)) d.first_divergence = frame.t;
    for (const ContactState& c : frame.contacts)
      for (const ContactState& e : other->contacts)
        if (c.id == e.id) {
          ++pairs;
          same += c.mode == e.mode;
        }
  }
  if (frames == 0) return {nan, nan, nan, nan, nan};
  d.rms_translation = std::sqrt(squares / double(frames));
  d.mode_agreement = pairs > 0 ? double(same) / double(pairs) : nan;
  return d;
}

}  // namespace handhold::compare
