// SPDX-License-Identifier: GPL-3.0-or-later
// S1, S2, S6: an object that is gripped, lifted, held and shaken.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/scenes/benchmark_families.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/minimum_jerk.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold::catalogue {
namespace {

constexpr double finger_radius = 0.008;  // [m]
constexpr double gap = 0.01;             // of the open fingers [m]
constexpr double held_until = 0.6;       // [s]: after closing, before the lift
constexpr double duration = 11.5;        // [s]
constexpr double sample_rate = 500;      // [Hz]
constexpr double margin = 0.1;           // [s], see sample_trace
constexpr Friction friction{.mu_static = 0.8, .mu_dynamic = 0.8};

// Stiff enough that the cup of S6b, whose weight pulls 45 mm off its wall, tilts less than the depth gate can see:
// 0.11 N m over 2 sides × 8 × k × (18 mm)² × 2 = 21 N m/rad turns it by 5 mrad, 0.1 mm at the outer fingers.
// Damping is three times the critical one of S1, c = √(k m / samples) = 3 N s/m: with that the cup of S6b still swings
// on its wall while it is held, by 1e-10 m/s at its end, where the model has no creep at all. Only the first order's
// own damping would hide that.
constexpr ContactParameters contact{.stiffness = 2000, .damping = 9};

const Eigen::Quaterniond along_y{Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitX())};

/// How far hands and object have come up at `t`.
Eigen::Vector3d root(const GripPlan& plan, double t) {
  const auto ramp = [t](double begin, double end) { return minimum_jerk((t - begin) / (end - begin)); };
  double z = 0.05 * ramp(plan.pre_lift_begin, plan.pre_lift_end) + 0.30 * ramp(plan.lift_begin, plan.lift_end);
  if (t > plan.shake_begin && t < plan.shake_end) {
    const double swell =
        std::min(ramp(plan.shake_begin, plan.shake_begin + 0.5), 1 - ramp(plan.shake_end - 0.5, plan.shake_end));
    z += swell * 0.05 * std::sin(2 * std::numbers::pi * 2 * (t - plan.shake_begin));
  }
  return {0, 0, z};
}

/// A phalanx with its pose at full overlap, before the lift.
struct Placed {
  int hand{}, phalanx{};
  Eigen::Vector3d p_W{Eigen::Vector3d::Zero()};
  Eigen::Vector3d inward{Eigen::Vector3d::UnitX()};  // where it closes to
  Eigen::Quaterniond R{Eigen::Quaterniond::Identity()};
};

/// A finger whose skin, unhindered, would come `overlap` deep below the surface at `surface_W`.
Placed finger(int hand, int phalanx, const Eigen::Vector3d& surface_W, const Eigen::Vector3d& inward,
              const Eigen::Quaterniond& R, double overlap) {
  return {hand, phalanx, surface_W - inward * (finger_radius - overlap), inward, R};
}

Hand hand_of(int hand, const std::vector<Placed>& placed, const HandModel& model, const GripPlan& plan) {
  const PoseFunction poses = [=](double t) {
    std::array<Pose, phalanx_count> X_WP;
    X_WP.fill({Eigen::Quaterniond::Identity(), {0, 0, -10}});  // takes no part
    for (const Placed& p : placed) {
      if (p.hand != hand) continue;
      const Eigen::Vector3d open = p.inward * (gap + plan.overlap) * (1 - minimum_jerk(t / plan.closed));
      X_WP[std::size_t(p.phalanx)] = {p.R, p.p_W - open + root(plan, t)};
    }
    return X_WP;
  };
  const Side side = hand == 0 ? Side::left : Side::right;
  const Trace trace = sample_trace("benchmark", side, model, poses, -margin, duration + margin, sample_rate);
  Hand made;
  made.motion = std::make_shared<TraceSpline>(trace, 0);
  return made;
}

