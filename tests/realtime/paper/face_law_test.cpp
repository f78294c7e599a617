#include <algorithm>
#include <array>
#include <cmath>

#include "cases/closed_form/printed_grasp.hpp"
#include "cases/closed_form/printed_law.hpp"
#include "cases/model/voxel_field.hpp"
#include "realtime/paper/anchor.hpp"
#include "tests/realtime/paper/rig.hpp"

// The middleware on flat faces against the exact maps of cases/closed_form/printed_law (L3-01 to 04, 07, 11 to 15):
// on an endless plane and on the triangles of a real voxel field. What limits both is the rounding of positions: 1e-18
// to 4e-15 m in lags of a millimetre.

namespace handhold::realtime::paper {
namespace {

using closed_form::FrameOrder;
using closed_form::PrintedFace;
using closed_form::PrintedSlide;
using testing::at;
using testing::face_up;
using testing::FaceUp;
using testing::OneSample;
using testing::ring;
using testing::Worst;

constexpr double mu_s = 0.5, mu_d = 0.4;
const Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX(), y_axis = Eigen::Vector3d::UnitY();

Options options_of(const PrintedFace& face, Order order = Order::force_first) {
  Options o;
  o.stiffness = face.gamma;
  o.ray_offset = face.offset;
  o.order = order;
  return o;
}

FrameOrder order_of(Order order) {
  return order == Order::force_first ? FrameOrder::force_first : FrameOrder::anchor_first;
}

class OnAFace : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] FaceUp face() const { return face_up(GetParam()); }
  [[nodiscard]] bool is_plane() const { return std::string(GetParam()) == "plane"; }
  Worst worst;
};

INSTANTIATE_TEST_SUITE_P(Paper, OnAFace, ::testing::Values("plane", "field"),
                         [](const auto& given) { return std::string(given.param); });

// --- L3-01: the sign of eq. 1 ----------------------------------------------------------------------------------------

/// Depths of a free object under a resting patch of 8 at d0, per frame of 1 ms.
std::vector<double> depths(const FaceUp& face, Sign sign, double d0, int frames) {
  Options options;
  options.sign = sign;
  HostBody body;
  body.mass = 0.2;
  body.mobility = Mobility::translation;
  Host host(Middleware(face.surface, Eigen::Vector3d::Zero(), {mu_s, mu_d}, options, 1), body, Eigen::Vector3d::Zero());
  const Pose hand = at(0, 0, face.top - d0);
  host.middleware().seed(0, hand, {}, ring(x_axis, y_axis, 0.003, 8), 0.02);
  std::vector<double> result{d0};
  for (int n = 0; n < frames; ++n) {
    host.advance(1e-3, std::span<const Pose>(&hand, 1));
    result.push_back(face.top + host.body().motion.X_WO.p.z() - hand.p.z());
  }
  return result;
}

TEST_P(OnAFace, L3_01_AsPrintedTheObjectIsPulledIntoTheFinger) {
  const closed_form::SpringFrames springs{0.2, 800, 1e-3};
  const std::vector<double> d = depths(face(), Sign::as_printed, 0.001, 50);
  for (int n = 0; n <= 50; ++n) worst.expect(d[std::size_t(n)], attracted_depth(springs, 0.001, n));
}

TEST_P(OnAFace, L3_01_WithTheSignRightItIsPushedOffAndFliesOn) {
  const closed_form::SpringFrames springs{0.2, 800, 1e-3};
  const std::vector<double> d = depths(face(), Sign::onto_object, 0.001, 50);
  std::size_t n = 0;
  for (; repelled_depth(springs, 0.001, int(n)) > 0; ++n)
    EXPECT_NEAR(d[n], repelled_depth(springs, 0.001, int(n)), 1e-12 * 0.001);  // relative to d0: it passes 0
  EXPECT_EQ(n, 25u);                                                           // λ t = π/2 at 24.8 ms
  const double step = d[n + 1] - d[n];
  for (; n + 1 < d.size(); ++n) EXPECT_NEAR(d[n + 1] - d[n], step, 1e-17);  // gated: no force outside
}

