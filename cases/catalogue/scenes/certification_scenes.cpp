// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/certification_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/prescribed_hand.hpp"
#include "cases/closed_form/pulled_grip.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::catalogue {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using std::cos;
using std::sin;

constexpr int thumb = 2, index = 5;  // distal phalanges
constexpr double pi = std::numbers::pi;
constexpr double gravity = 9.81;

// Sides and voxels are powers of two: float distances of the faces are exact. Contacts keep 16 voxels from edges, where
// the spline's kinks have decayed by 0.27^16 = 7e-10 of a voxel.
constexpr double fine = 1.0 / 1024, coarse = 1.0 / 512;
constexpr double half = 1.0 / 32;  // of blocks, where the fingers are [m]

Body box(const Vector3d& size, double voxel_size, double mass, const Friction& friction) {
  Body body;
  body.name = "block";
  body.field = voxelize(make_box(size), {.voxel_size = voxel_size, .band = 16 * voxel_size});
  const Vector3d s = size.cwiseAbs2() * mass / 12;
  body.inertia.mass = mass;
  body.inertia.about_center = Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
  body.friction = friction;
  return body;
}

/// A ball whose voxels hold the distances of the exact sphere: the mesh's facets would be rougher than the spline.
Body ball(double radius, double voxel_size, double mass, const Friction& friction) {
  VoxelField::Data data = voxelize(make_sphere(radius), {.voxel_size = voxel_size, .band = 16 * voxel_size})->data();
  const Grid& grid = data.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        data.distance[grid.index(i, j, k)] =
            float(std::clamp(grid.node(i, j, k).norm() - radius, -data.band, data.band));
  Body body;
  body.name = "ball";
  body.field = std::make_shared<VoxelField>(std::move(data));
  body.inertia.mass = mass;
  body.inertia.about_center = (0.4 * mass * radius * radius * Vector3d::Ones()).asDiagonal();
  body.friction = friction;
  return body;
}

Scene scene_of(const std::string& name, double duration, const ContactParameters& contact, const Body& body,
               const std::vector<PrescribedPatch>& patches) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.contact = contact;
  scene.bodies = {body};
  scene.hands = {prescribed_hand(patches, duration, certification_rate)};
  return scene;
}

Pose at(const Vector3d& p) { return {Quaterniond::Identity(), p}; }

/// Fingers at y < 0 (side = −1) and y > 0 with `points` in the plane y = 0 of their frames. A patch holds 32 samples at
/// most: more are dealt out to two phalanges a side.
std::vector<PrescribedPatch> grip(const std::vector<Vector3d>& points, const Vector3d& lag,
                                  const std::function<Pose(double side, double t)>& pose) {
  constexpr std::size_t most = 32;
  std::vector<PrescribedPatch> patches;
  for (const double side : {-1.0, 1.0})
    for (std::size_t first = 0; first < points.size(); first += most) {
      const auto begin = points.begin() + std::ptrdiff_t(first);
      const auto end = points.begin() + std::ptrdiff_t(std::min(first + most, points.size()));
      const int phalanx = (side < 0 ? thumb : index) - int(first / most);
      const std::vector<SampleStart> start(std::size_t(end - begin), SampleStart{lag, false});
      patches.push_back({phalanx, {begin, end}, start, [pose, side](double t) { return pose(side, t); }});
    }
  return patches;
}

/// Two single samples hold a cube; the hand moves along x at constant speed from t = 0 on.
Scene pull(const closed_form::PulledGrip& p) {
  const auto pose = [p](double side, double t) { return at({p.speed * t, side * (half - p.depth), 0}); };
  const Body body = box(Vector3d::Constant(2 * half), fine, p.mass, p.friction);
  Scene scene = scene_of("pull", 0.2, {p.stiffness, 0}, body, grip({Vector3d::Zero()}, Vector3d::Zero(), pose));
  scene.gravity.setZero();
  return scene;
}

/// Two single samples hold a rod against gravity; they breathe, and the rod slides down.
Scene pinch_open(const closed_form::BreathingGrip& g) {
  const auto pose = [g](double side, double t) { return at({0, side * (2 * half - closed_form::depth(g, t)), 0}); };
  const Body body = box({4 * half, 4 * half, 0.75}, coarse, g.mass, g.friction);
  const Vector3d lag(0, 0, g.mass * g.gravity / (2 * g.stiffness));
  return scene_of("pinch-open", 0.6, {g.stiffness, 0}, body, grip({Vector3d::Zero()}, lag, pose));
}

