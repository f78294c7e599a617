// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/paper/middleware.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <random>

#include "cases/hand/placement.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/input_error.hpp"
#include "realtime/paper/anchor.hpp"
#include "realtime/paper/hand_contact.hpp"
#include "realtime/paper/host.hpp"
#include "realtime/paper/voxel_walk.hpp"
#include "tests/realtime/paper/rig.hpp"
#include "tests/shared_data.hpp"

// Counts every operator new of the program, so that a frame can be shown to make none.
namespace {
std::size_t allocations = 0;
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// std::stable_sort asks this way; a sanitizer brings its own, whose memory std::free must not take.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace handhold::realtime::paper {
namespace {

using Eigen::Vector3d;
using testing::at;
using testing::box_surface;
using testing::face_up;
using testing::frame;
using testing::OneSample;
using testing::ring;

constexpr Friction friction{0.5, 0.4};

// --- derivatives -----------------------------------------------------------------------------------------------------

BodyMotion displaced(const BodyMotion& body, const Vector3d& center_O, const Vector3d& move, const Vector3d& turn) {
  BodyMotion b = body;
  const Vector3d center = body.X_WO * center_O;
  if (turn.norm() > 0) b.X_WO.R = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * body.X_WO.R;
  b.X_WO.p = center + move - b.X_WO.R * center_O;
  return b;
}

Eigen::Matrix<double, 6, 1> stacked(const Wrench& w) {
  Eigen::Matrix<double, 6, 1> v;
  v << w.force, w.torque;
  return v;
}

/// A body in general position, with sticking and slipping samples.
struct General {
  Vector3d center_O{0.01, -0.02, 0.005};
  Middleware law;
  BodyMotion body;

  explicit General(const Options& options) : law(std::make_shared<PlaneSurface>(0), center_O, friction, options, 2) {
    body.X_WO = {Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized())), {0.1, 0.2, 0.3}};
    body.v = {0.1, -0.2, 0.05};
    body.w = {1, 2, -1.5};
    const auto points = ring(Vector3d::UnitX(), Vector3d::UnitY(), 0.004, 5);
    std::array<Pose, 2> hands{body.X_WO * at(0.01, 0.02, -0.003), body.X_WO * at(-0.01, 0.01, -0.002)};
    for (int i = 0; i < 2; ++i) law.seed(i, hands[std::size_t(i)], body.X_WO, points, 0.02);
    hands[0] = body.X_WO * at(0.0105, 0.0203, -0.003);  // sticks
    hands[1] = body.X_WO * at(-0.007, 0.0105, -0.002);  // slips
    const BodyMotion rest{body.X_WO, {}, {}};
    law.frame(frame, hands, rest);
    law.frame(frame, hands, body);
  }
};

TEST(PaperSlopes, AreTheDifferencesOfTheWrench) {
  std::vector<Options> all(4);
  all[1].sign = Sign::as_printed;
  all[2].slip_force = SlipForce::capped;
  all[3].point = Point::centroid;
  for (Options options : all) {
    for (const double damping : {0.0, 0.3}) {
      options.damping = damping;
      const General g(options);
      const WrenchSlopes slopes = g.law.slopes_at(g.body);
      // Central differences of 1e-6: curvature gives 1e-12 / (lag 1e-3)² of γ n, rounding 1e-16 · 1 N / 1e-6.
      const double h = 1e-6, tolerance = 1e-3;
      for (int k = 0; k < 6; ++k) {
        const Vector3d move = (k < 3 ? h : 0) * Vector3d::Unit(k % 3);
        const Vector3d turn = (k < 3 ? 0 : h) * Vector3d::Unit(k % 3);
        const Eigen::Matrix<double, 6, 1> pose =
            (stacked(g.law.wrench_at(displaced(g.body, g.center_O, move, turn))) -
             stacked(g.law.wrench_at(displaced(g.body, g.center_O, -move, -turn)))) /
            (2 * h);
        BodyMotion faster = g.body, slower = g.body;
        faster.v += move, faster.w += turn;
        slower.v -= move, slower.w -= turn;
        const Eigen::Matrix<double, 6, 1> velocity =
            (stacked(g.law.wrench_at(faster)) - stacked(g.law.wrench_at(slower))) / (2 * h);
        EXPECT_LT((pose - slopes.by_pose.col(k)).norm(), tolerance) << "pose " << k;
        EXPECT_LT((velocity - slopes.by_velocity.col(k)).norm(), tolerance) << "velocity " << k;
      }
      EXPECT_GT(slopes.by_pose.norm(), 100);
      EXPECT_EQ(slopes.by_velocity.norm() > 0, damping > 0);
    }
  }
}

TEST(PaperSlopes, TheScaffoldHasBothModes) {
  const General g({});
  EXPECT_EQ(g.law.patches()[0].samples[0].mode, Mode::stick);
  EXPECT_EQ(g.law.patches()[1].samples[0].mode, Mode::slip);
}

// --- anchors ---------------------------------------------------------------------------------------------------------