// --- L3-02 to 04, 15: sliding ----------------------------------------------------------------------------------------

void slide_as_the_map_says(Worst& worst, const FaceUp& up, const PrintedFace& f, double v, Order order, int frames,
                           double x0) {
  OneSample s(up, f.depth, f.friction, options_of(f, order), x0);
  s.push(x0);
  PrintedSlide map;
  double force = 0;
  for (int k = 1; k <= frames; ++k) {
    map = next_slide(f, map.lag, v, order_of(order));
    force = s.push(x0 + k * v * f.frame);
    worst.expect(force, map.force);
    ASSERT_EQ(s.sample().mode == Mode::slip, map.slips) << "frame " << k;
  }
}

TEST_P(OnAFace, L3_02_SteadySlidingIsViscous) {
  const PrintedFace fine{.friction = {mu_s, mu_d}};
  const PrintedFace coarse{.friction = {mu_s, mu_d}, .depth = 0.005, .offset = 0.0001, .frame = 1.0 / 60};
  for (const Order order : {Order::force_first, Order::anchor_first}) {
    slide_as_the_map_says(worst, face(), fine, 0.2, order, 400, -0.9);
    slide_as_the_map_says(worst, face(), fine, 0.05, order, 400, -0.9);
    slide_as_the_map_says(worst, face(), coarse, 0.5, order, 200, -0.9);
  }
}

TEST_P(OnAFace, L3_02_ReachesTheSteadyForce) {
  for (const Order order : {Order::force_first, Order::anchor_first}) {
    for (const double v : {0.2, 0.05}) {
      const PrintedFace f{.friction = {mu_s, mu_d}};
      OneSample s(face(), f.depth, f.friction, options_of(f, order), -0.9);
      double force = 0;
      for (int k = 0; k <= 200; ++k) force = s.push(-0.9 + k * v * f.frame);  // q^200 = 1e-29
      worst.expect(force, steady_slide_force(f, v, order_of(order)));
    }
    if (!is_plane()) continue;  // the coarse set needs 16 m
    const PrintedFace f{.friction = {mu_s, mu_d}, .depth = 0.005, .offset = 0.0001, .frame = 1.0 / 60};
    OneSample s(face(), f.depth, f.friction, options_of(f, order));
    double force = 0;
    for (int k = 0; k <= 2000; ++k) force = s.push(k * 0.5 * f.frame);  // q^2000 = 6e-18
    worst.expect(force, steady_slide_force(f, 0.5, order_of(order)));
  }
}

TEST_P(OnAFace, L3_03_ChatterMeanHasNoKineticCoefficient) {
  const double v = 1.0007e-5;  // at 1e-5 the first break-away is a tie, lag = μ_s d in frame 11250: rounding decides
  for (const double kinetic : {0.4, 0.1}) {
    const PrintedFace f{.friction = {mu_s, kinetic}};
    OneSample s(face(), f.depth, f.friction, options_of(f));
    s.push(0);
    PrintedSlide map;
    double sum = 0;
    long frames = 0, slips = 0;
    for (int k = 1; slips <= 5; ++k) {  // whole periods: from slip to slip
      map = next_slide(f, map.lag, v, FrameOrder::force_first);
      const double force = s.push(k * v * f.frame);
      worst.expect(force, map.force);  // frame by frame: the map is exact, the mean a limit
      if (slips > 0) sum += force, ++frames;
      if (s.sample().mode == Mode::slip) ++slips;
    }
    const double mean = sum / double(frames) / (f.gamma * f.depth);
    EXPECT_NEAR(mean / chatter_friction(f), 1, chatter_error(f, v));  // 5e-4 and 8e-4, derived in the header
    const double limit = chatter_share(f, v);
    EXPECT_LE(5.0 / double(frames), limit / (1 - contraction(f) * limit));
    EXPECT_GE(5.0 / double(frames), limit / (1 + limit));
  }
}

