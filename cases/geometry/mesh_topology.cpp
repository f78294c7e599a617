// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/mesh_topology.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

struct HalfEdge {
  int low, high;
  bool forth;  // runs from low to high
};

bool same_edge(const HalfEdge& a, const HalfEdge& b) { return a.low == b.low && a.high == b.high; }

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (int side = 0; side < 3; ++side) {
      const int from = triangle[side];
      const int to = triangle[(side + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  return edges;
}

void check_indices(const Mesh& mesh) {
  const int count = static_cast<int>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int index : mesh.triangles[t]) {
      if (0 <= index && index < count) continue;
      throw InputError(fmt::format("mesh triangle {}: vertex {} does not exist, there are {} (indices start at 0)", t,
                                   index, count));
    }
  }
}

// Union-find over vertices.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(int a, int b) { parent_[root(a)] = root(b); }

 private:
  std::vector<int> parent_;
};

std::size_t count_components(const Mesh& mesh) {
  Pieces pieces(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  std::vector<int> roots;
  roots.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) roots.push_back(pieces.root(triangle[0]));
  std::sort(roots.begin(), roots.end());
  return static_cast<std::size_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

}  // namespace

MeshTopology mesh_topology(const Mesh& mesh) {
  check_indices(mesh);
  MeshTopology result;
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if_not(begin, edges.end(), [&](const HalfEdge& e) { return same_edge(e, *begin); });
    const auto uses = end - begin;
    const auto forth = std::count_if(begin, end, [](const HalfEdge& e) { return e.forth; });
    result.open_edges += uses == 1;
    result.non_manifold_edges += uses > 2;
    result.clashing_edges += uses == 2 && forth != 1;
    result.unbalanced_edges += 2 * forth != uses;
    begin = end;
  }
  result.components = count_components(mesh);
  return result;
}

}  // namespace handhold