BenchmarkScene grip(Body object, const std::vector<SolidBox>& boxes, const std::vector<Placed>& placed,
                    const HandModel& model, const GripPlan& plan) {
  BenchmarkScene made;
  object.friction = friction;
  object.held_until = held_until;
  made.scene.duration = duration;
  made.scene.contact = contact;
  made.scene.bodies = {std::move(object)};
  made.boxes = {boxes};
  int hands = 0;
  for (const Placed& p : placed) {
    made.phalanges.push_back({p.hand, p.phalanx});
    hands = std::max(hands, p.hand + 1);
  }
  for (int hand = 0; hand < hands; ++hand) made.scene.hands.push_back(hand_of(hand, placed, model, plan));
  made.plan = plan;
  return made;
}

HandModel fingers(double half_length) {
  HandModel model;
  model.capsules.fill({half_length, finger_radius});
  model.palm_box.half_extents = {0.04, 0.010, 0.04};
  return model;
}

/// Square cup, open on top, its bottom at z = 0.
Mesh square_cup(double side, double height, double wall) {
  Mesh mesh;
  const auto add_ring = [&](double half, double z) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      mesh.vertices.emplace_back(x * half, y * half, z);
  };
  add_ring(side / 2, 0);              // 0: outside, bottom
  add_ring(side / 2, height);         // 4: outside, top
  add_ring(side / 2 - wall, height);  // 8: inside, top
  add_ring(side / 2 - wall, wall);    // 12: inside, bottom
  const auto add_quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (const int lower : {0, 4, 8})
    for (int i = 0; i < 4; ++i) add_quad(lower + i, lower + (i + 1) % 4, lower + 4 + (i + 1) % 4, lower + 4 + i);
  add_quad(12, 13, 14, 15);
  add_quad(0, 3, 2, 1);
  return mesh;
}

/// The cup as the study's engines have it: boxes of 1 cm.
std::vector<SolidBox> cup_boxes(double center_height) {
  constexpr double edge_length = 0.01;
  std::vector<SolidBox> boxes;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      for (int k = 0; k < 8; ++k) {
        if (k > 0 && i > 0 && i < 9 && j > 0 && j < 9) continue;
        const Eigen::Vector3d middle{(i - 4.5) * edge_length, (j - 4.5) * edge_length,
                                     (k + 0.5) * edge_length - center_height};
        boxes.push_back({Eigen::Vector3d::Constant(edge_length / 2), {Eigen::Quaterniond::Identity(), middle}});
      }
  return boxes;
}

/// The cup with its centre of mass at the origin of O; `center_height` is that of its centre above its bottom.
Body cup(double mass, double& center_height) {
  Mesh mesh = square_cup(0.1, 0.08, 0.01);
  const SolidProperties solid = solid_properties(mesh);
  center_height = solid.center.z();
  for (Eigen::Vector3d& v : mesh.vertices) v.z() -= center_height;
  Body body;
  body.name = "cup";
  body.inertia.mass = mass;
  body.inertia.about_center = solid.inertia * mass / solid.volume;
  body.field = voxelize(std::move(mesh));
  return body;
}

}  // namespace

BenchmarkScene pinch_benchmark() {
  const GripPlan plan;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.03);
  Body cube = benchmark_block("cube", half, 0, 0.2, friction);
  cube.X_WO.p.z() = half.z();
  std::vector<Placed> placed;
  for (const double side : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k) {
      // The two rows do not quite face each other, as in no real grip.
      const Eigen::Vector3d surface{side * half.x(), side > 0 ? 0.002 : -0.001,
                                    0.018 * (k - 1) + (side > 0 ? 0.001 : 0)};
      placed.push_back(finger(0, (side < 0 ? 3 : 6) + k, cube.X_WO.p + surface, {-side, 0, 0}, along_y, plan.overlap));
    }
  BenchmarkScene made = grip(std::move(cube), {{half, {}}}, placed, fingers(0.010), plan);
  made.title = "pinch of a 6 cm cube, 6 phalanges";
  return made;
}