TEST_P(OnAFace, L3_04_SlipImpulseIsExactForAnySpeed) {
  for (const double v : {0.013, 0.03, 0.3}) {
    const PrintedFace f{.friction = {mu_s, mu_d}};
    const int frames = is_plane() ? 5000 : 500;
    OneSample s(face(), f.depth, f.friction, options_of(f), is_plane() ? 0 : -0.9);
    const double x0 = is_plane() ? 0 : -0.9;
    s.push(x0);
    double sum = 0, x = x0;
    for (int k = 1; k <= frames; ++k) {
      x = x0 + k * v * f.frame;
      const double force = s.push(x);
      if (s.sample().mode == Mode::slip) sum += force;
    }
    worst.expect(sum, slip_impulse(f, v, frames, 0, x - s.sample().anchor.C_O.x()));
  }
}

TEST_P(OnAFace, L3_15_FrictionDoesNotVanishWithTheSqueeze) {
  if (!is_plane()) GTEST_SKIP() << "a depth of 1e-9 m on a face at 1/32 m has 3e-9 of rounding: the plane lies at 0";
  PrintedFace f{.friction = {mu_s, mu_d}, .depth = 1e-9};
  for (const Order order : {Order::force_first, Order::anchor_first}) {
    // It ends at x = 0: after the ray the lag is 2e-9 m, less than the rounding of places far from there allows.
    OneSample s(face(), f.depth, f.friction, options_of(f, order), -60 * 0.2 * f.frame);
    double force = 0;
    for (int k = -60; k <= 0; ++k) force = s.push(k * 0.2 * f.frame);
    worst.expect(force, steady_slide_force(f, 0.2, order_of(order)));
  }
}

// --- L3-07, 14: patches ----------------------------------------------------------------------------------------------

TEST_P(OnAFace, L3_07_OneCentroidHasNoTorqueAndItsPatchCollapses) {
  const PrintedFace f{.friction = {mu_s, mu_d}};
  Options options = options_of(f);
  options.point = Point::centroid;
  const FaceUp up = face();
  Middleware law(up.surface, Eigen::Vector3d::Zero(), f.friction, options, 1);
  const double a = 0.005;
  Pose hand = at(0, 0, up.top - f.depth);
  law.seed(0, hand, {}, ring(x_axis, y_axis, a, 8), 0.02);
  hand.R = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());  // a twist that nobody feels
  const auto collapse = patch_collapse(f, a);
  const auto radius = [&](std::size_t i) { return law.patches()[0].samples[i].anchor.C_O.head<2>().norm(); };
  double expected = a;
  for (int k = 0; k < collapse.frames + 3; ++k) {
    const Wrench& wrench = law.frame(f.frame, std::span<const Pose>(&hand, 1), {});
    EXPECT_LT(std::abs(wrench.torque.z()), 1e-12 * 8 * f.gamma * a * a);
    const bool slips = k < collapse.frames;
    if (slips) expected *= contraction(f);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(law.patches()[0].samples[i].mode, slips ? Mode::slip : Mode::stick);
      worst.expect(radius(i), expected);
    }
  }
  worst.expect(radius(0), collapse.radius);
}

TEST_P(OnAFace, L3_07_PointsOfTheirOwnCarryTorque) {
  const Friction sticky{1, 1};  // at μ_s = 0.5 the catalogue's twist would slip: lag 2 a sin(φ/2) = 2 mm > 1.25 mm
  const FaceUp up = face();
  Middleware law(up.surface, Eigen::Vector3d::Zero(), sticky, {}, 1);
  Pose hand = at(0, 0, up.top - 0.0025);
  law.seed(0, hand, {}, ring(x_axis, y_axis, 0.005, 8), 0.02);
  hand.R = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
  const Wrench& wrench = law.frame(0.01, std::span<const Pose>(&hand, 1), {});
  worst.expect(wrench.torque.z(), closed_form::stick_torque(100, 8, 0.005, 0.4));
}

