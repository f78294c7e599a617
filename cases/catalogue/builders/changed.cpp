// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/changed.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace handhold::catalogue {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

bool turns(const Change& change) { return change.X.R.coeffs() != Quaterniond::Identity().coeffs(); }

class ChangedMotion : public HandMotion {
 public:
  ChangedMotion(std::shared_ptr<const HandMotion> old, const Change& change)
      : old_(std::move(old)), change_(change), model_(old_->model()), presence_(old_->presence()) {
    for (int i = 0; i < palm; ++i) {
      const Capsule& capsule = old_->model().capsules[std::size_t(i)];
      model_.capsules[std::size_t(change.phalanx(i))] = {change.length * capsule.half_length,
                                                         change.length * capsule.radius};
    }
    model_.palm_box.half_extents *= change.length;
    for (Interval& i : presence_) i = {i.begin * change.time(), i.end * change.time()};
  }

  [[nodiscard]] const HandModel& model() const override { return model_; }
  [[nodiscard]] Side side() const override { return old_->side(); }
  [[nodiscard]] const std::vector<Interval>& presence() const override { return presence_; }
  [[nodiscard]] std::vector<double> seen() const override {
    std::vector<double> times = old_->seen();
    for (double& t : times) t *= change_.time();
    return times;
  }
  // The renumbering is its own inverse.
  [[nodiscard]] Pose pose(int phalanx, double t) const override {
    return change_.pose(old_->pose(change_.phalanx(phalanx), t / change_.time()), t);
  }
  [[nodiscard]] Twist twist(int phalanx, double t) const override {
    return change_.twist(old_->twist(change_.phalanx(phalanx), t / change_.time()));
  }

 private:
  std::shared_ptr<const HandMotion> old_;
  Change change_;
  HandModel model_;
  std::vector<Interval> presence_;
};

Eigen::Matrix3d changed_inertia(const Eigen::Matrix3d& inertia, const Change& change) {
  const double factor = change.mass * change.length * change.length;
  if (!change.mirrored) return factor * inertia;
  const Vector3d flip(1, -1, 1);
  return factor * (flip.asDiagonal() * inertia * flip.asDiagonal());
}

Load changed(const Load& load, const Change& change) {
  return {change.mass * change.polar(load.force_W), change.mass * change.length * change.axial(load.torque_W)};
}

Body changed(Body body, const Change& change) {
  const double L = change.length, T = change.time();
  body.inertia.mass *= change.mass;
  body.inertia.center = change.own(L * body.inertia.center);
  body.inertia.about_center = changed_inertia(body.inertia.about_center, change);
  body.X_WO = change.pose(body.X_WO, 0);
  body.V_WO = change.twist(body.V_WO);
  body.held_until *= T;
  for (Vector3d& p : body.samples_O) p = change.own(L * p);
  if (change.reversed) std::reverse(body.samples_O.begin(), body.samples_O.end());
  if (body.load) body.load = [load = body.load, change, T](double t) { return changed(load(t / T), change); };
  return body;
}

RigidPath changed(const RigidPath& path, const Change& change) {
  if (!path) return {};
  return [path, change](double t) -> PathPoint {
    const double L = change.length, T = change.time();
    const PathPoint old = path(t / T);
    return {change.polar(L * old.p), change.polar(L / T * old.v), change.polar(L / (T * T) * old.a)};
  };
}

RigidTurn changed(const RigidTurn& turn, const Change& change) {
  if (!turn) return {};
  return [turn, change](double t) -> TurnPoint {
    const double T = change.time();
    const TurnPoint old = turn(t / T);
    return {change.X.R * change.own(old.R) * change.X.R.conjugate(), change.axial(old.w) / T,
            change.axial(old.alpha) / (T * T)};
  };
}

/// A surface turns about W's origin, not about where that was moved to: `x` of the latter goes round in the changed W.
RigidPath about_moved_origin(const RigidPath& path, const RigidTurn& turn, const Vector3d& x) {
  if (!turn || x.isZero(0)) return path;
  return [path, turn, x](double t) -> PathPoint {
    const PathPoint s = at(path, t);
    const TurnPoint r = turn(t);
    const Vector3d arm = r.R * x, spun = r.w.cross(arm);
    return {s.p + x - arm, s.v - spun, s.a - r.alpha.cross(arm) - r.w.cross(spun)};
  };
}

RigidSupport changed(RigidSupport support, const Change& change) {
  const double L = change.length, M = change.mass, T = change.time();
  support.surface.point = change.pose({Quaterniond::Identity(), support.surface.point}, 0).p;
  support.surface.direction = change.polar(support.surface.direction);
  support.surface.radius *= L;
  support.turn = changed(support.turn, change);
  support.motion = about_moved_origin(changed(support.motion, change), support.turn, change.X.p);
  if (support.normal_force)
    support.normal_force = [force = support.normal_force, M, T](double t) { return M * force(t / T); };
  support.point_B = change.own(L * support.point_B);
  support.radius *= L;
  return support;
}

