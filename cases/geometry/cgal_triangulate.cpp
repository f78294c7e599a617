// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/cgal_triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Geometry>

namespace handhold {
namespace {

using Eigen::Vector3d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
struct Winding {
  bool known{};
  int turns{};
};
using InfoFace = CGAL::Triangulation_face_base_with_info_2<Winding, Kernel, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, InfoFace>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

Vector3d newell_normal(const std::vector<Vector3d>& p) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) sum += (p[i] - p[0]).cross(p[(i + 1) % p.size()] - p[0]);
  return sum / 2;
}

// Between the two ways to cut a skew quadrilateral lies a tetrahedron: its area times a third of how far its corners
// spread along its normal. Other polygons: a bound of the same form. Text has often six digits, so that corners of a
// plane miss it by a millionth.
double ambiguity(const std::vector<Vector3d>& p, const Vector3d& area) {
  const double size = area.norm();
  if (p.size() == 3 || !(size > 0)) return 0;
  double low = 0, high = 0;
  for (const Vector3d& corner : p) {
    const double height = (corner - p[0]).dot(area) / size;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return high - low > 1e-6 * std::sqrt(size) ? size * (high - low) / 3 : 0;
}

std::vector<std::array<int, 3>> fan(int corners) {
  std::vector<std::array<int, 3>> triangles;
  for (int c = 2; c < corners; ++c) triangles.push_back({0, c - 1, c});
  return triangles;
}

// The plane without the normal's largest component: coordinates stay as they are, so that what is exactly collinear
// remains so.
class FlatPolygon {
 public:
  FlatPolygon(const std::vector<Vector3d>& corners, const Vector3d& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
    std::vector<Triangulation::Vertex_handle> handles;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto before = plane_.number_of_vertices();
      handles.push_back(
          plane_.insert({corners[i][u], corners[i][v]}, handles.empty() ? nullptr : handles.back()->face()));
      if (plane_.number_of_vertices() > before) handles.back()->info() = static_cast<int>(i);
      if (corners[i] != corners[static_cast<std::size_t>(handles.back()->info())]) sound_ = false;
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const auto a = handles[i], b = handles[(i + 1) % handles.size()];
      if (a == b) continue;
      plane_.insert_constraint(a, b);
      crossings_[{std::min(&*a, &*b), std::max(&*a, &*b)}] += &*a < &*b ? 1 : -1;
    }
  }

  // Nothing if the polygon crosses or overlaps itself.
  std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> result;
    count_turns();
    for (const auto f : plane_.finite_face_handles()) {
      if (f->info().turns < 0 || f->info().turns > 1) sound_ = false;
      if (f->info().turns == 1) result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
    return sound_ ? result : std::vector<std::array<int, 3>>();
  }

 private:
  // From outside inward: who steps over a side from its right to its left is inside once more.
  void count_turns() {
    std::vector<Triangulation::Face_handle> waiting = {plane_.infinite_face()};
    waiting[0]->info() = {true, 0};
    while (!waiting.empty()) {
      const auto f = waiting.back();
      waiting.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto next = f->neighbor(i);
        if (next->info().known) continue;
        next->info() = {true, f->info().turns + step(f, i)};
        waiting.push_back(next);
      }
    }
  }

  int step(Triangulation::Face_handle f, int i) {
    if (!plane_.is_constrained({f, i})) return 0;
    const auto *a = &*f->vertex(Triangulation::ccw(i)), *b = &*f->vertex(Triangulation::cw(i));  // f on the left
    const auto found = crossings_.find({std::min(a, b), std::max(a, b)});
    if (found == crossings_.end()) sound_ = false;  // a corner lies on this side
    if (found == crossings_.end()) return 0;
    return a < b ? -found->second : found->second;
  }

  Triangulation plane_;
  std::map<std::pair<const Triangulation::Vertex*, const Triangulation::Vertex*>, int> crossings_;
  bool sound_ = true;
};

}  // namespace

CutPolygon cut_polygon(const std::vector<Vector3d>& corners) {
  CutPolygon result;
  const Vector3d area = newell_normal(corners);
  result.ambiguity = ambiguity(corners, area);
  if (corners.size() > 3 && area.squaredNorm() > 0) {
    try {
      result.triangles = FlatPolygon(corners, area).triangles();
    } catch (const std::exception&) {  // sides that cross
      result.triangles.clear();
    }
    result.sound = !result.triangles.empty();
  }
  if (result.triangles.empty()) result.triangles = fan(static_cast<int>(corners.size()));
  return result;
}

}  // namespace handhold
