// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cases/model/face_graph.hpp"
#include "cases/model/mesh.hpp"

namespace handhold {

/// Regular grid of nodes: node (i, j, k) lies at origin + spacing (i, j, k). A node is the centre of a voxel.
struct Grid {
  Eigen::Vector3d origin{Eigen::Vector3d::Zero()};  ///< [m], object frame
  double spacing{};                                 ///< voxel size h [m]
  Eigen::Vector3i size{Eigen::Vector3i::Zero()};    ///< nodes along x, y, z

  [[nodiscard]] std::size_t count() const {
    return std::size_t(size.x()) * std::size_t(size.y()) * std::size_t(size.z());
  }
  [[nodiscard]] std::size_t index(int i, int j, int k) const {  // x fastest
    return (std::size_t(k) * std::size_t(size.y()) + std::size_t(j)) * std::size_t(size.x()) + std::size_t(i);
  }
  [[nodiscard]] Eigen::Vector3d node(int i, int j, int k) const { return origin + spacing * Eigen::Vector3d(i, j, k); }
};

/// A point of the surface: where, which way is out, and how far the query point is (negative: query inside the solid).
struct SurfacePoint {
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< on the surface [m]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< unit, outward
  double distance{};                             ///< signed [m]
  int triangle{-1};
};

struct RayHit {
  double t{};                                    ///< distance along the unit direction [m]
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< unit outward normal of the triangle hit (lowest index on ties)
  int triangle{-1};
};

/// Signed distance and its gradient, interpolated between the nodes.
struct DistanceSample {
  double distance{};  ///< < 0 inside [m]; beyond the band ±band (or more, off the grid)
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};  ///< of the interpolant, not normalised; zero beyond the band
};

/// A solid as voxels: occupancy, signed distance in a band around the surface, and the triangles of every cell.
///
/// What both engines share of an object's shape. Object frame O; immutable once built (see `voxelize`), so that any
/// number of threads may query it. Queries do not allocate.
class VoxelField {
 public:
  struct Data {
    Mesh mesh{};
    Grid grid{};
    double band{};                          ///< |distance| is exact up to here and ±band beyond [m]
    std::vector<std::uint64_t> occupied{};  ///< bit `grid.index(i,j,k)`: node inside the solid
    std::vector<float> distance{};          ///< per node, [m]; dense, x fastest
    double cell_size{};                     ///< edge of the triangle cells [m]
    Eigen::Vector3d cell_origin{Eigen::Vector3d::Zero()};
    Eigen::Vector3i cell_count{Eigen::Vector3i::Zero()};
    std::vector<std::uint32_t> cell_start{};  ///< CSR: cell c holds cell_triangles[cell_start[c] .. cell_start[c+1])
    std::vector<std::uint32_t> cell_triangles{};  ///< ascending within a cell
  };

  /// Takes ready data (from `voxelize` or the cache); throws InputError if its sizes do not fit together.
  explicit VoxelField(Data data);

  [[nodiscard]] const Mesh& mesh() const { return data_.mesh; }
  [[nodiscard]] const FaceGraph& faces() const { return faces_; }
  [[nodiscard]] const Grid& grid() const { return data_.grid; }
  [[nodiscard]] double band() const { return data_.band; }
  [[nodiscard]] const Data& data() const { return data_; }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const { return bounds_; }  ///< of the mesh

  /// Whether the centre of voxel (i, j, k) lies inside the solid.
  [[nodiscard]] bool occupied(int i, int j, int k) const;
  [[nodiscard]] std::size_t occupied_count() const;

  /// Trilinear signed distance and its gradient at `p_O`. Off the grid: band + distance to the grid, gradient away from
  /// it.
  [[nodiscard]] DistanceSample distance(const Eigen::Vector3d& p_O) const;

  /// Exact closest surface point within `max_distance`; nothing if there is none. The normal is the direction to the
  /// query point, or the angle-weighted pseudonormal of the feature when the query lies on the surface (within 1e-6
  /// voxels).
  [[nodiscard]] std::optional<SurfacePoint> closest(const Eigen::Vector3d& p_O, double max_distance) const;

  /// First exact hit of the ray `origin_O + t direction_O`, 0 <= t <= t_max; `direction_O` must be unit.
  [[nodiscard]] std::optional<RayHit> raycast(const Eigen::Vector3d& origin_O, const Eigen::Vector3d& direction_O,
                                              double t_max) const;

 private:
  struct Triangle {  // copied out of the mesh, so that a query touches one place a triangle
    Eigen::Vector3d a, b, c, n;
  };
  struct Search;

  void build_normals();
  [[nodiscard]] double reach(const Eigen::Vector3d& p_O) const;
  [[nodiscard]] Search search(const Eigen::Vector3d& p_O, double radius) const;
  [[nodiscard]] Eigen::Vector3d feature_normal(int triangle, int feature) const;

  Data data_;
  Eigen::AlignedBox3d bounds_;
  FaceGraph faces_;
  std::vector<Triangle> triangles_;
  std::vector<Eigen::Vector3d> vertex_normals_;     // angle weighted
  std::vector<Eigen::Vector3d> edge_normals_;       // sum over the edge's triangles, normalised
  std::vector<std::array<int, 3>> triangle_edges_;  // into edge_normals_; edge i runs from corner i to corner i + 1
};

}  // namespace handhold