TEST(PaperAnchor, StaysWhereTheSurfaceTurnsAway) {
  // Fig. 3: a step. Lower face z = 0.0 (inside corner at x = 0), riser x = 0 facing −x, upper part beyond.
  Mesh mesh = make_l_shape(0.08, 0.06, 0.03, 0.04);
  const auto field = voxelize(mesh, {.voxel_size = 0.001});
  // The inner corner of the L: legs along +x and +y, 0.03 wide. Find the leg's inner face by a ray from outside.
  const FieldSurface surface(field, Normals::triangle);
  Eigen::AlignedBox3d box = field->bounds();
  const Vector3d outside(box.max().x() - 0.01, box.max().y(), 0);
  const auto floor = surface.cast(outside, {outside.x(), box.min().y() - 0.01, 0});
  ASSERT_TRUE(floor.has_value());
  EXPECT_NEAR(floor->n_O.y(), 1, 1e-12);
  // From there the hand goes into the other leg, deep below its inner face, whose normal is +x: at right angles.
  const Vector3d p(box.min().x() + 0.015, floor->C_O.y() + 0.01, 0);
  Spot anchor = *floor;
  cast_anchor(surface, p, {}, anchor);
  EXPECT_EQ(anchor.C_O, floor->C_O);
  Options around;
  around.turned_away = -0.5;
  cast_anchor(surface, p, around, anchor);  // told to go on, it does
  EXPECT_NEAR(anchor.n_O.x(), 1, 1e-12);
}

TEST(PaperAnchor, CoulombsKeepsTheKineticLagAtAnyFrameRate) {
  for (const double rate : {45.0, 90.0, 1000.0}) {
    OneSample s(face_up("field"), 0.0025, friction, coulomb(), -0.5);
    s.push(-0.5);
    double force = 0;
    for (int k = 1; k <= int(rate); ++k) force = s.push(-0.5 + 0.2 * k / rate);
    EXPECT_NEAR(force, 0.4 * 0.25, 1e-13);  // μ_d N; rounding of positions, 1e-16 m times γ
    EXPECT_NEAR(-0.3 - s.sample().anchor.C_O.x(), 0.4 * 0.0025, 1e-15);
  }
}

TEST(PaperAnchor, FollowsWhileApartSoThatTouchHasNoLag) {
  for (const ApartAnchor apart : {ApartAnchor::stays, ApartAnchor::follows}) {
    Options options;
    options.apart_anchor = apart;
    OneSample s(face_up("plane"), -0.001, friction, options);  // 1 mm above the face
    s.push(0);
    s.push(0.001);
    s.depth = 0.0025;
    EXPECT_EQ(s.push(0.001), apart == ApartAnchor::stays ? 0.1 : 0.0);
  }
}

TEST(PaperVoxels, RaysMeetTheFacesThatTrianglesHave) {
  // A box of whole voxels: both surfaces are the same, so two independent ray casters must agree.
  const auto field = voxelize(make_box({0.0625, 0.03125, 0.046875}), {.voxel_size = 1.0 / 256, .band = 1.0 / 64});
  const FieldSurface triangles(field, Normals::triangle), voxels(field, Normals::voxel);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> far(-0.06, 0.06), near(-0.01, 0.01);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d from(far(random), far(random), far(random)), to(near(random), near(random), near(random));
    if (field->bounds().contains(from)) continue;
    const auto a = triangles.cast(from, to), b = voxels.cast(from, to);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++hits;
    EXPECT_LT((a->C_O - b->C_O).norm(), 1e-14);
    EXPECT_LT((a->n_O - b->n_O).norm(), 1e-14);
    const auto c = triangles.closest(from, 0.2), d = voxels.closest(from, 0.2);
    ASSERT_TRUE(c && d);
    EXPECT_LT((c->C_O - d->C_O).norm(), 1e-14);
  }
  EXPECT_GT(hits, 1000);
}

// Where a run that diverges may ask from: 1e8 m are more voxels than an int counts. Both casters again; what they may
// differ by is what a number of that size is rounded by, a few times over.
TEST(PaperVoxels, AnswerFromVeryFar) {
  const auto field = voxelize(make_box({0.0625, 0.03125, 0.046875}), {.voxel_size = 1.0 / 256, .band = 1.0 / 64});
  const FieldSurface triangles(field, Normals::triangle), voxels(field, Normals::voxel);
  for (const double far : {1.0, 1e4, 1e8, 1e12}) {
    const Vector3d from(0.003, 0.002, far), beyond(0.003, 0.002, -far), beside(0.5, 0.002, -far);
    const double rounding = 8 * far * std::numeric_limits<double>::epsilon();
    const auto hit = voxels.cast(from, beyond), nearest = voxels.closest(from, 2 * far);
    ASSERT_TRUE(hit && nearest) << far;
    EXPECT_LT((hit->C_O - triangles.cast(from, beyond)->C_O).norm(), rounding);
    EXPECT_EQ(hit->n_O, Vector3d::UnitZ());
    EXPECT_NEAR((from - nearest->C_O).norm(), (from - triangles.closest(from, 2 * far)->C_O).norm(), rounding);
    EXPECT_FALSE(voxels.cast(from, beside)) << far;
    EXPECT_FALSE(voxels.closest(from, 0.02)) << far;
  }
  EXPECT_FALSE(voxels.cast({1e308, 0, 0}, {-1e308, 0, 0}));  // its length is no number
}

