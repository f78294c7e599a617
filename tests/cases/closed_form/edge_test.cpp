// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

// The closed forms against the law itself, integrated step by step: c C' = (1 − μ_d N / |w|)+ w, with w the point of
// the tangent cone of the outside nearest to f* = k (p − C) + c p', and N = |f* − w| (docs/contact-law.md).

namespace handhold::closed_form {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double mm = 1e-3;
constexpr double dt = 1e-6;  // explicit Euler's; the element relaxes in c / k = 5e-4 s
const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

struct Way {
  double duration{};
  Vector3d to{};
};

/// A solid bounded by planes n·x = 0 through the origin: their common inside, or all but their common outside.
struct Planes {
  std::vector<Vector3d> n{};
  bool hollow{false};

  [[nodiscard]] bool holds(const Vector3d& p) const {
    const auto is_below = [&](const Vector3d& m) { return m.dot(p) < 0; };
    return hollow ? std::any_of(n.begin(), n.end(), is_below) : std::all_of(n.begin(), n.end(), is_below);
  }

  /// The point nearest to f of the tangent cone at C: of the half spaces that C's planes bound, their union around a
  /// convex edge, their intersection in a hollow one.
  [[nodiscard]] Vector3d project(const Vector3d& C, const Vector3d& f) const {
    std::vector<Vector3d> active;
    for (const Vector3d& m : n)
      if (std::abs(m.dot(C)) < 1e-13) active.push_back(m);
    const auto outside = [&](const Vector3d& m) { return m.dot(f) >= 0; };
    if (hollow ? std::all_of(active.begin(), active.end(), outside)
               : std::any_of(active.begin(), active.end(), outside))
      return f;
    Vector3d best = Vector3d::Constant(std::numeric_limits<double>::max());
    const auto take = [&](const Vector3d& w) {
      const bool lies_in = !hollow || std::all_of(active.begin(), active.end(),
                                                  [&](const Vector3d& m) { return m.dot(w) >= -1e-12 * f.norm(); });
      if (lies_in && (f - w).norm() < (f - best).norm()) best = w;
    };
    if (hollow) take(Vector3d::Zero());
    for (const Vector3d& m : active) take(f - m.dot(f) * m);
    for (std::size_t i = 0; hollow && i < active.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3d u = active[i].cross(active[j]).normalized();
        take(u.dot(f) * u);
      }
    return best;
  }

  /// Where a step of an anchor ends: at the first other plane that it would pass, on the planes that it is near.
  [[nodiscard]] Vector3d stay_on(const Vector3d& from, Vector3d to) const {
    for (const Vector3d& m : n) {
      const double before = m.dot(from), after = m.dot(to);
      if (before < -1e-13 && after > 0 && !hollow) to = from + before / (before - after) * (to - from);
      if (hollow && after < 0) to -= after * m;
    }
    for (const Vector3d& m : n)
      if (std::abs(m.dot(to)) < 1e-13) to -= m.dot(to) * m;
    return to;
  }
};

/// A sample that comes along rest-to-rest quintics, and what the law makes of it.
struct Sample {
  EdgeContact contact{};
  Planes solid{};
  Vector3d start{};
  std::vector<Way> ways{};

  Vector3d p{}, v{}, C{}, f{Vector3d::Zero()};
  bool touches{false}, slides{false};
  double t{};
  Vector3d released_at{}, v_released{};  // of the last release
  Vector3d slid_at{}, v_slid{};          // ... and breakaway

  void place(double at) {
    Vector3d from = start;
    v.setZero();
    for (const Way& way : ways) {
      if (at < way.duration) {
        const double s = at / way.duration;
        p = from + s * s * s * (10 - 15 * s + 6 * s * s) * (way.to - from);
        v = 30 * s * s * (1 - s) * (1 - s) / way.duration * (way.to - from);
        return;
      }
      at -= way.duration;
      p = from = way.to;
    }
  }

  void touch(const Vector3d& before) {
    if (!solid.holds(p) || solid.holds(before)) return;
    double share = solid.hollow ? 1 : 0;  // the plane through which it comes in
    for (const Vector3d& m : solid.n) {
      const double above = m.dot(before), below = m.dot(p);
      if (above < 0 || below >= 0) continue;
      share = solid.hollow ? std::min(share, above / (above - below)) : std::max(share, above / (above - below));
    }
    C = solid.stay_on(before, before + share * (p - before));
    touches = true;
    slides = false;
  }

  void step() {
    const Vector3d before = p;
    t += dt;
    place(t);
    f.setZero();
    if (!touches) touch(before);
    if (!touches) return;
    f = contact.stiffness * (p - C) + contact.damping * v;
    const Vector3d w = solid.project(C, f);
    const double N = (f - w).norm(), W = w.norm();
    if (N == 0) {
      touches = false;
      f.setZero();
      released_at = p, v_released = v;
      return;
    }
    if (!slides && W > contact.friction.mu_static * N) slides = true, slid_at = p, v_slid = v;
    if (W <= contact.friction.mu_dynamic * N) slides = false;
    if (!slides) return;
    const Vector3d rate = (W - contact.friction.mu_dynamic * N) / contact.damping / W * w;
    C = solid.stay_on(C, C + dt * rate);
    f -= contact.damping * rate;
  }

