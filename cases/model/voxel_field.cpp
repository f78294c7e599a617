// SPDX-License-Identifier: Apache-2.0
#include "cases/model/voxel_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "cases/model/limits.hpp"
#include "cases/model/triangle_queries.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double on_surface = 1e-6;  // nearer than this the direction to the query is noise [voxels]
constexpr double same_hit = 1e-9;    // hits this near along a ray are one place, seen by two triangles [voxels]

void require(bool holds, const char* what) {
  if (!holds) throw InputError(std::string("voxel field: ") + what + " (voxelize the mesh again)");
}

constexpr int most_nodes = 1 << 20;  // along an axis: so a product of three counts cannot overflow

bool is_length(double x) { return x >= 1e-6 && x <= most_length; }

void check_grid(const VoxelField::Data& data) {
  const Grid& grid = data.grid;
  require(is_length(grid.spacing) && grid.origin.cwiseAbs().maxCoeff() <= most_length && grid.origin.allFinite(),
          "the grid's spacing must be 1 um to 1 km and its origin no farther than 1 km");
  require(grid.size.minCoeff() >= 2 && grid.size.maxCoeff() <= most_nodes, "the grid needs 2 to 2^20 nodes a side");
  require(is_length(data.band), "the band must be 1 um to 1 km");
  require(data.distance.size() == grid.count(), "one distance a node");
  require(std::all_of(data.distance.begin(), data.distance.end(), [](float d) { return std::isfinite(d); }),
          "distances must be finite");
  require(data.occupied.size() == (grid.count() + 63) / 64, "one occupancy bit a node");
}

void check_mesh(const VoxelField::Data& data) {
  const Mesh& mesh = data.mesh;
  require(mesh.triangles.size() >= 4, "a solid has at least 4 triangles");
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) require(0 <= v && v < vertices, "a triangle names a vertex that does not exist");
  }
  const Grid& grid = data.grid;
  const Vector3d last = grid.node(grid.size.x() - 1, grid.size.y() - 1, grid.size.z() - 1);
  for (const Vector3d& v : mesh.vertices)  // off the grid a field answers band + distance to the grid
    require(v.allFinite() && (v - grid.origin).minCoeff() >= data.band && (last - v).minCoeff() >= data.band,
            "the grid must reach at least the band beyond the solid on every side: more nodes, or less band");
}

void check_cells(const VoxelField::Data& data) {
  require(is_length(data.cell_size) && data.cell_origin.allFinite() && data.cell_count.minCoeff() >= 1 &&
              data.cell_count.maxCoeff() <= most_nodes,
          "the triangle cells need a size of 1 um to 1 km, an origin and 1 to 2^20 cells a side");
  const auto cells =
      std::size_t(data.cell_count.x()) * std::size_t(data.cell_count.y()) * std::size_t(data.cell_count.z());
  require(data.cell_start.size() == cells + 1, "one start a triangle cell and one more");
  require(data.cell_start.front() == 0 && data.cell_start.back() == data.cell_triangles.size() &&
              std::is_sorted(data.cell_start.begin(), data.cell_start.end()),
          "the starts of the triangle cells must ascend from 0 to the number of entries");
  std::vector<bool> found(data.mesh.triangles.size(), false);
  for (const std::uint32_t triangle : data.cell_triangles) {
    require(triangle < found.size(), "a cell names a triangle that does not exist");
    found[triangle] = true;
  }
  require(std::find(found.begin(), found.end(), false) == found.end(), "every triangle must be in a cell");
}

void check(const VoxelField::Data& data) {
  check_grid(data);
  check_mesh(data);
  check_cells(data);
}

Vector3d unit_or_zero(const Vector3d& v) {
  const double length = v.norm();
  return length > 0 ? Vector3d(v / length) : Vector3d::Zero();
}

double angle(const Vector3d& u, const Vector3d& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); }

double squared(double x) { return x * x; }

}  // namespace

VoxelField::VoxelField(Data data) : data_(std::move(data)) {
  check(data_);
  for (const Vector3d& v : data_.mesh.vertices) bounds_.extend(v);
  faces_ = FaceGraph(data_.mesh);
  build_normals();
}