// --- the middleware itself -------------------------------------------------------------------------------------------

TEST(PaperMiddleware, RefusesWhatMakesNoSense) {
  const auto surface = std::make_shared<PlaneSurface>(0);
  const auto make = [&](const Options& o) { Middleware(surface, Vector3d::Zero(), friction, o, 1); };
  Options o;
  for (double Options::*member : {&Options::stiffness, &Options::ray_offset}) {
    o = {};
    o.*member = 0;
    EXPECT_THROW(make(o), InputError);
  }
  o = {};
  o.damping = NAN;
  EXPECT_THROW(make(o), InputError);
  EXPECT_THROW(Middleware(nullptr, Vector3d::Zero(), friction, {}, 1), InputError);
  EXPECT_THROW(Middleware(surface, Vector3d::Zero(), {0.4, 0.5}, {}, 1), InputError);
}

HandFrame hand_at(const HandMotion& motion, double t) {
  HandFrame hand;
  hand.present = motion.present(t);
  for (int i = 0; i < phalanx_count; ++i) hand.X_WP[std::size_t(i)] = motion.pose(i, t);
  return hand;
}

/// A recorded pinch around a cube that stays where it was put.
struct Recorded {
  std::shared_ptr<const VoxelField> field = voxelize(make_box({0.03, 0.03, 0.03}), {.voxel_size = 0.001});
  std::optional<Placement> placement{};
  std::unique_ptr<TraceSpline> motion{};

  Recorded() {
    const std::string file = test::shared_data("traces/leapjs/pinch.json.lz");
    if (!std::ifstream(file)) return;
    const Trace trace = read_trace(file);
    placement = place_in_hand(trace, 0, *field);
    motion = std::make_unique<TraceSpline>(trace, 0);
  }
};

TEST(PaperHandContact, RecordedPinchPushesInsideItsConesAndAllocatesNothing) {
  const Recorded recorded;
  if (!recorded.motion) GTEST_SKIP() << "the shared data (traces) are not here";
  for (const Normals normals : {Normals::triangle, Normals::smooth, Normals::voxel}) {
    for (const Options& options : {Options(), coulomb()}) {
      HandContact contact(recorded.field, normals, Vector3d::Zero(), friction, options, {recorded.motion->model()});
      HandContact again = contact;
      const BodyMotion body{recorded.placement->X_WO, {}, {}};
      int touching = 0;
      for (double t = recorded.placement->start; t < recorded.placement->closure + 0.5; t += frame) {
        const std::array<HandFrame, 1> hand{hand_at(*recorded.motion, t)};
        const std::size_t before = allocations;
        const Wrench wrench = contact.frame(frame, hand, body);
        EXPECT_EQ(allocations, before);
        EXPECT_EQ(again.frame(frame, hand, body).force, wrench.force);  // same bits
        for (const PatchState& patch : contact.middleware().patches()) {
          for (int i = 0; i < patch.count; ++i) {
            const SampleState& s = patch.samples[std::size_t(i)];
            if (s.mode == Mode::apart) continue;
            ++touching;
            if (options.slip_force != SlipForce::capped) continue;
            const Vector3d n = body.X_WO.R * s.used.n_O;
            const double N = -s.f_W.dot(n);
            EXPECT_GT(N, 0);
            EXPECT_LE((s.f_W + N * n).norm(), 0.5 * N * (1 + 1e-12));
          }
        }
      }
      EXPECT_GT(touching, 100);
    }
  }
}

TEST(PaperHost, FliesAndSpinsExactlyWithoutContact) {
  HostBody body;
  body.mass = 0.3;
  body.inertia_O = 1e-4 * Eigen::Matrix3d::Identity();
  body.center_O = {0.01, 0, 0};
  body.motion.w = {0, 0, 3};
  Host host(Middleware(std::make_shared<PlaneSurface>(0), body.center_O, friction, {}, 1), body, {0, 0, -9.81},
            {.substeps = 4});
  const Pose none;
  for (int k = 0; k < 45; ++k) host.advance(frame, std::span<const Pose>(&none, 1));
  const double t = 45 * frame, h = frame / 4;
  const Vector3d center = host.body().motion.X_WO * body.center_O;
  // R03: semi-implicit Euler under constant force, a t²/2 + a t h/2; the centre of mass of a spinning body goes
  // straight.
  EXPECT_NEAR(center.z(), -9.81 * (t * t / 2 + t * h / 2), 1e-13);
  EXPECT_NEAR(center.x(), 0.01, 1e-14);
  EXPECT_NEAR(Eigen::AngleAxisd(host.body().motion.X_WO.R).angle(), 3 * t, 1e-12);
}

}  // namespace
}  // namespace handhold::realtime::paper
