// SPDX-License-Identifier: Apache-2.0
#include "cases/model/face_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double flattest = 1e-6;  // height of a triangle over its longest side: below, its normal is rounding's

Face face_of(const Mesh& mesh, const std::array<int, 3>& vertex) {
  Face f;
  f.vertex = vertex;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    f.corner[i] = mesh.vertices[std::size_t(vertex[i])];
    longest = std::max(longest, (mesh.vertices[std::size_t(vertex[(i + 1) % 3])] - f.corner[i]).squaredNorm());
  }
  const Vector3d normal = (f.corner[1] - f.corner[0]).cross(f.corner[2] - f.corner[0]);
  if (!(normal.norm() > flattest * longest)) return f;
  f.n = normal.normalized();
  for (std::size_t i = 0; i < 3; ++i) f.out[i] = (f.corner[(i + 1) % 3] - f.corner[i]).cross(f.n).normalized();
  return f;
}

/// How far the outside opens from face f over its side i to face g, which has the same side: π where the surface goes
/// on straight, less in a hollow edge [rad].
double opening(const Face& f, std::size_t i, const Face& g) {
  const Vector3d across = f.n.cross(f.out[i]);  // along the side
  const Vector3d inwards = across.cross(g.n);   // from the side into g, which runs along it the other way
  const double angle = std::atan2(f.n.dot(inwards), -f.out[i].dot(inwards));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

FaceGraph::FaceGraph(const Mesh& mesh) {
  faces_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) faces_.push_back(face_of(mesh, t));
  join();
  find_creases();
  gather_rings(mesh.vertices.size());
}

/// Where more than two faces share an edge, the surface goes on in the face that the outside of this one ends at.
void FaceGraph::join() {
  struct Side {
    int from, to, face;
    std::size_t side;
    [[nodiscard]] std::pair<int, int> ends() const { return {from, to}; }
  };
  std::vector<Side> sides;
  sides.reserve(3 * faces_.size());
  for (int f = 0; f < size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({(*this)[f].vertex[i], (*this)[f].vertex[(i + 1) % 3], f, i});
  std::ranges::stable_sort(sides, {}, &Side::ends);
  for (const Side& side : sides) {
    Face& f = faces_[std::size_t(side.face)];
    double least = 4 * std::numbers::pi;
    for (const Side& other : std::ranges::equal_range(sides, std::pair(side.to, side.from), {}, &Side::ends)) {
      const double angle = f.n.isZero(0) ? 0 : opening(f, side.side, (*this)[other.face]);
      if (angle >= least) continue;
      least = angle;
      f.beyond[side.side] = other.face;
    }
  }
}

void FaceGraph::find_creases() {
  std::vector<Face> joined = faces_;
  for (int f = 0; f < size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      Face& to = joined[std::size_t(f)];
      if (to.n.isZero(0)) continue;
      to.beyond[i] = skip_slivers(f, to.beyond[i], i);
      if (to.beyond[i] < 0) continue;
      const double turn = opening(to, i, (*this)[to.beyond[i]]) - std::numbers::pi;
      if (std::abs(turn) <= crease_angle) continue;
      to.edge[i] = turn > 0 ? EdgeKind::convex : EdgeKind::hollow;
      if (f < to.beyond[i]) ++creases_;
    }
  faces_ = std::move(joined);
}

/// Through triangles without an area, on over that one of their other sides which is nearest to the middle of the side.
int FaceGraph::skip_slivers(int from, int face, std::size_t side) const {
  constexpr int most = 16;
  const Face& f = (*this)[from];
  const Vector3d middle = 0.5 * (f.corner[side] + f.corner[(side + 1) % 3]);
  int last = from;
  for (int i = 0; i < most && face >= 0 && (*this)[face].n.isZero(0); ++i) {
    const Face& sliver = (*this)[face];
    double nearest = std::numeric_limits<double>::infinity();
    int next = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      if (sliver.beyond[k] == last) continue;
      const Vector3d &a = sliver.corner[k], along = sliver.corner[(k + 1) % 3] - a;
      const double at = along.isZero(0) ? 0 : std::clamp((middle - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double distance = (a + at * along - middle).norm();
      if (distance < nearest) nearest = distance, next = sliver.beyond[k];
    }
    last = face;
    face = next;
  }
  return face >= 0 && (*this)[face].n.isZero(0) ? -1 : face;
}

void FaceGraph::gather_rings(std::size_t vertices) {
  start_.assign(vertices + 1, 0);
  const auto visit = [&](const auto& take) {
    for (int f = 0; f < size(); ++f)
      if (!(*this)[f].n.isZero(0))
        for (const int v : (*this)[f].vertex) take(f, std::size_t(v));
  };
  visit([&](int, std::size_t v) { ++start_[v + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) start_[v + 1] += start_[v];
  ring_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  visit([&](int f, std::size_t v) { ring_[next[v]++] = f; });
}

}  // namespace handhold