  Sample& play(double until) {
    if (t == 0) place(0);
    while (t < until) step();
    return *this;
  }
};

/// One step's way at the largest speed, 30 mm/s, and as much again for the explicit rule.
constexpr double located = 6e-8;  // [m]
constexpr double located_force = 100 * located;

Vector3d side(double turn) { return {std::sin(turn), 0, std::cos(turn)}; }

TEST(ConvexEdge, IsLeftWhereIntegrationSays) {
  for (const double degrees : {30.0, 60.0, 66.0, 75.0, 90.0, 110.0})
    for (const double damping : {0.01, 0.05}) {
      const EdgeContact contact{100, damping, {0.5, 0.4}};
      const double turn = degrees * M_PI / 180, depth = 2 * mm;
      Sample s{
          contact, {{z, side(turn)}}, {-5 * mm, 0, 1 * mm}, {{0.2, {-5 * mm, 0, -depth}}, {1, {5 * mm, 0, -depth}}}};
      s.play(1.2);
      const double V = s.v_released.x();
      EXPECT_NEAR(s.released_at.x(), leaves_convex_edge(contact, depth, turn, V), located) << degrees << ' ' << damping;
    }
}

TEST(ConvexEdge, DoesNotMatterToWhatIsPressedBesideIt) {
  for (const double beside : {0.01 * mm, 0.1 * mm, 0.4 * mm})
    for (const double degrees : {0.0, 20.0, 35.0}) {
      const EdgeContact contact;
      const double slope = std::tan(degrees * M_PI / 180), depth = 4 * mm;
      Sample s{contact, {{z, x}}, {slope * mm - beside, 0, mm}, {{0.5, {-slope * depth - beside, 0, -depth}}}};
      s.play(0.55);
      const Vector2d expected = pressed(contact, depth, degrees * M_PI / 180);
      EXPECT_NEAR(s.f.x(), expected.x(), located_force);
      EXPECT_NEAR(s.f.z(), expected.y(), located_force);
    }
}

TEST(ConvexEdge, HoldsWhatSticksBeyondIt) {
  const EdgeContact contact;
  Sample s{contact,
           {{z, x}},
           {-0.5 * mm, 0, mm},
           {{0.3, {-0.5 * mm, 0, -4 * mm}}, {0.3, {mm, 0, -4 * mm}}, {0.3, {-0.5 * mm, 0, -4 * mm}}}};
  EXPECT_LT((s.play(0.6).f - held(contact, {1.5 * mm, 0, -4 * mm})).norm(), located_force);
  EXPECT_LT((s.play(0.95).f - held(contact, {0, 0, -4 * mm})).norm(), located_force);
}

TEST(ConvexEdge, IsTheSideThatIsCrossedWhenASampleComesBack) {
  const EdgeContact contact;
  Sample s{contact,
           {{z, x}},
           {-5 * mm, 0, mm},
           {{0.2, {-5 * mm, 0, -2 * mm}}, {0.5, {3 * mm, 0, -2 * mm}}, {0.5, {-2 * mm, 0, -2 * mm}}}};
  EXPECT_LT((s.play(1.25).f - held(contact, {-2 * mm, 0, 0})).norm(), located_force);
}

TEST(HollowEdge, HoldsAndLetsGoAsIntegrationSays) {
  const EdgeContact contact;
  const double depth = 2 * mm;
  Sample s{contact,
           {{z, x}, true},
           {10 * mm, 0, mm},
           {{0.3, {10 * mm, 0, -depth}}, {1, {-3 * mm, 0, -depth}}, {1, {6 * mm, 0, -depth}}}};
  EXPECT_LT((s.play(1.3).f - held(contact, {-3 * mm, 0, -depth})).norm(), located_force);
  s.play(2.35);
  EXPECT_NEAR(s.slid_at.x(), leaves_hollow_edge(contact, depth, s.v_slid.x()), located);
  EXPECT_NEAR(s.C.x(), 6 * mm - drag(contact, depth) / contact.stiffness, located);
}

TEST(HollowEdge, DragsAsAFilletOfNoRadius) {
  const EdgeContact contact;
  for (const double second : {1 * mm, 2 * mm}) {
    Sample s{contact,
             {{z, x}, true},
             {3 * mm, -5 * mm, mm},
             {{0.3, {3 * mm, -5 * mm, -2 * mm}}, {0.5, {-second, -5 * mm, -2 * mm}}, {1, {-second, 5 * mm, -2 * mm}}}};
    s.play(1.85);
    EXPECT_NEAR(s.f.y(), groove_drag(contact, 2 * mm, second), located_force);
    EXPECT_NEAR(s.C.y(), 5 * mm - groove_drag(contact, 2 * mm, second) / contact.stiffness, located);
  }
}

/// The fillet: the edge rounded to radius r is a quarter of a cylinder, hollow towards the sample, whose anchor lies on
/// it where the normal points to the sample. Depth there is the distance to the axis less r.
TEST(HollowEdge, DragIsTheLimitOfAFillet) {
  const EdgeContact contact;
  const double d1 = 2 * mm, d2 = 3 * mm;
  for (const double r : {1e-4, 1e-6}) {
    const double depth = std::hypot(d1 + r, d2 + r) - r;
    EXPECT_NEAR(drag(contact, depth), groove_drag(contact, d1, d2), drag(contact, r));
  }
}

TEST(HollowCorner, HoldsAndDragsAsIntegrationSays) {
  const EdgeContact contact;
  Sample s{contact,
           {{z, x, y}, true},
           {10 * mm, 9 * mm, mm},
           {{0.3, {10 * mm, 9 * mm, -2 * mm}}, {1, {-2 * mm, -3 * mm, -2 * mm}}, {1, {-2 * mm, -3 * mm, 5 * mm}}}};
  EXPECT_LT((s.play(1.3).f - held(contact, {-2 * mm, -3 * mm, -2 * mm})).norm(), located_force);
  s.play(2.35);
  EXPECT_NEAR(s.f.z(), groove_drag(contact, 2 * mm, 3 * mm), located_force);
  EXPECT_NEAR(s.C.z(), 5 * mm - groove_drag(contact, 2 * mm, 3 * mm) / contact.stiffness, located);
}

}  // namespace
}  // namespace handhold::closed_form
