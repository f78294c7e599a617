// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/edge_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "cases/catalogue/builders/prescribed_hand.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::EdgeContact;
using Eigen::Vector3d;

constexpr double mm = 1e-3;
constexpr double half = 30 * mm;  // of a block's side
constexpr double rest = 0.05;     // between two ways [s]
constexpr double rate = 2000;     // of the trace [Hz]: its spline then errs by 1e-12 m on these ways
constexpr int index_tip = 5;
constexpr double right_angle = std::numbers::pi / 2;

/// The solid of those cells of a 2 x 2 x 2 grid, `walls` apart, that are `full`: bit i + 2 j + 4 k of cell (i, j, k).
Mesh solid_of_cells(const std::array<double, 3>& walls, unsigned full) {
  Mesh mesh;
  std::map<std::array<int, 3>, int> corners;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = corners.try_emplace(at, int(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.emplace_back(walls[std::size_t(at[0])], walls[std::size_t(at[1])], walls[std::size_t(at[2])]);
    return found->second;
  };
  const auto is_full = [&](std::array<int, 3> c) {
    for (const int x : c)
      if (x < 0 || x > 1) return false;
    return (full >> (c[0] + 2 * c[1] + 4 * c[2]) & 1U) != 0;
  };
  for (int cell = 0; cell < 8; ++cell) {
    const std::array<int, 3> c{cell & 1, cell >> 1 & 1, cell >> 2};
    if (!is_full(c)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        std::array<int, 3> beyond = c;
        beyond[axis] += side;
        if (is_full(beyond)) continue;
        std::array<int, 3> at = c;
        at[axis] += side > 0;
        // Counter-clockwise seen from outside: along the next axis and then the one after it, or the other way round.
        const std::size_t u = (axis + (side > 0 ? 1 : 2)) % 3, v = (axis + (side > 0 ? 2 : 1)) % 3;
        std::array<int, 4> quad{};
        quad[0] = corner(at), ++at[u], quad[1] = corner(at), ++at[v], quad[2] = corner(at), --at[u],
        quad[3] = corner(at);
        mesh.triangles.push_back({quad[0], quad[1], quad[2]});
        mesh.triangles.push_back({quad[0], quad[2], quad[3]});
      }
  }
  return mesh;
}

const std::array<double, 3> halves{-half, 0, half};

struct Motion {
  Vector3d at{Vector3d::Zero()}, velocity{Vector3d::Zero()};
};

/// Minimum jerk along each leg, then a rest.
Motion on_the_way(const Vector3d& start, const std::vector<Leg>& legs, double t) {
  Vector3d from = start;
  double begin = 0;
  for (const Leg& leg : legs) {
    if (t < begin + leg.duration) {
      const double s = std::max(0.0, (t - begin) / leg.duration);
      const Vector3d way = leg.to - from;
      return {from + s * s * s * (10 - 15 * s + 6 * s * s) * way, 30 * s * s * (1 - s) * (1 - s) / leg.duration * way};
    }
    begin += leg.duration + rest;
    from = leg.to;
    if (t < begin) break;
  }
  return {from, Vector3d::Zero()};
}

}  // namespace

Mesh box_between(const Vector3d& low, const Vector3d& high) {
  Mesh mesh = solid_of_cells({0, 1, 2}, 1);
  for (Vector3d& v : mesh.vertices) v = low + v.cwiseProduct(high - low);
  return mesh;
}

Mesh convex_edge(double turn) {
  Mesh mesh = box_between({-2 * half, -half, -2 * half}, {0, half, 0});
  for (Vector3d& v : mesh.vertices)
    if (turn != right_angle) v.x() -= v.z() / std::tan(turn);
  return mesh;
}

Mesh hollow_edge() { return solid_of_cells(halves, 0b01011111); }

Mesh hollow_corner() { return solid_of_cells(halves, 0b01111111); }