RigidSpring changed(RigidSpring spring, const Change& change) {
  spring.stiffness *= change.mass / change.length;
  spring.point_B = change.own(change.length * spring.point_B);
  spring.anchor_W = change.pose({Quaterniond::Identity(), spring.anchor_W}, 0).p;
  spring.motion = changed(spring.motion, change);
  return spring;
}

}  // namespace

Vector3d Change::own(const Vector3d& v) const { return mirrored ? Vector3d(v.x(), -v.y(), v.z()) : v; }

Quaterniond Change::own(const Quaterniond& q) const { return mirrored ? Quaterniond(q.w(), -q.x(), q.y(), -q.z()) : q; }

Vector3d Change::polar(const Vector3d& v) const { return X.R * own(v); }

Vector3d Change::axial(const Vector3d& v) const { return X.R * (mirrored ? Vector3d(-own(v)) : v); }

Vector3d Change::velocity(const Vector3d& v) const { return polar(v) * (length / time()) + boost; }

Pose Change::pose(const Pose& Y, double t) const {
  const Pose mine{own(Y.R), own(Vector3d(length * Y.p))};
  if (!turns(*this)) return {mine.R, mine.p + X.p + t * boost};
  return {X.R * mine.R, X.R * mine.p + X.p + t * boost};
}

Twist Change::twist(const Twist& V) const { return {axial(V.w) / time(), velocity(V.v)}; }

BodyState Change::old(const BodyState& s, double t) const {
  const Quaterniond back = X.R.conjugate();
  const Vector3d p = back * (s.X_WO.p - X.p - t * boost), w = back * s.V_WO.w, v = back * (s.V_WO.v - boost);
  BodyState out;
  out.X_WO = {own(Quaterniond(back * s.X_WO.R)), own(p) / length};
  out.V_WO = {time() * (mirrored ? Vector3d(-own(w)) : w), own(v) * (time() / length)};
  return out;
}

Hand changed(const Hand& hand, const Change& change) {
  Hand made = hand;
  made.motion = std::make_shared<ChangedMotion>(hand.motion, change);
  for (GivenPatch& given : made.given) {
    given.phalanx = change.phalanx(given.phalanx);
    for (Vector3d& p : given.p_P) p = change.own(change.length * p);
    for (SampleStart& start : given.start) start.lag_W = change.polar(change.length * start.lag_W);
    if (!change.reversed) continue;
    std::reverse(given.p_P.begin(), given.p_P.end());
    std::reverse(given.start.begin(), given.start.end());
  }
  if (change.reversed) std::reverse(made.given.begin(), made.given.end());
  return made;
}

Scene changed(const Scene& scene, const Change& change) {
  const double L = change.length, M = change.mass, T = change.time();
  Scene made = scene;
  made.duration *= T;
  made.gravity = change.polar(scene.gravity);
  for (ContactParameters* contact : {&made.contact, &made.body_contact}) {
    contact->stiffness *= M / L;
    contact->damping *= M / T;
  }
  // Of patches that are seeded; where all are given it says nothing, and may not leave its range.
  const auto seeded = [](const Hand& hand) { return hand.given.empty(); };
  PatchOptions& patch = made.patch;
  if (std::any_of(scene.hands.begin(), scene.hands.end(), seeded))
    for (double* length : {&patch.finger_radius, &patch.thumb_radius, &patch.palm_radius, &patch.contact_offset})
      *length *= L;
  std::map<const VoxelField*, std::shared_ptr<const VoxelField>> fields;  // bodies of one shape share them
  for (Body& body : made.bodies) {
    std::shared_ptr<const VoxelField>& field = fields[body.field.get()];
    if (!field) field = change.mirrored || L != 1 ? changed(*body.field, change) : body.field;
    body.field = field;
    body = changed(body, change);
  }
  for (Hand& hand : made.hands) hand = changed(hand, change);
  if (change.renumbered) std::reverse(made.hands.begin(), made.hands.end());
  if (change.reversed) std::reverse(made.bodies.begin(), made.bodies.end());
  return made;
}

RigidProblem changed(const RigidProblem& problem, const Change& change) {
  const double T = change.time();
  RigidProblem made = problem;
  made.duration *= T;
  made.mass *= change.mass;
  made.inertia = changed_inertia(problem.inertia, change);
  made.gravity = change.polar(problem.gravity);
  made.X_WB = change.pose(problem.X_WB, 0);
  made.V_WB = change.twist(problem.V_WB);
  for (RigidSupport& support : made.supports) support = changed(support, change);
  for (RigidSpring& spring : made.springs) spring = changed(spring, change);
  if (change.reversed) {
    std::reverse(made.supports.begin(), made.supports.end());
    std::reverse(made.springs.begin(), made.springs.end());
  }
  if (problem.load)
    made.load = [load = problem.load, change, T](double t, const BodyState& body) {
      return changed(load(t / T, change.old(body, t)), change);
    };
  return made;
}

Problem changed(const Problem& problem, const Change& change) {
  return std::visit([&](const auto& p) -> Problem { return changed(p, change); }, problem);
}

}  // namespace handhold::catalogue