void VoxelField::build_normals() {
  const Mesh& mesh = data_.mesh;
  triangles_.reserve(mesh.triangles.size());
  vertex_normals_.assign(mesh.vertices.size(), Vector3d::Zero());
  for (const auto& corners : mesh.triangles) {
    const Vector3d& a = mesh.vertices[corners[0]];
    const Vector3d& b = mesh.vertices[corners[1]];
    const Vector3d& c = mesh.vertices[corners[2]];
    const Vector3d n = unit_or_zero((b - a).cross(c - a));
    triangles_.push_back({a, b, c, n});
    vertex_normals_[corners[0]] += angle(b - a, c - a) * n;
    vertex_normals_[corners[1]] += angle(c - b, a - b) * n;
    vertex_normals_[corners[2]] += angle(a - c, b - c) * n;
  }
  for (Vector3d& n : vertex_normals_) n = unit_or_zero(n);

  // Number the undirected edges by sorting all sides of all triangles.
  struct Side {
    int low, high, triangle, side;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int s = 0; s < 3; ++s) {
      const auto [low, high] = std::minmax({mesh.triangles[t][s], mesh.triangles[t][(s + 1) % 3]});
      sides.push_back({low, high, t, s});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
  triangle_edges_.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high)
      edge_normals_.push_back(Vector3d::Zero());
    edge_normals_.back() += triangles_[sides[i].triangle].n;
    triangle_edges_[sides[i].triangle][sides[i].side] = static_cast<int>(edge_normals_.size()) - 1;
  }
  for (Vector3d& n : edge_normals_) n = unit_or_zero(n);
}

bool VoxelField::occupied(int i, int j, int k) const {
  const std::size_t bit = data_.grid.index(i, j, k);
  return data_.occupied[bit >> 6] >> (bit & 63) & 1;
}

std::size_t VoxelField::occupied_count() const {
  std::size_t count = 0;
  for (std::uint64_t word : data_.occupied) {
    for (; word; word &= word - 1) ++count;  // clears the lowest bit
  }
  return count;
}

DistanceSample VoxelField::distance(const Vector3d& p_O) const {
  const Grid& grid = data_.grid;
  const double per_metre = 1 / grid.spacing;
  const Vector3d x = (p_O - grid.origin) * per_metre;
  const int nx = grid.size.x(), ny = grid.size.y(), nz = grid.size.z();
  if (!(x.x() >= 0 && x.y() >= 0 && x.z() >= 0 && x.x() <= nx - 1 && x.y() <= ny - 1 && x.z() <= nz - 1)) {
    const Vector3d inside = x.cwiseMax(0.0).cwiseMin((grid.size - Vector3i::Ones()).cast<double>());
    const Vector3d away = (x - inside) * grid.spacing;
    const double length = away.norm();
    return {data_.band + length, away / length};
  }
  const int i = std::min(int(x.x()), nx - 2), j = std::min(int(x.y()), ny - 2), k = std::min(int(x.z()), nz - 2);
  const double u = x.x() - i, v = x.y() - j, w = x.z() - k;
  const float* const low = data_.distance.data() + grid.index(i, j, k);
  const float* const high = low + std::size_t(nx) * std::size_t(ny);
  // Differences along x on the four edges of the cell, then the values there.
  const double g00 = double(low[1]) - low[0], g10 = double(low[nx + 1]) - low[nx];
  const double g01 = double(high[1]) - high[0], g11 = double(high[nx + 1]) - high[nx];
  const double c00 = low[0] + u * g00, c10 = low[nx] + u * g10;
  const double c01 = high[0] + u * g01, c11 = high[nx] + u * g11;
  const double c0 = c00 + v * (c10 - c00), c1 = c01 + v * (c11 - c01);
  const double g0 = g00 + v * (g10 - g00), g1 = g01 + v * (g11 - g01);
  const double dy0 = c10 - c00, dy1 = c11 - c01;
  return {c0 + w * (c1 - c0), per_metre * Vector3d(g0 + w * (g1 - g0), dy0 + w * (dy1 - dy0), c1 - c0)};
}

