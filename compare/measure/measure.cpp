// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/model/defect.hpp"
#include "compare/measure/frames_measure.hpp"

namespace handhold::compare {
namespace {

using catalogue::Measure;
using Kind = Measure::Kind;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Place and velocity along an axis.
struct Along {
  double x{}, v{};
};

/// What the body is measured against, and its centre of mass.
struct Against {
  const HandMotion* hand{};
  int phalanx{palm};
  RigidPath surface{};
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};

  [[nodiscard]] Along at(double t, const Eigen::Vector3d& axis) const {
    if (hand) return {axis.dot(hand->pose(phalanx, t).p), axis.dot(hand->twist(phalanx, t).v)};
    const PathPoint s = handhold::at(surface, t);
    return {axis.dot(s.p), axis.dot(s.v)};
  }
};

template <class Item>
const Item& pick(const std::vector<Item>& items, const Measure& what) {
  return what.from_last ? items.back() : items.front();
}

Against against(const Scene& scene, const Measure& what) {
  Against out{.center_O = scene.bodies.at(std::size_t(what.body)).inertia.center};
  if (scene.hands.empty()) return out;
  const Hand& hand = pick(scene.hands, what);
  out.hand = hand.motion.get();
  if (!hand.given.empty()) out.phalanx = pick(hand.given, what).phalanx;
  return out;
}

Against against(const RigidProblem& problem, const Measure& what) {
  if (problem.supports.empty()) return {};
  const RigidSupport& support = pick(problem.supports, what);
  return {.surface = support.turn ? RigidPath() : support.motion};  // where a turning one has its origin is arbitrary
}

/// How many samples the patch has that `what` chooses one of.
int samples(const Scene& scene, const Measure& what) {
  if (what.owner >= 0) return int(scene.bodies.at(std::size_t(what.owner)).samples_O.size());
  for (const Hand& hand : scene.hands)
    for (const GivenPatch& given : hand.given)
      if (what.phalanx < 0 || given.phalanx == what.phalanx) return int(given.p_P.size());
  return scene.patch.samples;
}

void count_back(int& index, int count) {
  if (index >= 0) index = count - 1 - index;
}

/// The same with numbers that count from the first one on, except `from_last` itself.
Measure counted(const Scene& scene, Measure what) {
  if (!what.from_last) return what;
  const int bodies = int(scene.bodies.size());
  count_back(what.body, bodies);
  count_back(what.owner, bodies);
  if (what.sample >= 0) count_back(what.sample, samples(scene, what));
  return what;
}

Measure counted(const RigidProblem& problem, Measure what) {
  if (what.from_last) count_back(what.phalanx, int(problem.supports.size()));
  return what;
}

Measure counted(const PrintedProblem&, Measure what) { return what; }

/// Its hand is known at frames only: the body is measured against W.
Against against(const PrintedProblem& problem, const Measure&) { return {.center_O = problem.inertia.center}; }

class Reader {
 public:
  Reader(const Problem& problem, const Recording& recording, const Measure& what)
      : against_(std::visit([&](const auto& p) { return against(p, what); }, problem)),
        recording_(recording),
        body_(std::size_t(what.body)),
        axis_(what.axis) {
    if (!recording.frames.empty())
      start_ = absolute(recording.frames.front().t, recording.frames.front().bodies[body_]);
  }

  [[nodiscard]] std::size_t body() const { return body_; }

  [[nodiscard]] Along at(double t, const BodyState& body) const {
    const Along now = absolute(t, body);
    return {now.x - start_.x, now.v};
  }

  /// At any instant within the recording, by the cubic between its two frames.
  [[nodiscard]] Along at(double t) const {
    const auto& frames = recording_.frames;
    if (frames.empty() || t < frames.front().t || t > frames.back().t + 1e-12) return {nan, nan};
    auto next = std::lower_bound(frames.begin(), frames.end(), t, [](const Frame& f, double s) { return f.t < s; });
    if (next == frames.end()) --next;
    if (std::abs(next->t - t) < 1e-12) return at(next->t, next->bodies[body_]);
    const Frame& a = *(next - 1);
    const Frame& b = *next;
    const Along hand = against_.at(t, axis_);
    const Along A = object(a.bodies[body_]), B = object(b.bodies[body_]);
    const double h = b.t - a.t, s = (t - a.t) / h;
    const double x = A.x * (1 + 2 * s) * (1 - s) * (1 - s) + B.x * s * s * (3 - 2 * s) +
                     h * (A.v * s * (1 - s) * (1 - s) - B.v * s * s * (1 - s));
    const double v = (B.x - A.x) / h * 6 * s * (1 - s) + A.v * (1 - s) * (1 - 3 * s) + B.v * s * (3 * s - 2);
    return {x - hand.x - start_.x, v - hand.v};
  }

 private:
  [[nodiscard]] Along object(const BodyState& body) const {
    const Eigen::Vector3d arm = body.X_WO.R * against_.center_O;
    return {axis_.dot(body.X_WO.p + arm), axis_.dot(body.V_WO.v + body.V_WO.w.cross(arm))};
  }
  [[nodiscard]] Along absolute(double t, const BodyState& body) const {
    const Along o = object(body), base = against_.at(t, axis_);
    return {o.x - base.x, o.v - base.v};
  }

