// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cases/model/mesh.hpp"

namespace handhold {

/// An edge by which the surface turns by more than this is a crease of the object; by less, it belongs to the
/// tessellation of a smooth part [rad]. 40 degrees: a circle of ten sides (36) is smooth, a box, a hexagon and an
/// octagon (45) have edges. The facets of the built-in round shapes turn by 12 degrees at most, a mug's handle by less
/// than 40.
inline constexpr double crease_angle = 40 * 3.14159265358979323846 / 180;

enum class EdgeKind : std::uint8_t { smooth, convex, hollow };

/// A triangle, and what lies beyond its sides. Side i runs from corner i to corner i + 1.
struct Face {
  std::array<int, 3> vertex{};                 ///< of the mesh
  std::array<Eigen::Vector3d, 3> corner{};     ///< [m]
  Eigen::Vector3d n{Eigen::Vector3d::Zero()};  ///< unit, outward; zero if the triangle has no area
  std::array<Eigen::Vector3d, 3> out{};        ///< unit, in the face's plane, away from it over side i
  std::array<int, 3> beyond{-1, -1, -1};       ///< the next face with an area over side i; −1: there is none
  std::array<EdgeKind, 3> edge{};              ///< of side i: creases are convex or hollow

  /// How far inside of side i the point lies; negative: beyond it [m].
  [[nodiscard]] double inside(std::size_t i, const Eigen::Vector3d& p_O) const { return (corner[i] - p_O).dot(out[i]); }
};

/// The faces of a closed mesh, their neighbours and the mesh's creases. Plain geometry in the object's frame: what an
/// anchor does at an edge is the engines' matter. Immutable, and its queries do not allocate.
class FaceGraph {
 public:
  FaceGraph() = default;
  explicit FaceGraph(const Mesh& mesh);

  [[nodiscard]] const Face& operator[](int face) const { return faces_[std::size_t(face)]; }
  [[nodiscard]] int size() const { return int(faces_.size()); }

  /// Numbers of faces, for a loop; C++17, for the files that include Simbody.
  struct Ring {
    const int *first{}, *last{};
    [[nodiscard]] const int* begin() const { return first; }
    [[nodiscard]] const int* end() const { return last; }
  };

  /// The faces with an area that meet at a vertex of the mesh, ascending.
  [[nodiscard]] Ring around(int vertex) const {
    return {ring_.data() + start_[std::size_t(vertex)], ring_.data() + start_[std::size_t(vertex) + 1]};
  }

  /// Edges of the mesh that are creases. A body that has one is touched on its triangles everywhere: where a smooth
  /// part would end, and how it would go on to the crease, no mesh says.
  [[nodiscard]] int crease_count() const { return creases_; }

 private:
  void join();
  void find_creases();
  [[nodiscard]] int skip_slivers(int from, int face, std::size_t side) const;
  void gather_rings(std::size_t vertices);

  std::vector<Face> faces_;
  std::vector<std::uint32_t> start_{0};  // by vertex: its faces in ring_
  std::vector<int> ring_;
  int creases_{};
};

}  // namespace handhold
