#include <cmath>

#include "cases/closed_form/printed_grasp.hpp"
#include "realtime/paper/hand_contact.hpp"
#include "tests/realtime/paper/rig.hpp"

// An object under the printed law and a frame-rate engine, against exact maps (L3-05, 06, 08 to 10, 16 to 18).

namespace handhold::realtime::paper {
namespace {

using closed_form::FrameOrder;
using closed_form::PinchFrame;
using closed_form::PrintedFace;
using closed_form::PrintedPinch;
using closed_form::SpringFrames;
using testing::at;
using testing::frame;
using testing::gravity;
using testing::Pinch;
using testing::Worst;

constexpr double mu_s = 0.5, mu_d = 0.4;
constexpr Friction friction{mu_s, mu_d};
const Friction sticky{100, 100};

PrintedPinch printed(double mass, Order order = Order::force_first) {
  PrintedPinch p{.face = {.friction = friction}, .samples = 16, .mass = mass, .gravity = gravity};
  p.order = order == Order::force_first ? FrameOrder::force_first : FrameOrder::anchor_first;
  return p;
}

class InAPinch : public ::testing::TestWithParam<const char*> {
 protected:
  Worst worst;
};

INSTANTIATE_TEST_SUITE_P(Paper, InAPinch, ::testing::Values("plane", "field"),
                         [](const auto& given) { return std::string(given.param); });

TEST_P(InAPinch, L3_05_TooHeavyItCreepsAtATerminalSpeed) {
  for (const Order order : {Order::force_first, Order::anchor_first}) {
    const PrintedPinch p = printed(0.3, order);
    Options options;
    options.order = order;
    Pinch pinch(GetParam(), p.face.depth, p.mass, friction, options);
    PinchFrame map;
    for (int k = 0; k < 400; ++k) {  // the transient shrinks by sqrt(q) a frame: 1e-29; the box is long enough
      pinch.advance(frame);
      map = next_pinch(p, map);
      ASSERT_EQ(pinch.slips(), map.slips) << "frame " << k;
      worst.expect(pinch.speed(), map.speed);
    }
    worst.expect(pinch.speed(), terminal_speed(p));
  }
}

/// Whether a sliding start at the steady state of `p` goes on for 900 frames.
bool slides_on(const char* kind, const PrintedPinch& p) {
  Pinch pinch(kind, p.face.depth, p.mass, friction, {});
  pinch.set_lag(p.mass * p.gravity / (p.samples * p.face.gamma * mu_d), Mode::slip);
  pinch.host.body().motion.v.z() = -terminal_speed(p);
  for (int k = 0; k < 900; ++k) {
    pinch.advance(frame);
    if (!pinch.slips()) return false;
  }
  return true;
}

TEST_P(InAPinch, L3_06_StuckAndSlidingBothLast) {
  PrintedPinch p = printed(0.15);
  Pinch rest(GetParam(), p.face.depth, p.mass, friction, {});
  rest.set_lag(p.mass * p.gravity / 1600, Mode::stick);
  for (int k = 0; k < 900; ++k) rest.advance(frame);
  EXPECT_LT(std::abs(rest.fall()), 1e-12);  // rounding of the balance m g = K lag, oscillating undamped
  EXPECT_LT(terminal_speed(p) * 10, 0.9);   // 900 frames stay on the box
  EXPECT_TRUE(slides_on(GetParam(), p));
  for (const double share : {0.98, 1.02}) {
    p.mass = share * sliding_mass(p);
    EXPECT_EQ(slides_on(GetParam(), p), share > 1) << share;
  }
}

// --- L3-08: stability ------------------------------------------------------------------------------------------------

/// Growth per frame of a stuck object, from two runs x, y: both obey x'' − tr x' + det x = 0 from frame to frame, so
/// x_n y_{n+1} − x_{n+1} y_n grows by det a frame.
double growth(double mass, const HostOptions& host, double damping = 0) {
  constexpr int frames = 10;
  std::array<std::vector<double>, 2> x;
  for (int run = 0; run < 2; ++run) {
    Options options;
    options.damping = damping;
    Pinch pinch("plane", 0.0025, mass, sticky, options, 8, host);
    pinch.host.body().motion.v.y() = run == 0 ? 0.1 : -0.03;
    for (int k = 0; k < frames + 3; ++k) {
      pinch.advance(frame);
      if (k == 0 && run == 1) pinch.host.body().motion.v.y() += 0.07;  // another mixture of the two solutions
      if (k > 0) x[std::size_t(run)].push_back(pinch.host.body().motion.X_WO.p.y());
    }
  }
  const auto area = [&](std::size_t n) { return x[0][n] * x[1][n + 1] - x[0][n + 1] * x[1][n]; };
  return std::pow(area(frames) / area(0), 1.0 / (2 * frames));
}

TEST(PaperStability, L3_08_GrowthPerFrame) {
  Worst worst;
  const SpringFrames s{0.2, 1600, frame};
  worst.expect(growth(0.2, {}), 1);
  worst.expect(growth(0.2, {.integrator = Integrator::explicit_euler}), explicit_growth(s));
  worst.expect(growth(0.2, {.old_pose = true}), delayed_growth(s));
  worst.expect(growth(0.2, {.integrator = Integrator::exact_hold}), exact_hold_growth(s));
  for (const int n : {2, 3, 4, 8}) worst.expect(growth(0.2, {.substeps = n, .hold_force = true}), held_growth(s, n));
  // With a dashpot c: det = 1 − κ + w (n − 1) / (2 n), κ = c dt / m, from the same two-line map.
  const double w = spring_number(s), c = 0.3, kappa = 16 * c * frame / 0.2;
  for (const int n : {1, 4})
    worst.expect(growth(0.2, {.substeps = n, .hold_force = true}, c), std::sqrt(1 - kappa + w * (n - 1) / (2 * n)));
}

/// Largest excursion of a stuck object over 3000 frames, kicked at 1 mm/s.
double excursion(double mass, double damping, const HostOptions& host) {
  Options options;
  options.damping = damping;
  Pinch pinch("plane", 0.0025, mass, sticky, options, 8, host);
  pinch.host.body().motion.v.y() = 0.001;
  double most = 0;
  for (int k = 0; k < 3000; ++k) {
    pinch.advance(frame);
    most = std::max(most, std::abs(pinch.host.body().motion.X_WO.p.y()));
  }
  return most;
}

TEST(PaperStability, L3_08_LeastMassAndDashpot) {
  const double least = closed_form::least_stable_mass(1600, frame);
  EXPECT_LT(excursion(1.01 * least, 0, {}), 1e-3);  // ten times its first step of 11 µm
  EXPECT_GT(excursion(0.99 * least, 0, {}), 1);
  // w + 2 c dt / m < 4 for a dashpot c in all (16 samples), at 0.2 kg.
  const double w = spring_number(SpringFrames{0.2, 1600, frame}), most = (4 - w) / 2 * 0.2 / frame / 16;
  EXPECT_LT(excursion(0.2, 0.99 * most, {}), 1e-3);
  EXPECT_GT(excursion(0.2, 1.01 * most, {}), 1);
  // Sub-steps computed anew have the least mass of their own, shorter step.
  EXPECT_LT(excursion(0.3 * least, 0, {.substeps = 2}), 1e-3);
  EXPECT_GT(excursion(0.2 * least, 0, {.substeps = 2}), 1);
}

// --- L3-09: the centroid ---------------------------------------------------------------------------------------------

/// Vertical force on the object of one capsule (radius 8 mm) whose centroid is at `height` above the face, after it
/// came down from afar.
struct Approach {
  HandContact contact;
  HandFrame hand{};
  static constexpr double top = 0.03125, radius = 0.008;