TEST_P(OnAFace, L3_14_SpinningIsViscous) {
  const PrintedFace f{.friction = {mu_s, mu_d}};
  const FaceUp up = face();
  Middleware law(up.surface, Eigen::Vector3d::Zero(), f.friction, options_of(f), 1);
  const double a = 0.004, w = 60;
  Pose hand = at(0, 0, up.top - f.depth);
  law.seed(0, hand, {}, ring(x_axis, y_axis, a, 8), 0.02);
  double torque = 0;
  for (int k = 0; k <= 300; ++k) {
    hand.R = Eigen::AngleAxisd(k * w * f.frame, Eigen::Vector3d::UnitZ());
    torque = law.frame(f.frame, std::span<const Pose>(&hand, 1), {}).torque.z();
  }
  worst.expect(torque, spin_torque(f, 8, a, w));
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(law.patches()[0].samples[i].mode, Mode::slip);
}

// --- L3-11: normals of voxels ----------------------------------------------------------------------------------------

/// Force on a sample pressed by `depth` along `inward` from where it is anchored.
struct Press {
  Mode mode{};
  double normal{}, tangent{};
};

Press press(const std::shared_ptr<const Surface>& surface, const Eigen::Vector3d& place, const Eigen::Vector3d& n,
            double depth) {
  Middleware law(surface, Eigen::Vector3d::Zero(), {mu_s, mu_d}, {}, 1);
  const std::array<Eigen::Vector3d, 1> point{Eigen::Vector3d::Zero()};
  Pose hand{Eigen::Quaterniond::Identity(), place};
  law.seed(0, hand, {}, point, 0.02);
  hand.p = law.patches()[0].samples[0].anchor.C_O - depth * n;
  const Eigen::Vector3d f = law.frame(0.01, std::span<const Pose>(&hand, 1), {}).force;
  return {law.patches()[0].samples[0].mode, -f.dot(n), (f - f.dot(n) * n).norm()};
}

TEST(PaperVoxelNormals, L3_11_PressingASlopeSlips) {
  Worst worst;
  const PrintedFace f{.friction = {mu_s, mu_d}};
  for (const double slope : {0.4, std::numbers::pi / 4, 1.2}) {
    const auto truth = tilted_press(f, slope);
    const Eigen::Vector3d n(std::sin(slope), 0, std::cos(slope));
    const Press p = press(std::make_shared<PlaneSurface>(0), {0, 0, 0}, n, f.depth);  // the law is given z for n
    EXPECT_EQ(p.mode == Mode::stick, truth.sticks);
    worst.expect(p.normal, truth.normal);
    if (!truth.sticks) worst.expect(p.tangent, truth.tangent);
  }
}

TEST(PaperVoxelNormals, L3_11_OnTheVoxelsOfARealSlope) {
  Worst worst;
  const PrintedFace f{.friction = {mu_s, mu_d}};
  for (const double slope : {0.4, std::numbers::pi / 4}) {
    Mesh mesh = make_box({0.06, 0.03, 0.03});
    const Eigen::Matrix3d R = Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitY()).toRotationMatrix();
    for (Eigen::Vector3d& v : mesh.vertices) v = R * v;
    const auto field = voxelize(mesh, {.voxel_size = 0.001});
    const Eigen::Vector3d n = R.col(2), place = 0.015 * n;
    const auto truth = tilted_press(f, slope);
    const Press voxels = press(std::make_shared<FieldSurface>(field, Normals::voxel), place, n, f.depth);
    EXPECT_EQ(voxels.mode == Mode::stick, truth.sticks);
    worst.expect(voxels.normal, truth.normal);
    if (!truth.sticks) worst.expect(voxels.tangent, truth.tangent);
    for (const Normals kind : {Normals::triangle, Normals::smooth}) {
      const Press p = press(std::make_shared<FieldSurface>(field, kind), place, n, f.depth);
      EXPECT_EQ(p.mode, Mode::stick);
      EXPECT_NEAR(p.normal, 0.25, 1e-5);  // floats of the distance turn the smooth normal by 1e-7 / 1e-3 a voxel
    }
  }
}