/// A block on a palm of four samples, in equilibrium: m g = 4 k d. `pose` starts at the identity.
Scene on_palm(const std::string& name, double duration, const ContactParameters& contact, const Vector3d& size,
              double voxel_size, const std::function<Pose(double t)>& pose) {
  const double mass = 0.1, depth = mass * gravity / (4 * contact.stiffness);
  const double z = -size.z() / 2 + depth;
  const std::vector<Vector3d> points{{-0.03, -0.02, z}, {-0.03, 0.02, z}, {0.03, -0.02, z}, {0.03, 0.02, z}};
  const PrescribedPatch patch{palm, points, std::vector<SampleStart>(4), pose};
  return scene_of(name, duration, contact, box(size, voxel_size, mass, {0.5, 0.4}), {patch});
}

/// Shaken along x and, slower, along y: it rocks and slides, each sample for itself.
Scene plate() {
  const auto pose = [](double t) { return at({0.02 * (1 - cos(14 * t)), 0.011 * (1 - cos(9 * t)), 0}); };
  return on_palm("plate", 1, {400, 0}, {1.0 / 8, 1.0 / 8, 1.0 / 16}, fine, pose);
}

/// The palm turns about y: the block slides, tips over the lower samples, and lifts off.
Scene tilt(const std::string& name, double damping) {
  const auto pose = [](double t) { return Pose{Quaterniond(AngleAxisd(0.8 * t, Vector3d::UnitY())), {0, 0, 0}}; };
  return on_palm(name, 1, {400, damping}, {1.0 / 4, 1.0 / 8, 1.0 / 16}, coarse, pose);
}

/// Two patches that close and open, twist against each other and move along x. At t = 0 they are d0 − da deep.
Pose twisting(double side, double t, double surface, double mean_depth, double depth_swing) {
  const double depth = mean_depth - depth_swing * cos(6 * t);
  return {Quaterniond(AngleAxisd(side * 0.25 * sin(5 * t), Vector3d::UnitY())),
          {0.01 * (1 - cos(7 * t)), side * (surface - depth), 0}};
}

/// A point in the middle and seven on a ring, off the axis of the twist by 1 mm.
std::vector<Vector3d> pad_of_eight(double radius) {
  std::vector<Vector3d> points{{0.001, 0, 0}};
  for (int i = 1; i < 8; ++i) points.push_back({0.001 + radius * cos(2 * pi * i / 7), 0, radius * sin(2 * pi * i / 7)});
  return points;
}

/// Evenly over a disc (sunflower).
std::vector<Vector3d> pad_of_many(double radius, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / count), angle = pi * (3 - std::sqrt(5.0)) * i;
    points.push_back({0.001 + r * cos(angle), 0, r * sin(angle)});
  }
  return points;
}

Scene twist(const std::string& name, const std::vector<Vector3d>& points, double damping) {
  constexpr double mean_depth = 0.0032, swing = 0.0026;
  const Friction friction{0.8, 0.6};
  const auto pose = [=](double side, double t) { return twisting(side, t, half, mean_depth, swing); };
  const double lag = 0.9 * friction.mu_static * (mean_depth - swing);  // inside the cone; less than the weight asks for
  const double stiffness = 800 / double(points.size());
  const Body body = box({2 * half, 2 * half, 4 * half}, fine, 0.1, friction);
  return scene_of(name, 1, {stiffness, damping}, body, grip(points, {0, 0, lag}, pose));
}

Scene twisted_ball() {
  constexpr double radius = 0.03;
  const auto pose = [](double side, double t) { return twisting(side, t, radius, 0.0046, 0.0034); };
  const Body body = ball(radius, 0.001, 0.05, {0.6, 0.45});
  return scene_of("ball", 0.5, {100, 0}, body, grip(pad_of_eight(0.006), {0, 0, 0.05 * gravity / 1600}, pose));
}

/// Held so firmly that nothing slips; the hand waves and twists.
Scene smooth() {
  const auto pose = [](double side, double t) {
    return Pose{Quaterniond(AngleAxisd(side * 0.1 * sin(9 * t), Vector3d::UnitY())),
                {0.01 * (1 - cos(7 * t)), side * (half - 0.004 + 5e-4 * sin(11 * t)), 0.004 * sin(13 * t)}};
  };
  const Body body = box(Vector3d::Constant(2 * half), fine, 0.1, {8, 8});
  return scene_of("smooth", 0.5, {100, 0}, body, grip(pad_of_eight(0.006), Vector3d::Zero(), pose));
}