  explicit Approach(const Options& options)
      : contact(voxelize(make_box({0.125, 0.125, 0.0625}), {.voxel_size = 1.0 / 256}), Normals::triangle,
                Eigen::Vector3d::Zero(), friction, options, {model()}) {
    hand.present = true;
    for (Pose& X : hand.X_WP) X.p.z() = 10;
  }
  static HandModel model() {
    HandModel m = anatomical_hand();
    m.capsules[5] = {0, radius};
    return m;
  }
  double force(double height) {
    hand.X_WP[5].p.z() = top + height;
    return contact.frame(frame, std::span<const HandFrame>(&hand, 1), {}).force.z();
  }
};

TEST(PaperCentroid, L3_09_DeadZoneOfOneRadius) {
  Worst worst;
  Options options;
  options.point = Point::centroid;
  Approach approach(options);
  for (int k = 0; k <= 120; ++k) {  // 0.1 m/s in frames of 1 ms, touching at k = 20
    const double height = Approach::radius + 0.002 - k * 1e-4;
    const double force = approach.force(height);
    if (height < -1e-15) {
      worst.expect(force, 8 * 100 * height);
    } else {
      EXPECT_EQ(force, 0) << height;
    }
  }
  EXPECT_NEAR(closed_form::dead_time(Approach::radius, 0.1), 80e-3, 1e-15);  // from k = 20 to 100
}

TEST(PaperContactOffset, APatchComesAtTheOffsetAndGoesAtTwiceIt) {
  Approach approach({});
  const auto active = [&] { return approach.contact.middleware().patches()[5].active; };
  for (const auto& [gap, expected] : {std::pair{0.0021, false}, std::pair{0.0019, true}, std::pair{0.0039, true},
                                      std::pair{0.0041, false}, std::pair{0.003, false}}) {
    EXPECT_EQ(approach.force(Approach::radius + gap), 0);
    EXPECT_EQ(active(), expected) << gap;
  }
}

TEST(PaperCentroid, L3_09_UngatedItSticksToTheFinger) {
  Worst worst;
  Options options;
  options.point = Point::centroid;
  options.gate = Gate::none;
  options.apart_anchor = ApartAnchor::stays;
  const double largest = closed_form::largest_pull(100, 8, Approach::radius);
  Approach fixed_sign(options);
  worst.expect(fixed_sign.force(Approach::radius), largest);  // lifts
  options.sign = Sign::as_printed;
  Approach as_printed(options);
  worst.expect(as_printed.force(Approach::radius), -largest);  // repels before the centroid is in
}

TEST_P(InAPinch, L3_09_HoldsFromThePenetrationOfTheFormula) {
  const PrintedPinch p = printed(0.2);
  const double depth = holding_penetration(p, 0.008) - 0.008;
  for (const double share : {1 - 1e-9, 1 + 1e-9}) {
    Pinch pinch(GetParam(), share * depth, p.mass, friction, {});
    pinch.set_lag(p.mass * gravity / 1600, Mode::stick);
    pinch.advance(frame);
    EXPECT_EQ(pinch.slips(), share < 1);
  }
}

// --- L3-10, 18: let go unstretched -----------------------------------------------------------------------------------

bool slips_within(Pinch& pinch, double dt, int frames) {
  for (int k = 0; k < frames; ++k) {
    pinch.advance(dt);
    if (pinch.slips()) return true;
  }
  return false;
}

TEST_P(InAPinch, L3_10_ReleaseHalvesTheThreshold) {
  const double dt = 1e-4, critical = closed_form::release_mass(1600, gravity, 0.00125);
  // O(dt²): the overshoot is larger by m_min / (4 m) = 1e-5, and frames miss its peak by at most w / 16 = 1e-5 of it.
  for (const double share : {1 - 2e-5, 1 + 2e-5}) {
    Pinch pinch(GetParam(), 0.0025, share * critical, friction, {});
    EXPECT_EQ(slips_within(pinch, dt, 600), share > 1) << share;  // the first peak comes after 250 frames
  }
}

TEST_P(InAPinch, L3_18_LagAfterRelease) {
  struct Set {
    double mass;
    int samples;
    double dt;
  };
  for (const Set& set : {Set{0.1, 8, frame}, Set{0.06, 8, frame}, Set{0.3, 20, 1.0 / 60}}) {
    const SpringFrames s{set.mass, 200.0 * set.samples, set.dt};
    Pinch pinch(GetParam(), 0.0025, set.mass, sticky, {}, set.samples);
    double most = 0;
    for (int n = 1; n <= 1000; ++n) {
      pinch.advance(set.dt);
      most = std::max(most, pinch.fall());
      if (n <= 37) worst.expect(pinch.fall(), released_lag(s, gravity, n));
    }
    EXPECT_LE(most, largest_released_lag(s, gravity) * (1 + 1e-12));
    EXPECT_GT(most, largest_released_lag(s, gravity) * 0.9999);  // 1000 phases come near the crest
  }
}

TEST_P(InAPinch, L3_18_WindowOfMassesThatDoNotSlip) {
  const auto window = closed_form::release_window(1600, frame, gravity, 0.00125);
  ASSERT_TRUE(window.has_value());
  for (const auto& [mass, slips] : {std::pair{0.995 * window->least, true}, std::pair{1.005 * window->least, false},
                                    std::pair{0.995 * window->most, false}, std::pair{1.005 * window->most, true}}) {
    Pinch pinch(GetParam(), 0.0025, mass, friction, {});
    EXPECT_EQ(slips_within(pinch, frame, 5000), slips) << mass;
  }
}

// --- L3-16, 17 -------------------------------------------------------------------------------------------------------

TEST(PaperOpening, L3_16_CreepsOutAsTheFingersOpen) {
  Worst worst;
  PrintedPinch p = printed(0.2);
  const double d0 = 0.004, rate = 0.0002, onset = [&] {
    PrintedPinch start = p;
    start.face.depth = d0;
    return opening_onset(start, rate);
  }();
  Pinch pinch("plane", d0, p.mass, friction, {});
  pinch.set_lag(p.mass * gravity / 1600, Mode::stick);
  PinchFrame map{.lag = p.mass * gravity / 1600};
  double first_slip = -1;
  for (int k = 0; k < 1800; ++k) {
    p.face.depth = d0 - rate * k * frame;
    pinch.close(p.face.depth);
    pinch.advance(frame);
    map = next_pinch(p, map);
    ASSERT_EQ(pinch.slips(), map.slips) << "frame " << k;
    if (map.slips && first_slip < 0) first_slip = k * frame;
    // The object is 1.7 m away in the end: 2e-16 of position is 1e-13 of a lag of 2.5 mm; while it sticks, the fall is
    // rounding itself.
    if (map.fall > 1e-6) worst.expect(pinch.fall(), map.fall);
  }
  EXPECT_GE(first_slip, onset);
  EXPECT_LT(first_slip, onset + frame);
  p.face.depth = d0;
  EXPECT_NEAR(pinch.fall() / opening_creep(p, rate), 1, 3e-3);  // O(rate): printed_law_test shows that it halves
}

TEST(PaperDrag, L3_17_TheBlockLagsBehindTheFinger) {
  Worst worst;
  const closed_form::PrintedDrag drag{{.friction = friction, .depth = 0.004}, 8, 0.2, 0.2, gravity};
  const double V = 0.3, N = 8 * 100 * 0.004, load = 0.2 * (N + drag.mass * gravity);
  ASSERT_TRUE(drag_slides(drag));
  HostBody body;
  body.mass = drag.mass;
  body.mobility = Mobility::translation;
  body.motion.v.x() = 0.2;
  Host host(Middleware(std::make_shared<PlaneSurface>(0), Eigen::Vector3d::Zero(), friction, {}, 1), body,
            Eigen::Vector3d::Zero());
  Pose hand = at(0, 0, -0.004);
  host.middleware().seed(0, hand, {}, testing::ring(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 0.003, 8),
                         0.02);
  for (std::size_t i = 0; i < 8; ++i) {  // sliding: the lag starts 20 % above its steady value
    Spot spot = host.middleware().patches()[0].samples[i].anchor;
    spot.C_O.x() -= 1.2 * load / (8 * 100 * mu_d);
    host.middleware().set(0, int(i), spot, Mode::slip);
  }
  // The table: it carries weight and pressure, and rubs against the motion.
  const Wrench table{{-load, 0, N}, Eigen::Vector3d::Zero()};
  for (int k = 0; k < 600; ++k) {
    host.advance(frame, std::span<const Pose>(&hand, 1), table);
    hand.p.x() += V * frame;
    ASSERT_GT(host.body().motion.v.x(), 0) << "the table's friction would turn";
    ASSERT_EQ(host.middleware().patches()[0].samples[0].mode, Mode::slip);
  }
  worst.expect(V - host.body().motion.v.x(), drag_lag_speed(drag));
}

}  // namespace
}  // namespace handhold::realtime::paper