EdgeScene edge_scene(const std::string& name, const Mesh& mesh, double voxel_size, const EdgeContact& contact,
                     const Vector3d& start, const std::vector<Leg>& legs) {
  EdgeScene all;
  double end = 0;
  for (const Leg& leg : legs) {
    all.arrivals.push_back(end + leg.duration + rest);
    end = all.arrivals.back();
  }
  all.path = [start, legs](double t) { return on_the_way(start, legs, t).at; };
  all.velocity = [start, legs](double t) { return on_the_way(start, legs, t).velocity; };
  Body body;
  body.name = "solid";
  body.field = voxelize(mesh, {.voxel_size = voxel_size});
  body.mobility = Mobility::fixed;
  body.friction = contact.friction;
  const SolidProperties solid = solid_properties(mesh);
  body.inertia = {1, solid.center, solid.inertia / solid.volume};
  all.scene.name = name;
  all.scene.duration = end;
  all.scene.gravity.setZero();
  all.scene.contact = {.stiffness = contact.stiffness, .damping = contact.damping};
  all.scene.bodies = {body};
  const auto pose = [path = all.path](double t) { return Pose{Eigen::Quaterniond::Identity(), path(t)}; };
  all.scene.hands = {prescribed_hand({{index_tip, {Vector3d::Zero()}, {}, pose}}, end, rate)};
  return all;
}

// Aside by 0.1 mm: not on a diagonal of the faces.
EdgeScene dragged_over(double turn, double depth, double voxel_size, const EdgeContact& contact) {
  const double y = 0.1 * mm;
  return edge_scene("dragged over a convex edge", convex_edge(turn), voxel_size, contact, {-5 * mm, y, 1 * mm},
                    {{0.2, {-5 * mm, y, -depth}}, {1, {5 * mm, y, -depth}}});
}

EdgeScene pressed_beside(double beside, double depth, double tilt, double voxel_size) {
  const double y = 0.1 * mm, slope = std::tan(tilt), above = 1 * mm;
  return edge_scene("pressed beside a convex edge", convex_edge(right_angle), voxel_size, {},
                    {slope * above - beside, y, above}, {{0.5, {-slope * depth - beside, y, -depth}}});
}

EdgeScene led_outside(double voxel_size) {
  const double y = 0.1 * mm, depth = 4 * mm;
  return edge_scene("led outside", convex_edge(right_angle), voxel_size, {}, {-0.5 * mm, y, 1 * mm},
                    {{0.3, {-0.5 * mm, y, -depth}}, {0.3, {1 * mm, y, -depth}}, {0.3, {-0.5 * mm, y, -depth}}});
}

EdgeScene back_in(double voxel_size) {
  const double y = 0.1 * mm, depth = 2 * mm;
  return edge_scene("back in through the side", convex_edge(right_angle), voxel_size, {}, {-5 * mm, y, 1 * mm},
                    {{0.2, {-5 * mm, y, -depth}}, {0.5, {3 * mm, y, -depth}}, {0.5, {-2 * mm, y, -depth}}});
}

EdgeScene into_hollow_edge(double voxel_size) {
  const double y = 0.1 * mm, depth = 2 * mm;
  return edge_scene("into a hollow edge", hollow_edge(), voxel_size, {}, {10 * mm, y, 1 * mm},
                    {{0.3, {10 * mm, y, -depth}}, {1, {-3 * mm, y, -depth}}, {1, {6 * mm, y, -depth}}});
}

EdgeScene along_groove(double voxel_size) {
  const double y = 5 * mm, depth = 2 * mm;
  return edge_scene("along a groove", hollow_edge(), voxel_size, {}, {3 * mm, -y, 1 * mm},
                    {{0.3, {3 * mm, -y, -depth}}, {0.5, {-depth, -y, -depth}}, {1, {-depth, y, -depth}}});
}

EdgeScene into_hollow_corner(double voxel_size) {
  const double x = 2 * mm, y = 3 * mm, z = 2 * mm;
  return edge_scene("into a hollow corner", hollow_corner(), voxel_size, {}, {10 * mm, 9 * mm, 1 * mm},
                    {{0.3, {10 * mm, 9 * mm, -z}}, {1, {-x, -y, -z}}, {1, {-x, -y, 5 * mm}}});
}

EdgeScene released_in_plate(double voxel_size) {
  EdgeContact contact;
  contact.damping = 10;
  const Mesh plate = box_between({-half, -half, -2 * mm}, {half, half, 2 * mm});
  return edge_scene("released in a plate", plate, voxel_size, contact, {1 * mm, 2 * mm, 3 * mm},
                    {{0.3, {1 * mm, 2 * mm, -1.2 * mm}}, {0.06, {1 * mm, 2 * mm, -0.2 * mm}}});
}

}  // namespace handhold::catalogue