BenchmarkScene two_hand_grip(const TwoHandGrip& options) {
  if (options.phalanges < 2 || options.phalanges > 2 * phalanx_count || options.phalanges % 2 != 0)
    throw InputError(fmt::format("phalanges={}: must be even, 2 to 32 (half of them on each side)", options.phalanges));
  const GripPlan plan;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.1);
  Body box = benchmark_block("box", half, options.voxel, 1, friction);
  box.X_WO.p.z() = half.z();
  const Eigen::Vector3d center = box.X_WO.p;
  const Eigen::Quaterniond palm_frame{(Eigen::Matrix3d() << 0, 1, 0, 1, 0, 0, 0, 0, -1).finished()};  // y along x
  std::vector<Placed> placed;
  for (int n = 0; n < options.phalanges / 2; ++n)
    for (const int hand : {0, 1}) {
      const double side = hand == 0 ? -1 : 1;
      const Eigen::Vector3d inward{-side, 0, 0};
      // Middle finger first, so that few phalanges still balance: fingers 2, 3, 1, 4, the thumb, the palm.
      constexpr std::array order{7, 10, 8, 11, 6, 9, 4, 13, 5, 14, 3, 12, 1, 0, 2, palm};
      const int phalanx = order[std::size_t(n)];
      if (phalanx == palm) {
        const double thickness = 0.010;
        const Eigen::Vector3d p{side * (half.x() + thickness - plan.overlap), 0, -0.045};
        placed.push_back({hand, palm, center + p, inward, palm_frame});
        continue;
      }
      const int row = phalanx / 3 - 1, bone = phalanx % 3;
      const Eigen::Vector3d surface =
          row < 0 ? Eigen::Vector3d(side * half.x(), side * 0.065, -0.078 + 0.026 * bone)
                  : Eigen::Vector3d(side * half.x(), -0.036 + 0.024 * row, 0.018 + 0.026 * bone);
      placed.push_back(finger(hand, phalanx, center + surface, inward, Eigen::Quaterniond::Identity(), plan.overlap));
    }
  BenchmarkScene made = grip(std::move(box), {{half, {}}}, placed, fingers(0.009), plan);
  made.title = fmt::format("two hands on a 20 cm box, {} phalanges", options.phalanges);
  made.scene.name = made.title;
  made.scene.patch.samples = options.samples;
  made.scene.contact.stiffness *= 8.0 / options.samples;  // the same grip
  made.scene.contact.damping *= 8.0 / options.samples;
  return made;
}

BenchmarkScene cup_benchmark(bool by_its_wall) {
  const GripPlan plan;
  double center_height = 0;
  Body body = cup(0.25, center_height);
  body.X_WO.p.z() = center_height;
  const double middle = 0.05 - center_height;  // of the fingers, above the centre of mass
  std::vector<Placed> placed;
  for (const double side : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k) {
      const double apart = side > 0 ? 0.002 : -0.001;
      const int phalanx = (side < 0 ? 3 : 6) + k;
      if (by_its_wall) {  // face to face: on 1 cm of wall, patches of 3 mm give way to 3 mm of offset by 15 degrees
        const Eigen::Vector3d surface{side < 0 ? 0.04 : 0.05, 0, middle + 0.018 * (k - 1)};
        placed.push_back(finger(0, phalanx, body.X_WO.p + surface, {-side, 0, 0}, along_y, plan.overlap));
      } else {
        const Eigen::Vector3d surface{side * 0.04, 0.02 * (k - 1) + apart, middle};
        placed.push_back(
            finger(0, phalanx, body.X_WO.p + surface, {side, 0, 0}, Eigen::Quaterniond::Identity(), plan.overlap));
      }
    }
  BenchmarkScene made = grip(std::move(body), cup_boxes(center_height), placed, fingers(0.010), plan);
  made.title = by_its_wall ? "cup held by its wall" : "cup held from inside";
  return made;
}

}  // namespace handhold::catalogue
