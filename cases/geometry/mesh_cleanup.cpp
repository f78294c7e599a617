// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/mesh_cleanup.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace handhold {
namespace {

using Eigen::Vector3d;

template <class Predicate>
std::size_t drop_if(Mesh& mesh, const Predicate& unwanted) {
  auto& triangles = mesh.triangles;
  const std::size_t before = triangles.size();
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), unwanted), triangles.end());
  return before - triangles.size();
}

// For each point the first of those it is joined to (itself if none).
std::vector<int> leaders(const std::vector<Vector3d>& points, double tolerance) {
  // Sorted along a direction that no mesh is aligned with, near points are near in the order, and few others are.
  const Vector3d direction = Vector3d(0.57721566, 0.61803399, 0.53356813).normalized();
  std::vector<double> place;
  for (const Vector3d& p : points) place.push_back(p.dot(direction));
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return place[a] != place[b] ? place[a] < place[b] : a < b; });
  std::vector<int> leader(points.size());
  std::iota(leader.begin(), leader.end(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && place[order[i]] - place[order[j]] <= tolerance;) {
      if ((points[order[i]] - points[order[j]]).squaredNorm() > tolerance * tolerance) continue;
      leader[order[i]] = leader[order[j]];
      break;
    }
  }
  return leader;
}

std::vector<int> border_points(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> faces;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++faces[std::minmax(t[i], t[(i + 1) % 3])];
  std::set<int> points;
  for (const auto& [edge, count] : faces)
    if (count == 1) points.insert({edge.first, edge.second});
  return {points.begin(), points.end()};
}

}  // namespace

std::size_t weld(Mesh& mesh, double tolerance) {
  const std::vector<int> leader = leaders(mesh.vertices, tolerance);
  std::size_t joined = 0;
  for (std::size_t v = 0; v < leader.size(); ++v) joined += leader[v] != static_cast<int>(v);
  std::vector<int> number(mesh.vertices.size(), -1);
  std::vector<Vector3d> kept;
  for (auto& triangle : mesh.triangles) {
    for (int& v : triangle) {
      int& fresh = number[leader[v]];
      if (fresh < 0) {
        fresh = static_cast<int>(kept.size());
        kept.push_back(mesh.vertices[leader[v]]);
      }
      v = fresh;
    }
  }
  mesh.vertices = std::move(kept);
  return joined;
}

std::size_t weld_borders(Mesh& mesh, double tolerance) {
  const std::vector<int> border = border_points(mesh);
  std::vector<Vector3d> points;
  for (const int v : border) points.push_back(mesh.vertices[v]);
  const std::vector<int> leader = leaders(points, tolerance);
  for (std::size_t i = 0; i < border.size(); ++i) mesh.vertices[border[i]] = points[leader[i]];
  return weld(mesh, 0);
}

std::size_t drop_degenerate(Mesh& mesh) {
  return drop_if(mesh, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

std::size_t drop_duplicates(Mesh& mesh) {
  std::set<std::array<int, 3>> seen;
  return drop_if(mesh, [&seen](std::array<int, 3> t) {
    std::sort(t.begin(), t.end());
    return !seen.insert(t).second;
  });
}

std::size_t cancel_opposite(Mesh& mesh) {
  const auto sorted = [](std::array<int, 3> t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  const auto sense = [](const std::array<int, 3>& t) {
    return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2 ? 1 : -1;
  };
  std::map<std::array<int, 3>, int> balance;
  for (const auto& t : mesh.triangles) balance[sorted(t)] += sense(t);
  const std::size_t dropped = drop_if(mesh, [&](const std::array<int, 3>& t) {
    int& left = balance[sorted(t)];
    const bool kept = left * sense(t) > 0;  // the first that faces as most of them do
    if (kept) left = 0;
    return !kept;
  });
  weld(mesh, 0);
  return dropped;
}

HoleFilling fill_triangular_holes(Mesh& mesh) {
  using Edge = std::pair<int, int>;
  std::set<Edge> edges;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
  }
  std::multimap<int, int> missing;  // directed edges that a patch would have
  for (const auto& [from, to] : edges) {
    if (!edges.count({to, from})) missing.emplace(to, from);
  }
  HoleFilling result;
  for (const auto& [a, b] : missing) {
    const auto [begin, end] = missing.equal_range(b);
    for (auto next = begin; next != end; ++next) {
      const int c = next->second;
      const auto absent = [&edges](int from, int to) { return edges.count({to, from}) && !edges.count({from, to}); };
      if (c == a || !absent(a, b) || !absent(b, c) || !absent(c, a)) continue;
      mesh.triangles.push_back({a, b, c});
      edges.insert({{a, b}, {b, c}, {c, a}});
      const Vector3d u = mesh.vertices[b] - mesh.vertices[a], v = mesh.vertices[c] - mesh.vertices[a];
      const double diameter = std::max({u.norm(), v.norm(), (u - v).norm()});
      result.uncertain_volume += u.cross(v).norm() / 2 * diameter / 8;
      ++result.filled;
    }
  }
  return result;
}

}  // namespace handhold
