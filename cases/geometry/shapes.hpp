// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Procedural closed solids, outward oriented, centred at the origin of O (centre of volume), in metres. All throw
/// InputError for a size <= 0 or a count below its least. Curved ones are inscribed polyhedra: `solid_properties` is
/// exact for them.
[[nodiscard]] Mesh make_box(const Eigen::Vector3d& size);

/// Icosahedron split `subdivisions` times (0 to 7), its 20 · 4^subdivisions triangles' corners on the sphere.
[[nodiscard]] Mesh make_sphere(double radius, int subdivisions = 4);

/// Prism over a regular polygon of `segments` >= 3 corners, along z.
[[nodiscard]] Mesh make_cylinder(double radius, double height, int segments = 64);

/// Two legs along +x and +y from a common corner, `width` wide each, `height` along z; a concave solid.
[[nodiscard]] Mesh make_l_shape(double leg_x, double leg_y, double width, double height);

/// Ring of circular section around z; `segments` >= 3 each way.
[[nodiscard]] Mesh make_torus(double major_radius, double minor_radius, int segments = 64, int section_segments = 32);

/// Rectangular plate, `size.z` thick, with a round hole along z through its middle; `segments` >= 16, a multiple of 4.
[[nodiscard]] Mesh make_plate_with_hole(const Eigen::Vector3d& size, double hole_radius, int segments = 64);

/// Cylindrical cup, open at the top (+z), with a flat bottom as thick as the wall.
[[nodiscard]] Mesh make_cup(double radius, double height, double wall, int segments = 96);

struct MugSize {
  double radius{0.04};            ///< outer [m]
  double height{0.095};           ///< [m]
  double wall{0.003};             ///< thickness of wall and bottom [m]
  double handle_gap{0.025};       ///< from the wall to the inside of the handle's bow [m]
  double handle_thickness{0.01};  ///< [m]
  int segments{96};               ///< around; >= 48
};

/// A cup with a solid bow-shaped handle on +x: one surface, genus 1, no overlap.
[[nodiscard]] Mesh make_mug(const MugSize& size = {});

struct ToolSize {
  double handle_length{0.25};                ///< [m]
  double handle_radius{0.014};               ///< [m]
  Eigen::Vector3d head{0.11, 0.034, 0.034};  ///< along x (across the handle), y, z [m]
  int segments{64};                          ///< around the handle; >= 16, a multiple of 4
};

/// A round handle along z with a block across its upper end.
[[nodiscard]] Mesh make_hammer(const ToolSize& size = {});

/// As the hammer, but its head runs out to a sharp edge on +x, parallel to z, three times as far as the poll on −x.
[[nodiscard]] Mesh make_axe(const ToolSize& size = {0.4, 0.015, {0.16, 0.034, 0.08}, 64});

/// A chess pawn: a revolved profile with foot, waist, collar and ball.
[[nodiscard]] Mesh make_pawn(double height = 0.055, int segments = 64);

/// A bowl that widens to `radius` at its rim like a quarter of an ellipse, open at +z, `wall` thick.
[[nodiscard]] Mesh make_bowl(double radius = 0.06, double height = 0.045, double wall = 0.004, int segments = 64);

/// A bottle, filled to the brim: a cylinder, shoulders, and a neck of 0.4 radii; 0.6 of its height is the cylinder.
[[nodiscard]] Mesh make_bottle(double radius = 0.033, double height = 0.2, int segments = 64);

struct ShapeParameter {
  std::string name{};
  double value{};  ///< default
  std::string meaning{};
};

struct ShapeKind {
  std::string name{};
  std::string meaning{};
  std::vector<ShapeParameter> parameters{};
};

/// The kinds `make_shape` knows, with the defaults of their parameters.
[[nodiscard]] std::vector<ShapeKind> shape_kinds();

/// The shape of a scene file: `kind` as in `shape_kinds`, given parameters in place of the defaults. Throws InputError
/// listing the valid names for an unknown kind or parameter.
[[nodiscard]] Mesh make_shape(std::string_view kind, const std::map<std::string, double>& parameters = {});

}  // namespace handhold
