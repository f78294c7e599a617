// SPDX-License-Identifier: GPL-3.0-or-later
// Every node of the band is measured against the few features it may be nearest to (Mauch 2000, "characteristics"):
// faces reach straight out over themselves, edges over the wedge between their faces' normals, corners over the cone
// between their edges. These regions cover space without much overlap, so that the cost does not grow with triangles
// times band, and are cut by rows along x into intervals. A measured distance is always one to the surface, so overlaps
// do no harm.
#include "cases/geometry/band_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace handhold {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A triangle narrower than this part of its length has a normal too inexact to bound its neighbours' regions.
constexpr double sliver = 1e-5;
// Narrower than this it is covered by its edges alone.
constexpr double needle = 1e-9;

// Points d from `origin` with normal·d >= −slack for all `sides`; their distance to the feature is |form d|.
struct Region {
  Vector3d origin = Vector3d::Zero();
  Matrix3d form = Matrix3d::Zero();
  AlignedBox3d box{};
  struct Side {
    Vector3d normal;
    double offset;  // normal·d + offset >= 0
  };
  std::vector<Side> sides{};
};

class Painter {
 public:
  Painter(const Grid& grid, double band)
      : grid_(grid), band_(band), squared_(grid.count(), static_cast<float>(band * band)) {}

  void paint(const Region& region) {
    Eigen::Vector3i first, last;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = (region.box.min()[axis] - grid_.origin[axis]) / grid_.spacing;
      const double high = (region.box.max()[axis] - grid_.origin[axis]) / grid_.spacing;
      first[axis] = std::max(0, static_cast<int>(std::ceil(low - 1e-6)));
      last[axis] = std::min(grid_.size[axis] - 1, static_cast<int>(std::floor(high + 1e-6)));
    }
    for (int k = first.z(); k <= last.z(); ++k) {
      for (int j = first.y(); j <= last.y(); ++j) paint_row(region, first.x(), last.x(), j, k);
    }
  }

  std::vector<float> finish(const std::vector<std::uint64_t>& occupied) && {
    const float limit = static_cast<float>(band_);
    for (std::size_t node = 0; node < squared_.size(); ++node) {
      const float distance = std::min(std::sqrt(squared_[node]), limit);
      squared_[node] = occupied[node >> 6] >> (node & 63) & 1 ? -distance : distance;
    }
    return std::move(squared_);
  }

 private:
  void paint_row(const Region& region, int first, int last, int j, int k) {
    const double h = grid_.spacing;
    const Vector3d d = grid_.node(first, j, k) - region.origin;
    double low = -0.01, high = last - first + 0.01;
    for (const Region::Side& side : region.sides) {
      const double value = side.normal.dot(d) + side.offset, slope = h * side.normal.x();
      if (slope > 0) {
        low = std::max(low, -value / slope);
      } else if (slope < 0) {
        high = std::min(high, -value / slope);
      } else if (value < 0) {
        return;
      }
      if (low > high) return;
    }
    // |f + i g|² <= band²
    const Vector3d f = region.form * d, g = h * region.form.col(0);
    const double a = g.squaredNorm(), b = f.dot(g), c = f.squaredNorm() - band_ * band_;
    const double root = b * b - a * c;
    if (root < 0 || (a == 0 && c > 0)) return;
    if (a > 0) {
      low = std::max(low, (-b - std::sqrt(root)) / a);
      high = std::min(high, (-b + std::sqrt(root)) / a);
    }
    if (low > high) return;
    const int begin = std::max(0, static_cast<int>(std::ceil(low)));
    const int end = std::min(last - first, static_cast<int>(std::floor(high)));
    float* const row = squared_.data() + grid_.index(first, j, k);
    for (int i = begin; i <= end; ++i) {
      const double x = f.x() + i * g.x(), y = f.y() + i * g.y(), z = f.z() + i * g.z();
      row[i] = std::min(row[i], static_cast<float>(x * x + y * y + z * z));
    }
  }

  const Grid& grid_;
  double band_;
  std::vector<float> squared_;
};

// One side of one triangle.
struct HalfEdge {
  int low, high;    // vertices, ascending
  Vector3d inward;  // in the triangle's plane, from the side into it; zero for a sliver
  Vector3d normal;  // of the triangle; zero for a sliver
};

class Features {
 public:
  Features(const Mesh& mesh, const Grid& grid, double band)
      : mesh_(mesh), band_(band), slack_(1e-8 * grid.spacing), painter_(grid, band) {}

  std::vector<float> run(const std::vector<std::uint64_t>& occupied) && {
    for (const auto& triangle : mesh_.triangles) add_face(triangle);
    add_edges();
    add_corners();
    return std::move(painter_).finish(occupied);
  }