/// The fingers rush past a heavy cube and turn: everything slides all along.
Scene slide() {
  const auto pose = [](double side, double t) {
    return Pose{Quaterniond(AngleAxisd(0.4 * sin(12 * t), Vector3d::UnitY())),
                {0.5 * t - 0.02, side * (half - 0.006 + 5e-4 * sin(11 * t)), 0}};
  };
  std::vector<PrescribedPatch> patches = grip(pad_of_eight(0.006), Vector3d::Zero(), pose);
  for (PrescribedPatch& patch : patches)
    for (SampleStart& start : patch.start) start.slipping = true;
  Scene scene = scene_of("slide", 0.06, {100, 0}, box({4 * half, 2 * half, 2 * half}, fine, 1, {0.5, 0.4}), patches);
  scene.gravity.setZero();
  return scene;
}

Limit bound(double value, const char* what) {
  return {.value = value, .reason = std::string("what the preset 'certified' promises for ") + what};
}

const Limit position = bound(1e-7, "positions"), event_time = bound(1e-6, "event times");

Measure event(EventKind kind) { return {.kind = Measure::Kind::event_time, .event = kind}; }

std::vector<Claim> pull_truths(const closed_form::PulledGrip& p, double end) {
  const double final = object_position(p, end) - p.speed * end;
  return {{"breakaway",
           "s",
           breakaway_time(p),
           Pedigree::exact,
           "t1 = asin(mu_s d w / V) / w, w = sqrt(2 k / m)",
           event(EventKind::breakaway),
           event_time,
           {},
           false},
          {"restick",
           "s",
           restick_time(p),
           Pedigree::exact,
           "t2 = t1 + V cos(w t1) m / (2 mu_d k d)",
           event(EventKind::restick),
           event_time,
           {},
           false},
          {"cube against the hand at the end",
           "m",
           final,
           Pedigree::exact,
           "V t - x, slip and ringing about the lag",
           {.kind = Measure::Kind::displacement, .axis = Vector3d::UnitX(), .at = end},
           position,
           {},
           false}};
}

std::vector<Claim> pinch_truths(const closed_form::BreathingGrip& g, double end) {
  return {{"slip onset",
           "s",
           slip_onset(g),
           Pedigree::exact,
           "2 mu_s k d(t) = m g",
           event(EventKind::breakaway),
           event_time,
           {},
           false},
          {"height at the end",
           "m",
           height(g, end),
           Pedigree::exact,
           "z'' = -g + 2 mu_d k d(t) / m, twice integrated",
           {.kind = Measure::Kind::displacement, .axis = Vector3d::UnitZ(), .at = end},
           position,
           {},
           false}};
}

std::vector<CertificationScene> make_scenes() {
  const closed_form::PulledGrip pulled;
  const closed_form::BreathingGrip breathing;
  std::vector<CertificationScene> s;
  s.push_back({"pull", "two samples pull a cube from rest: break away, stick again", [=] { return pull(pulled); }});
  s.back().claims = pull_truths(pulled, 0.2);
  s.push_back({"pinch-open", "two samples let a rod slip under its weight", [=] { return pinch_open(breathing); }});
  s.back().claims = pinch_truths(breathing, 0.6);
  s.push_back({"plate", "a block rocks and slides on a shaken palm of four samples", [] { return plate(); }});
  s.push_back({"tilt", "a block slides, tips and lifts off a turning palm", [] { return tilt("tilt", 0); }});
  s.push_back({"twist16", "two patches of eight twist, close and open on a cube",
               [] { return twist("twist16", pad_of_eight(0.006), 0); }});
  s.push_back({"twist16-damped", "the same with dampers of 0.2 N s/m",
               [] { return twist("twist16-damped", pad_of_eight(0.006), 0.2); }});
  s.push_back({"tilt-damped", "tilt with dampers of 1 N s/m", [] { return tilt("tilt-damped", 1); }});
  s.push_back({.name = "ball",
               .what = "two patches of eight twist, close and open on a ball of voxels",
               .scene = [] { return twisted_ball(); },
               .flat = false});
  s.push_back({.name = "smooth",
               .what = "a cube held firmly, waved and twisted",
               .scene = [] { return smooth(); },
               .eventless = true});
  s.push_back({.name = "slide",
               .what = "two patches of eight slide over a heavy cube",
               .scene = [] { return slide(); },
               .eventless = true});
  s.push_back({.name = "twist128",
               .what = "twist16 with two patches of 64",
               .scene = [] { return twist("twist128", pad_of_many(0.007, 64), 0); },
               .costly = true});
  return s;
}

}  // namespace

const std::vector<CertificationScene>& certification_scenes() {
  static const std::vector<CertificationScene> scenes = make_scenes();
  return scenes;
}

const CertificationScene& certification_scene(const std::string& name) {
  std::string known;
  for (const CertificationScene& s : certification_scenes()) {
    if (s.name == name) return s;
    known += (known.empty() ? "" : ", ") + s.name;
  }
  throw InputError(fmt::format("scene '{}': no such certification scene (there are {})", name, known));
}

}  // namespace handhold::catalogue