// --- closest point ---------------------------------------------------------------------------------------------------

struct VoxelField::Search {
  TrianglePoint point{};
  int triangle{-1};
};

// A radius around p that holds surface if it is finite: the nearest node's own distance is exact inside the band, and
// distances change by no more than one walks.
double VoxelField::reach(const Vector3d& p_O) const {
  const Grid& grid = data_.grid;
  const Vector3d x = (p_O - grid.origin) / grid.spacing;
  if (!(x.minCoeff() >= 0 && (x.array() <= (grid.size - Vector3i::Ones()).cast<double>().array()).all()))
    return std::numeric_limits<double>::infinity();
  const Vector3i node = (x + Vector3d::Constant(0.5)).cast<int>();
  const double at_node = std::abs(double(data_.distance[grid.index(node.x(), node.y(), node.z())]));
  if (at_node >= 0.999 * data_.band) return std::numeric_limits<double>::infinity();
  const double rounding = 1e-6 * data_.band;  // of the stored float
  return at_node + (p_O - grid.node(node.x(), node.y(), node.z())).norm() + rounding;
}

VoxelField::Search VoxelField::search(const Vector3d& p_O, double radius) const {
  Search found;
  found.point.squared_distance = squared(radius);
  const Vector3d x = p_O - data_.cell_origin;
  const double size = data_.cell_size;
  Vector3i first, last;
  for (int axis = 0; axis < 3; ++axis) {
    const double end = data_.cell_count[axis];
    first[axis] = static_cast<int>(std::clamp(std::floor((x[axis] - radius) / size), 0.0, end));
    last[axis] = static_cast<int>(std::clamp(std::floor((x[axis] + radius) / size), -1.0, end - 1));
  }
  // Squared distance from p to the slab of cells `index` along `axis`; the margin covers what cells hold beyond their
  // walls.
  const auto gap = [&](int axis, int index) {
    const double below = index * size - x[axis], above = x[axis] - (index + 1) * size;
    return squared(std::max(0.0, std::max(below, above) - 1e-6 * size));
  };
  for (int k = first.z(); k <= last.z(); ++k) {
    const double gap_z = gap(2, k);
    for (int j = first.y(); j <= last.y(); ++j) {
      const double gap_yz = gap_z + gap(1, j);
      if (gap_yz > found.point.squared_distance) continue;
      const std::size_t row = (std::size_t(k) * data_.cell_count.y() + j) * data_.cell_count.x();
      for (int i = first.x(); i <= last.x(); ++i) {
        const std::uint32_t begin = data_.cell_start[row + i], end = data_.cell_start[row + i + 1];
        if (begin == end || gap_yz + gap(0, i) > found.point.squared_distance) continue;
        for (std::uint32_t entry = begin; entry < end; ++entry) {
          const int id = static_cast<int>(data_.cell_triangles[entry]);
          const Triangle& t = triangles_[id];
          if (t.n.isZero(0)) continue;  // without area: its neighbours have the same edges
          const TrianglePoint point = closest_on_triangle(p_O, t.a, t.b, t.c);
          const bool nearer = point.squared_distance < found.point.squared_distance;
          const bool tie = point.squared_distance == found.point.squared_distance && id < found.triangle;
          if (nearer || tie || (found.triangle < 0 && point.squared_distance <= squared(radius))) found = {point, id};
        }
      }
    }
  }
  return found;
}

Vector3d VoxelField::feature_normal(int triangle, int feature) const {
  constexpr int vertex = TrianglePoint::vertex, edge = TrianglePoint::edge;
  if (feature == TrianglePoint::face) return triangles_[triangle].n;
  const Vector3d n = feature >= vertex ? vertex_normals_[data_.mesh.triangles[triangle][feature - vertex]]
                                       : edge_normals_[triangle_edges_[triangle][feature - edge]];
  return n.isZero(0) ? triangles_[triangle].n : n;
}

