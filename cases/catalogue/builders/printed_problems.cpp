// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/printed_problems.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::FrameOrder;
using closed_form::PrintedFace;
using closed_form::PrintedPinch;
using Eigen::Vector3d;

printed::Shape box(const Vector3d& size) {
  return printed::Voxels{voxelize(make_box(size), {.voxel_size = 1.0 / 64, .band = 1.0 / 16})};
}

printed::Shape face_up(Ground ground) {
  if (ground == Ground::planes) return printed::Plane{};
  return box({2, 0.125, 2 * half_slab});
}

printed::Shape slab(Ground ground) {
  if (ground == Ground::planes) return printed::Slab{half_slab};
  return box({2 * half_slab, 0.125, 2});
}

PrintedProblem fixed_face(Ground ground, const PrintedFace& face, int frames) {
  return {.law = law_of(face),
          .shape = face_up(ground),
          .friction = face.friction,
          .mobility = Mobility::fixed,
          .frame = face.frame,
          .frames = frames};
}

printed::Phalanx finger(double side, const PrintedPinch& pinch, const PinchStart& start) {
  const double x = side * (half_slab - pinch.face.depth);
  printed::Phalanx finger{.p_P = ring(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(), 0.004, pinch.samples / 2),
                          .pose = [x](double) {
                            return Pose{.p = {x, 0, 0}};
                          }};
  if (start.lag != 0 || start.slipping)
    finger.start.assign(finger.p_P.size(), {.lag_W = start.lag * Vector3d::UnitZ(), .slipping = start.slipping});
  return finger;
}

}  // namespace

double top_of(Ground ground) { return ground == Ground::planes ? 0 : half_slab; }

printed::Options law_of(const PrintedFace& face, FrameOrder order) {
  printed::Options law;
  law.stiffness = face.gamma;
  law.ray_offset = face.offset;
  law.order = order == FrameOrder::force_first ? printed::Order::force_first : printed::Order::anchor_first;
  return law;
}

PrintedProblem on_a_face(Ground ground, const PrintedFace& face, const Scalar& x, int frames) {
  PrintedProblem problem = fixed_face(ground, face, frames);
  const double z = top_of(ground) - face.depth;
  problem.phalanges = {{.p_P = {Vector3d::Zero()}, .pose = [=](double t) { return Pose{.p = {x(t), 0, z}}; }}};
  return problem;
}

PrintedProblem ring_on_a_face(Ground ground, const PrintedFace& face, double radius, const Scalar& angle, int frames) {
  PrintedProblem problem = fixed_face(ground, face, frames);
  const double z = top_of(ground) - face.depth;
  problem.phalanges = {
      {.p_P = ring(Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX(), radius, 8), .pose = [=](double t) {
         return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(angle(t), Vector3d::UnitZ())), {0, 0, z}};
       }}};
  return problem;
}

PrintedProblem in_a_pinch(Ground ground, const PrintedPinch& pinch, const PinchStart& start, int frames) {
  return {.law = law_of(pinch.face, pinch.order),
          .shape = slab(ground),
          .friction = pinch.face.friction,
          .inertia = {.mass = pinch.mass},
          .mobility = Mobility::translation,
          .gravity = {0, 0, -pinch.gravity},
          .phalanges = {finger(-1, pinch, start), finger(1, pinch, start)},
          .frame = pinch.face.frame,
          .frames = frames};
}

void press(PrintedProblem& pinch, const Scalar& depth) {
  for (const std::size_t i : {0U, 1U}) {
    const double side = i == 0 ? -1 : 1;
    pinch.phalanges[i].pose = [=](double t) { return Pose{.p = {side * (half_slab - depth(t)), 0, 0}}; };
  }
}

std::vector<Run> on_both(const std::function<Run(Ground)>& run) {
  std::vector<Run> runs{run(Ground::planes), run(Ground::voxels)};
  runs.back().variant = "on voxels";
  return runs;
}

Limit rounding_limit(double places, double of, double gathered, const std::string& why) {
  return {.value = 4 * unit_roundoff * places / of * gathered,
          .relative = true,
          .reason = fmt::format("an exact map: four roundings of places up to {:.2g} m in {:.2g} m, times {:.2g}: {}",
                                places, of, gathered, why)};
}

double places_on(Ground ground, double reach) { return ground == Ground::planes ? reach : std::max(reach, 1.0); }

Limit ray_limit(Ground ground, const PrintedFace& face, double reach, double lag) {
  return rounding_limit(places_on(ground, reach), lag, 1 / (1 - contraction(face)),
                        "a ray keeps q of the last frame's, in all 1/(1 - q)");
}

Claim printed_claim(const std::string& quantity, double truth, const std::string& source, const Measure& measure,
                    const Limit& limit) {
  return of_pedigree(Pedigree::discrete_exact, claim(quantity, truth, "L3: " + source, measure, limit, limit));
}

Claim printed_count(const std::string& quantity, double truth, const std::string& source, const Measure& measure) {
  return printed_claim(quantity, truth, source, measure,
                       {.value = 0, .reason = "yes or no, or how many: nothing to tolerate"});
}

Case printed_case(const std::string& id, const std::string& title) {
  return {.id = id,
          .title = title,
          .level = Level::printed,
          .truth_level = "L3",
          .note = "What the printed law does, frame by frame; never what friction does."};
}

}  // namespace handhold::catalogue