 private:
  void add_face(const std::array<int, 3>& triangle) {
    std::array<Vector3d, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = mesh_.vertices[triangle[i]];
    std::array<double, 3> length{};
    for (int i = 0; i < 3; ++i) length[i] = (p[(i + 1) % 3] - p[i]).norm();
    const int longest = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
    // Of the two short sides: the least cancellation.
    const int a = (longest + 1) % 3, b = (longest + 2) % 3;
    const Vector3d cross = (p[b] - p[a]).cross(p[longest] - p[b]);
    const double width = cross.norm() / length[longest];
    const bool flat = width > needle * length[longest], bounds = width > sliver * length[longest];
    const Vector3d normal = flat ? Vector3d(cross.normalized()) : Vector3d::Zero();

    Region region;
    region.origin = p[0];
    region.form.row(0) = normal.transpose();
    for (int i = 0; i < 3; ++i) {
      region.box.extend(p[i] + band_ * normal);
      region.box.extend(p[i] - band_ * normal);
      const Vector3d inward = normal.cross(p[(i + 1) % 3] - p[i]).normalized();
      region.sides.push_back({inward, slack_ - inward.dot(p[i] - p[0])});
      const auto [low, high] = std::minmax({triangle[i], triangle[(i + 1) % 3]});
      if (length[i] > 0)
        half_edges_.push_back({low, high, bounds ? inward : Vector3d::Zero(), bounds ? normal : Vector3d::Zero()});
    }
    if (flat) painter_.paint(region);
  }

  void add_edges() {
    std::sort(half_edges_.begin(), half_edges_.end(),
              [](const HalfEdge& x, const HalfEdge& y) { return std::pair(x.low, x.high) < std::pair(y.low, y.high); });
    for (std::size_t begin = 0, end = 0; begin < half_edges_.size(); begin = end) {
      while (end < half_edges_.size() && half_edges_[end].low == half_edges_[begin].low &&
             half_edges_[end].high == half_edges_[begin].high)
        ++end;
      add_edge(begin, end);
    }
  }

  void add_edge(std::size_t begin, std::size_t end) {
    const Vector3d& start = mesh_.vertices[half_edges_[begin].low];
    const Vector3d& stop = mesh_.vertices[half_edges_[begin].high];
    const double length = (stop - start).norm();
    const Vector3d along = (stop - start) / length;
    edges_.emplace_back(half_edges_[begin].low, along);
    edges_.emplace_back(half_edges_[begin].high, -along);

    Region region;
    region.origin = start;
    region.form = Matrix3d::Identity() - along * along.transpose();
    region.sides = {{along, slack_}, {-along, length + slack_}};
    for (std::size_t e = begin; e < end; ++e) {
      if (!half_edges_[e].inward.isZero(0)) region.sides.push_back({-half_edges_[e].inward, slack_});
    }
    const Vector3d reach = band_ * (Vector3d::Ones() - along.cwiseAbs2()).cwiseMax(0).cwiseSqrt();  // of a cylinder
    region.box.extend(start).extend(stop);
    region.box = {region.box.min() - reach, region.box.max() + reach};
    if (end - begin == 2) region.box = region.box.intersection(wedge_box(half_edges_[begin], half_edges_[begin + 1]));
    painter_.paint(region);
  }

  // Box around the wedge between the normals of an edge's two faces, on its convex side.
  AlignedBox3d wedge_box(const HalfEdge& a, const HalfEdge& b) const {
    const Vector3d everything = Vector3d::Constant(1e9);
    const double turn = a.normal.dot(b.inward), back = b.normal.dot(a.inward);
    const bool flat = std::abs(turn) < 1e-6 || std::abs(back) < 1e-6;  // slivers' zeros count as flat: no bound
    if (flat && (a.normal.isZero(0) || b.normal.isZero(0))) return {-everything, everything};
    const Vector3d first = turn > 0 ? Vector3d(-a.normal) : a.normal,
                   second = back > 0 ? Vector3d(-b.normal) : b.normal;
    const double cosine = first.dot(second);
    if (flat || cosine < -0.5) {
      if (a.normal.dot(b.normal) < 0.9) return {-everything, everything};  // a fold, or nearly one
    }
    AlignedBox3d box;
    for (const int v : {a.low, a.high}) {
      const Vector3d& p = mesh_.vertices[v];
      box.extend(p).extend(p + band_ * first).extend(p + band_ * second);
      if (flat) box.extend(p - band_ * first).extend(p - band_ * second);
      if (!flat) box.extend(p + band_ / (1 + cosine) * (first + second));  // where the arc's end tangents meet
    }
    const Vector3d spare = Vector3d::Constant(1e-5 * band_ + slack_);
    return {box.min() - spare, box.max() + spare};
  }

  void add_corners() {
    std::sort(edges_.begin(), edges_.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      Region region;
      region.origin = mesh_.vertices[edges_[begin].first];
      region.form = Matrix3d::Identity();
      region.box = {region.origin - Vector3d::Constant(band_), region.origin + Vector3d::Constant(band_)};
      for (; end < edges_.size() && edges_[end].first == edges_[begin].first; ++end)
        region.sides.push_back({-edges_[end].second, slack_});
      painter_.paint(region);
    }
  }

  const Mesh& mesh_;
  double band_, slack_;
  Painter painter_;
  std::vector<HalfEdge> half_edges_;
  std::vector<std::pair<int, Vector3d>> edges_;  // (corner, direction away from it), two an edge
};

}  // namespace

std::vector<float> band_distance(const Mesh& mesh, const Grid& grid, double band,
                                 const std::vector<std::uint64_t>& occupied) {
  return Features(mesh, grid, band).run(occupied);
}

}  // namespace handhold
