// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double sharp_cosine = 0.8660254037844386;                             // of 30 degrees
constexpr std::size_t most_samples = std::numeric_limits<std::uint8_t>::max();  // SampleId has one byte

constexpr double least_of_corners = 0.15;  // a block whose longest side is the spacing keeps its eight
constexpr double least_of_others = 0.75;

using Edge = std::pair<int, int>;

Vector3d normal_of(const Mesh& mesh, const std::array<int, 3>& t) {
  const Vector3d& a = mesh.vertices[std::size_t(t[0])];
  return (mesh.vertices[std::size_t(t[1])] - a).cross(mesh.vertices[std::size_t(t[2])] - a).normalized();
}

/// Edges at which the surface turns by more than 30 degrees, ascending.
std::vector<Edge> sharp_edges(const Mesh& mesh) {
  std::map<Edge, std::vector<Vector3d>> normals;
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      normals[{low, high}].push_back(normal_of(mesh, t));
    }
  }
  std::vector<Edge> sharp;
  for (const auto& [edge, n] : normals) {
    if (n.size() == 2 && n[0].dot(n[1]) < sharp_cosine) sharp.push_back(edge);
  }
  return sharp;
}

/// Takes points in the order in which they are offered, those that are not too near to one taken before.
class Taker {
 public:
  explicit Taker(double spacing) : spacing_(spacing) {}

  /// `least`: distance to those taken, in spacings.
  void offer(const Vector3d& p, double least) {
    const auto near = [&](const Vector3d& q) { return (p - q).norm() < least * spacing_; };
    if (std::any_of(points_.begin(), points_.end(), near)) return;
    points_.push_back(p);
    if (points_.size() <= most_samples) return;
    throw InputError(
        fmt::format("surface samples {} m apart: more than {} are needed (space them wider)", spacing_, most_samples));
  }

  std::vector<Vector3d> take() { return std::move(points_); }

 private:
  double spacing_;
  std::vector<Vector3d> points_;
};

int parts(double length, double spacing) { return std::max(1, int(std::lround(length / spacing))); }

}  // namespace

std::vector<Vector3d> surface_samples(const Mesh& mesh, double spacing) {
  if (!(spacing > 0) || !std::isfinite(spacing))
    throw InputError(fmt::format("spacing of surface samples {} m: must be finite and > 0 (correct it)", spacing));
  Taker taker(spacing);
  const auto vertex = [&](int i) -> const Vector3d& { return mesh.vertices[std::size_t(i)]; };
  const std::vector<Edge> edges = sharp_edges(mesh);
  std::map<int, int> sharp_at;
  for (const auto& [i, j] : edges) ++sharp_at[i], ++sharp_at[j];
  for (const auto& [i, count] : sharp_at)
    if (count >= 3) taker.offer(vertex(i), least_of_corners);
  for (const auto& [i, j] : edges) {
    const int n = parts((vertex(j) - vertex(i)).norm(), spacing);
    for (int k = 0; k <= n; ++k) taker.offer(vertex(i) + double(k) / n * (vertex(j) - vertex(i)), least_of_others);
  }
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3d &a = vertex(t[0]), b = vertex(t[1]) - a, c = vertex(t[2]) - a;
    std::array<double, 3> length{b.norm(), c.norm(), (b - c).norm()};
    std::sort(length.begin(), length.end());
    const int n = parts(length[1], spacing);  // not the diagonal of a face, yet the length of a sliver
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) taker.offer(a + double(i) / n * b + double(j) / n * c, least_of_others);
  }
  return taker.take();
}

}  // namespace handhold
