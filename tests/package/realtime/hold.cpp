// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cube between two fingertips: they close, lift it by 10 cm, and hold it for a second. Usage: hold_cpp [CUBE.hhvox]
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include <handhold/cases/model/input_error.hpp>
#include <handhold/cases/model/mass_properties.hpp>
#include <handhold/cases/model/voxel_file.hpp>
#include <handhold/realtime/world.hpp>

namespace {

using Eigen::Vector3d;
using handhold::VoxelField;
namespace rt = handhold::realtime;

constexpr int index_tip = 5, thumb_tip = 2;
constexpr double frame = 1.0 / 90;                                                    // [s]
constexpr double closed = 0.2, lift = 0.4, up = 0.9, end = 1.9;                       // [s]
constexpr double height = 0.1, mass = 0.1, gap = 0.005, depth = 0.003, half = 0.025;  // [m], [kg], [m], [m], [m]

/// The voxels of a cube as arrays: what a program does that has its own voxelizer.
std::shared_ptr<const VoxelField> cube_field() {
  VoxelField::Data data;
  for (int i = 0; i < 8; ++i)
    data.mesh.vertices.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
  data.mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  constexpr int nodes = 36;
  data.band = 0.008;
  data.grid.spacing = 0.002;
  data.grid.size = {nodes, nodes, nodes};
  data.grid.origin = Vector3d::Constant(-data.grid.spacing * (nodes - 1) / 2);
  data.occupied.assign((data.grid.count() + 63) / 64, 0);
  for (int k = 0; k < nodes; ++k) {
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i) {
        const Vector3d from_face = data.grid.node(i, j, k).cwiseAbs() - Vector3d::Constant(half);
        const double d = from_face.cwiseMax(0.0).norm() + std::min(0.0, from_face.maxCoeff());
        const std::size_t node = data.distance.size();
        data.distance.push_back(float(std::clamp(d, -data.band, data.band)));
        data.occupied[node / 64] |= std::uint64_t(d < 0) << node % 64;
      }
    }
  }
  data.cell_size = 2.2 * half;  // one cell holds all triangles
  data.cell_origin = Vector3d::Constant(-1.1 * half);
  data.cell_count = {1, 1, 1};
  data.cell_start = {0, 12};
  data.cell_triangles = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  return std::make_shared<const VoxelField>(std::move(data));
}

/// From 0 to 1 between the two times, with speed and acceleration 0 at both (minimum jerk).
double ease(double t, double from, double to) {
  const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

/// A fingertip on the side x = side * half, along the x axis.
handhold::Pose tip(const handhold::Capsule& capsule, double side, double t) {
  const double distance = gap - (gap + depth) * ease(t, 0, closed);  // of the skin from the face
  handhold::Pose X_WP;
  X_WP.R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), -side * Vector3d::UnitX());  // z towards the tip
  X_WP.p = {side * (half + distance + capsule.radius + capsule.half_length), 0, height * ease(t, lift, up)};
  return X_WP;
}

std::vector<handhold::HandFrame> hands_at(double t, const handhold::HandModel& model) {
  handhold::HandFrame hand;
  hand.present = true;
  for (handhold::Pose& far_away : hand.X_WP) far_away.p.z() = 5;  // of the phalanges that take no part
  hand.X_WP[index_tip] = tip(model.capsules[index_tip], 1, t);
  hand.X_WP[thumb_tip] = tip(model.capsules[thumb_tip], -1, t);
  return {hand};
}

rt::WorldDef world_def(std::shared_ptr<const VoxelField> field) {
  const handhold::SolidProperties solid = handhold::solid_properties(field->mesh());
  handhold::Body cube;
  cube.field = std::move(field);
  cube.inertia = {mass, solid.center, mass / solid.volume * solid.inertia};
  cube.held_until = 0.3;  // until the fingers have it
  rt::WorldDef def;
  def.bodies = {cube};
  def.hands.resize(1);  // the mean adult hand
  return def;
}

bool hold(std::shared_ptr<const VoxelField> field) {
  const rt::WorldDef def = world_def(std::move(field));
  const handhold::HandModel& model = def.hands.front().model;
  rt::World world(def, {});
  world.start(frame, hands_at(0, model));
  int slips = 0;
  for (int k = 1; k * frame <= end; ++k) {
    world.advance(frame, hands_at(k * frame, model));
    for (const handhold::Event& event : world.events()) slips += event.kind == handhold::EventKind::breakaway;
  }
  const auto& modes = world.contacts().mode;
  const auto stuck = std::count(modes.begin(), modes.end(), handhold::Mode::stick);
  // 16 samples carry the weight as springs; what swung has decayed by exp(-40) in the second.
  const double sag = mass * 9.81 / (16 * def.contact.stiffness), z = world.body().X_WO.p.z();
  std::printf("%d samples stick, %d slipped; %.3f mm above the start, %.6f mm by theory\n", int(stuck), slips, 1e3 * z,
              1e3 * (height - sag));
  return stuck == 16 && slips == 0 && std::abs(z - (height - sag)) < 1e-6;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return hold(argc > 1 ? handhold::read_voxel_file(argv[1]).field : cube_field()) ? 0 : 1;
  } catch (const handhold::InputError& error) {
    std::fprintf(stderr, "hold: %s\n", error.what());
    return 2;
  }
}