  Against against_;
  const Recording& recording_;
  std::size_t body_;
  Eigen::Vector3d axis_;
  Along start_{};
};

bool chosen(const SampleId& id, const Measure& what) {
  if (id.body != what.body || (what.sample >= 0 && id.sample != what.sample)) return false;
  if (what.owner >= 0) return id.belongs_to_body() && id.phalanx == what.owner;
  return what.phalanx < 0 || (!id.belongs_to_body() && id.phalanx == what.phalanx);
}

const Event* find_event(const Recording& recording, const Measure& what) {
  int left = what.occurrence;
  for (const Event& event : recording.events)
    if (event.kind == what.event && chosen(event.id, what) && DEFECT(first_event_always, --left, 0) == 0) return &event;
  return nullptr;
}

/// Angle of R about `axis` (its twist part), in (−π, π].
double twist_angle(const Eigen::Quaterniond& R, const Eigen::Vector3d& axis) {
  return 2 * std::atan2(R.vec().dot(axis), R.w());
}

/// Unwrapped over the frames; the last piece, to `state`, must be less than half a turn.
double rotation(const Recording& recording, const Measure& what, double t, const BodyState* state) {
  double angle = 0;
  const std::size_t body = std::size_t(what.body);
  Eigen::Quaterniond last = recording.frames.front().bodies[body].X_WO.R;
  const auto add = [&](const Eigen::Quaterniond& R) {
    angle +=
        std::remainder(twist_angle(R * last.conjugate(), what.axis), DEFECT(unwrapped_by_pi, 2, 1) * std::numbers::pi);
    last = R;
  };
  for (const Frame& frame : recording.frames) {
    if (frame.t > t + 1e-12) break;
    add(frame.bodies[body].X_WO.R);
    if (!state && std::abs(frame.t - t) < 1e-12) return angle;
  }
  if (!state) return nan;  // only asked for on frames
  add(state->X_WO.R);
  return angle;
}

double time_at(const Reader& reader, const Recording& recording, double level) {
  for (std::size_t i = 1; i < recording.frames.size(); ++i) {
    double a = recording.frames[i - 1].t, b = recording.frames[i].t;
    if (!(reader.at(b).x >= level)) continue;
    for (int k = 0; k < 60; ++k) {
      const double m = 0.5 * (a + b);
      (reader.at(m).x < level ? a : b) = m;
    }
    return b;
  }
  return nan;
}

double held(const Reader& reader, const Recording& recording, double level) {
  for (const Frame& frame : recording.frames)
    if (!(std::abs(reader.at(frame.t, frame.bodies[reader.body()]).x) <
          DEFECT(held_100_mm_too_far, level, level + 0.1)))
      return 0;
  return 1;
}

/// The frame at that instant; none between frames.
const Frame* frame_at(const Recording& recording, double t) {
  for (const Frame& frame : recording.frames)
    if (std::abs(frame.t - t) < 1e-12) return &frame;
  return nullptr;
}

/// Force or torque of the chosen samples.
double load(const Recording& recording, const Measure& what) {
  const Frame* frame = what.at ? frame_at(recording, *what.at) : nullptr;
  if (!frame) return nan;
  double sum = 0;
  for (const ContactState& c : frame->contacts) {
    if (!chosen(c.id, what)) continue;
    const Eigen::Vector3d part = what.kind == Kind::force ? c.f_W : (c.C_W - what.point).cross(c.f_W).eval();
    sum += what.axis.dot(part);
  }
  return sum;
}

double count(const Recording& recording, const Measure& what) {
  return double(std::count_if(recording.events.begin(), recording.events.end(),
                              [&](const Event& e) { return e.kind == what.event && chosen(e.id, what); }));
}

/// On the frame at the instant, or at the event.
double spin(const Recording& recording, const Measure& what, const Event* event) {
  if (!what.at) return event ? what.axis.dot(event->body.V_WO.w) : nan;
  const Frame* frame = frame_at(recording, *what.at);
  return frame ? what.axis.dot(frame->bodies[std::size_t(what.body)].V_WO.w) : nan;
}

double mode(const Recording& recording, const Measure& what) {
  const Frame* frame = what.at ? frame_at(recording, *what.at) : nullptr;
  if (!frame) return nan;
  for (const ContactState& c : frame->contacts)
    if (chosen(c.id, what)) return double(c.mode);
  return double(Mode::apart);
}

}  // namespace

double measure(const Problem& problem, const Recording& recording, const Measure& asked) {
  if (recording.frames.empty() || recording.outcome != Outcome::complete) return nan;
  const Measure what = std::visit([&](const auto& p) { return counted(p, asked); }, problem);
  const Reader reader(problem, recording, what);
  const Event* event = find_event(recording, what);
  const auto along = [&] {
    if (what.at) return reader.at(*what.at);
    return event ? reader.at(event->t, event->body) : Along{nan, nan};
  };
  switch (what.kind) {
    case Kind::event_time:
      return event ? event->t : nan;
    case Kind::displacement:
      return along().x;
    case Kind::speed:
      return along().v;
    case Kind::time_at_displacement:
      return time_at(reader, recording, what.level);
    case Kind::spin:
      return spin(recording, what, event);
    case Kind::rotation:
      if (what.at) return rotation(recording, what, *what.at, nullptr);
      return event ? rotation(recording, what, event->t, &event->body) : nan;
    case Kind::held:
      return held(reader, recording, what.level);
    case Kind::no_event:
      return event ? 0 : 1;
    case Kind::event_count:
      return count(recording, what);
    case Kind::force:
    case Kind::torque:
      return load(recording, what);
    case Kind::dissipated: {
      const Frame* frame = what.at ? frame_at(recording, *what.at) : nullptr;
      return frame ? frame->energy.dissipated : nan;
    }
    case Kind::force_sum:
    case Kind::mode_count:
    case Kind::lag:
    case Kind::work:
    case Kind::growth:
      return frames_measure(recording, what);
    case Kind::energy_residual:
      return energy_residual(recording);
    case Kind::mode:
      return mode(recording, what);
  }
  return nan;
}

}  // namespace handhold::compare