std::optional<SurfacePoint> VoxelField::closest(const Vector3d& p_O, double max_distance) const {
  if (!p_O.allFinite() || !(max_distance >= 0)) return std::nullopt;
  const double known = reach(p_O);
  const double outside = bounds_.exteriorDistance(p_O);
  const double farthest = std::min(max_distance, outside + bounds_.diagonal().norm());
  double radius = std::min(farthest, std::isfinite(known) ? known : outside + data_.cell_size);
  Search found = search(p_O, radius);
  while (found.triangle < 0 && radius < farthest) {
    const double wider = outside + 2 * (radius - outside);
    radius = wider > radius ? std::min(farthest, wider) : farthest;  // so far away that a cell is lost in rounding
    found = search(p_O, radius);
  }
  if (found.triangle < 0) return std::nullopt;

  const Vector3d away = p_O - found.point.p;
  const double length = std::sqrt(found.point.squared_distance);
  const Vector3d n = feature_normal(found.triangle, found.point.feature);
  const double side = away.dot(n) < 0 ? -1 : 1;  // angle-weighted normals tell exactly (Baerentzen & Aanaes 2005)
  const Vector3d out = length > on_surface * grid().spacing ? Vector3d(side / length * away) : n;
  return SurfacePoint{found.point.p, out, side * length, found.triangle};
}

// --- ray -------------------------------------------------------------------------------------------------------------

std::optional<RayHit> VoxelField::raycast(const Vector3d& origin_O, const Vector3d& direction_O, double t_max) const {
  if (!origin_O.allFinite() || !direction_O.allFinite()) return std::nullopt;
  // Clip to the box of cells; it is a little larger than the mesh.
  constexpr double never = std::numeric_limits<double>::infinity();
  const double size = data_.cell_size;
  const Vector3d x = origin_O - data_.cell_origin;
  double enter = 0, leave = t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction_O[axis], width = data_.cell_count[axis] * size;
    if (d == 0 && !(x[axis] >= 0 && x[axis] <= width)) return std::nullopt;
    if (d == 0) continue;
    const double low = -x[axis] / d, high = (width - x[axis]) / d;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  if (!(enter <= leave)) return std::nullopt;

  Vector3i cell, step;
  Vector3d next, pace;  // t of the next wall along each axis, and from wall to wall
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction_O[axis];
    const double at = std::floor((x[axis] + enter * d) / size);
    cell[axis] = static_cast<int>(std::clamp(at, 0.0, data_.cell_count[axis] - 1.0));
    step[axis] = d > 0 ? 1 : -1;
    next[axis] = d == 0 ? never : ((cell[axis] + (d > 0)) * size - x[axis]) / d;
    pace[axis] = d == 0 ? never : size / std::abs(d);
  }

  const WatertightRay ray(origin_O, direction_O);
  double best = t_max;
  int triangle = -1;
  const double same = same_hit * grid().spacing;
  while (true) {
    const std::size_t at = (std::size_t(cell.z()) * data_.cell_count.y() + cell.y()) * data_.cell_count.x() + cell.x();
    for (std::uint32_t entry = data_.cell_start[at]; entry < data_.cell_start[at + 1]; ++entry) {
      const int id = static_cast<int>(data_.cell_triangles[entry]);
      const double t = ray.crossing(triangles_[id].a, triangles_[id].b, triangles_[id].c);
      if (!(t >= 0 && t <= t_max)) continue;
      const bool nearer = triangle < 0 || t < best - same;
      if (!nearer && !(t <= best + same && id < triangle)) continue;
      best = nearer ? t : std::min(best, t);
      triangle = id;
    }
    int axis = 0;
    const double wall = next.minCoeff(&axis);
    if ((triangle >= 0 && best + same <= wall) || wall > leave) break;
    cell[axis] += step[axis];
    if (cell[axis] < 0 || cell[axis] >= data_.cell_count[axis]) break;
    next[axis] += pace[axis];
  }
  if (triangle < 0) return std::nullopt;
  return RayHit{best, origin_O + best * direction_O, triangles_[triangle].n, triangle};
}

}  // namespace handhold
