// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/triangle_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace handhold {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

using Corners = std::array<Vector3d, 3>;

double median_side(const Mesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d& p = mesh.vertices[a];
    const Vector3d& q = mesh.vertices[b];
    const Vector3d& r = mesh.vertices[c];
    lengths.push_back(((q - p).norm() + (r - q).norm() + (p - r).norm()) / 3);
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// Whether all corners' projections on `axis` lie beyond a cube of half edge `half` around the origin.
bool separates(const Vector3d& axis, const Corners& p, double half) {
  const double a = axis.dot(p[0]), b = axis.dot(p[1]), c = axis.dot(p[2]);
  const double reach = half * axis.cwiseAbs().sum();
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

// Triangle against cube by separating axes (Akenine-Möller 2001); the cube's own axes are covered by the caller's
// ranges.
bool touches(const Vector3d& center, double half, const Corners& corners) {
  const Corners p = {corners[0] - center, corners[1] - center, corners[2] - center};
  const Corners sides = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  if (separates(sides[0].cross(sides[1]), p, half)) return false;
  for (const Vector3d& side : sides) {
    for (int axis = 0; axis < 3; ++axis) {
      if (separates(Vector3d::Unit(axis).cross(side), p, half)) return false;
    }
  }
  return true;
}

template <class Visit>
void for_each_cell(const VoxelField::Data& data, const Corners& corners, const Visit& visit) {
  constexpr double spare = 1e-6;
  const double size = data.cell_size;
  Vector3i first, last;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    first[axis] = std::max(0, int(std::floor((low - data.cell_origin[axis]) / size - spare)));
    last[axis] = std::min(data.cell_count[axis] - 1, int(std::floor((high - data.cell_origin[axis]) / size + spare)));
  }
  for (int k = first.z(); k <= last.z(); ++k) {
    for (int j = first.y(); j <= last.y(); ++j) {
      for (int i = first.x(); i <= last.x(); ++i) {
        const Vector3d center = data.cell_origin + size * Vector3d(i + 0.5, j + 0.5, k + 0.5);
        if (!touches(center, (0.5 + spare) * size, corners)) continue;
        visit((std::size_t(k) * data.cell_count.y() + j) * data.cell_count.x() + i);
      }
    }
  }
}

}  // namespace

void build_triangle_cells(VoxelField::Data& data) {
  const Mesh& mesh = data.mesh;
  Eigen::AlignedBox3d bounds;
  for (const Vector3d& v : mesh.vertices) bounds.extend(v);
  const double wanted = mesh.triangles.size() > 50'000 ? 0.001 : std::clamp(0.75 * median_side(mesh), 0.0015, 0.004);
  data.cell_size = std::max(wanted, bounds.sizes().maxCoeff() / 200);
  data.cell_origin = bounds.min() - Vector3d::Constant(0.51 * data.cell_size);
  data.cell_count = (bounds.sizes() / data.cell_size).array().ceil().cast<int>() + 2;

  const auto corners = [&mesh](const std::array<int, 3>& t) {
    return Corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
  };
  // Counting sort: count a cell's triangles, sum up to starts, then put every triangle into its cells in ascending
  // order.
  const std::size_t cells = std::size_t(data.cell_count.x()) * data.cell_count.y() * data.cell_count.z();
  data.cell_start.assign(cells + 1, 0);
  for (const auto& t : mesh.triangles)
    for_each_cell(data, corners(t), [&](std::size_t c) { ++data.cell_start[c + 1]; });
  for (std::size_t c = 0; c < cells; ++c) data.cell_start[c + 1] += data.cell_start[c];
  data.cell_triangles.resize(data.cell_start.back());
  std::vector<std::uint32_t> next(data.cell_start.begin(), data.cell_start.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for_each_cell(data, corners(mesh.triangles[t]),
                  [&](std::size_t c) { data.cell_triangles[next[c]++] = static_cast<std::uint32_t>(t); });
  }
}

}  // namespace handhold