// --- L3-12: a cycle that gives energy --------------------------------------------------------------------------------

TEST(PaperCycle, L3_12_PressShearReleaseGivesEnergy) {
  Worst worst;
  const double d1 = 0.002, d2 = 0.005, s = 0.002, first = mu_s * d1;
  Options options;
  options.ray_offset = 1e-16;  // ε -> 0: a slipping frame moves the anchor by ε / d = 5e-14 of its lag
  OneSample sample({std::make_shared<PlaneSurface>(0), 0}, 0, {mu_s, mu_d}, options);
  // Tangent and normal force are linear between these places: the trapezoid is exact. Break-away lies between two that
  // are 2e-14 apart.
  const std::vector<std::array<double, 2>> cycle{
      {0, 0}, {0, d1}, {first * (1 - 1e-14), d1}, {first * (1 + 1e-14), d1}, {s, d1}, {s, d2}, {0, d2}, {0, 0}};
  double given = 0;
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Pose hand = at(cycle[i][0], 0, -cycle[i][1]);
    const Eigen::Vector3d f = sample.law.frame(1, std::span<const Pose>(&hand, 1), {}).force;
    const Eigen::Vector2d force(f.x(), -f.z());
    if (i > 0) {
      const Eigen::Vector2d way(cycle[i][0] - cycle[i - 1][0], cycle[i][1] - cycle[i - 1][1]);
      given -= way.dot(force + last) / 2;
    }
    last = force;
  }
  PrintedFace f{.friction = {mu_s, mu_d}, .depth = d1};
  worst.expect(given, cycle_gain(f, s));
}

// --- L3-13: a ball ---------------------------------------------------------------------------------------------------

double angle_after(const Surface& surface, double R, double d, double angle, int rays) {
  Spot anchor{R * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)), {}};
  anchor.n_O = anchor.C_O / R;
  for (int k = 0; k < rays; ++k) cast_anchor(surface, {0, 0, R - d}, {}, anchor);
  return std::atan2(anchor.C_O.x(), anchor.C_O.z());
}

TEST(PaperBall, L3_13_AnchorsContractTowardsTheClosestPoint) {
  Worst worst;
  const SphereSurface ball(0.03);
  double truth = 0.1;
  for (int k = 1; k <= 20; ++k) {
    truth = closed_form::ball_anchor(0.03, 0.0025, 0.001, truth);
    worst.expect(angle_after(ball, 0.03, 0.0025, 0.1, k), truth);
  }
}

TEST(PaperBall, L3_13_OnAPolyhedronWithinItsGeometry) {
  constexpr double R = 0.03, d = 0.0025, eps = 0.001;
  const FieldSurface ball(voxelize(make_sphere(R, 5), {.voxel_size = 0.001}), Normals::triangle);
  // Facets of circumradius r are at most R (1 − cos τ) below the ball and turned by at most τ = asin(r / R). One ray
  // then ends at most q ε τ beside (the origin is displaced) plus lag sag / (d + ε) (the face is deeper).
  const double edge = 1.2 * R / 32, turn = edge / std::sqrt(3.0) / R, sag = R * (1 - std::cos(turn));
  const double q = d / (d + eps), bound = (q * eps * turn + 0.1 * R * sag / (d + eps)) / R;
  EXPECT_NEAR(angle_after(ball, R, d, 0.1, 1), closed_form::ball_anchor(R, d, eps, 0.1), bound);
  EXPECT_LT(bound, 1e-3);
}

}  // namespace
}  // namespace handhold::realtime::paper
