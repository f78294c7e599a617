// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/cgal_repair.hpp"

#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

constexpr std::size_t longest_border = 400;  // filling costs its cube
constexpr std::size_t most_pieces = 64;      // each is united with all before it

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

// CGAL prints before it throws; this silences it for as long as one call lasts.
class Quiet {
 public:
  Quiet() : handler_(CGAL::set_error_handler(&ignore)), warning_(CGAL::set_warning_handler(&ignore)) {}
  ~Quiet() {
    CGAL::set_error_handler(handler_);
    CGAL::set_warning_handler(warning_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}
  CGAL::Failure_function handler_, warning_;
};

template <class Work>
auto guarded(const char* what, const Work& work) {
  const Quiet quiet;
  try {
    return work();
  } catch (const std::exception& error) {
    std::string reason = error.what();
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    throw InputError(std::string("mesh: ") + what + " failed: " + reason + " (repair it in a mesh editor)");
  }
}

Soup to_soup(const Mesh& mesh) {
  Soup soup;
  for (const Eigen::Vector3d& v : mesh.vertices) soup.points.emplace_back(v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles) soup.faces.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
  return soup;
}

Surface to_surface(const Mesh& mesh) {
  const Soup soup = to_soup(mesh);
  Surface surface;
  if (!pmp::is_polygon_soup_a_polygon_mesh(soup.faces)) throw InputError("faces do not fit together");
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.faces, surface);
  return surface;
}

Mesh from_surface(const Surface& surface) {
  Mesh mesh;
  for (const auto v : surface.vertices()) {
    const Point& p = surface.point(v);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : surface.faces()) {
    std::array<int, 3> triangle{};
    int corner = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      triangle[corner++] = static_cast<int>(v.idx());
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

struct Border {
  std::size_t edges{};
  double diameter{};
};

Border measure_border(const Surface& surface, Surface::Halfedge_index start) {
  Border border;
  CGAL::Bbox_3 box;
  for (const auto h : surface.halfedges_around_face(start)) {
    box += surface.point(surface.target(h)).bbox();
    ++border.edges;
  }
  border.diameter = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  return border;
}

}  // namespace

bool is_manifold(const Mesh& mesh) {
  return guarded("checking the faces", [&mesh] { return pmp::is_polygon_soup_a_polygon_mesh(to_soup(mesh).faces); });
}

void orient_soup(Mesh& mesh) {
  guarded("orienting the faces", [&mesh] {
    Soup soup = to_soup(mesh);
    pmp::orient_polygon_soup(soup.points, soup.faces);  // false only says that it had to split points
    mesh.vertices.clear();
    for (const Point& p : soup.points) mesh.vertices.emplace_back(p.x(), p.y(), p.z());
    for (std::size_t f = 0; f < soup.faces.size(); ++f) {
      for (int c = 0; c < 3; ++c) mesh.triangles[f][c] = static_cast<int>(soup.faces[f][c]);
    }
  });
}

void orient_outward(Mesh& mesh) {
  guarded("turning the faces outward", [&mesh] {
    Surface surface = to_surface(mesh);
    pmp::orient_to_bound_a_volume(surface);
    mesh = from_surface(surface);
  });
}

HoleFilling fill_holes(Mesh& mesh) {
  return guarded("filling the holes", [&mesh] {
    Surface surface = to_surface(mesh);
    std::vector<Surface::Halfedge_index> borders;
    pmp::extract_boundary_cycles(surface, std::back_inserter(borders));
    HoleFilling result;
    for (const auto h : borders) {
      const Border border = measure_border(surface, h);
      std::vector<Surface::Face_index> patch;
      if (border.edges <= longest_border) pmp::triangulate_hole(surface, h, std::back_inserter(patch));
      if (patch.empty()) {
        ++result.left;
        continue;
      }
      ++result.filled;
      result.uncertain_volume += CGAL::to_double(pmp::area(patch, surface)) * border.diameter / 8;
    }
    mesh = from_surface(surface);
    return result;
  });
}

std::size_t count_self_intersections(const Mesh& mesh) {
  return guarded("looking for self-intersections", [&mesh] {
    const Surface surface = to_surface(mesh);
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
    pmp::self_intersections(surface, std::back_inserter(pairs));
    return pairs.size();
  });
}

bool unite_pieces(Mesh& mesh) {
  const Quiet quiet;
  try {
    Surface surface = to_surface(mesh);
    std::vector<Surface> pieces;
    pmp::split_connected_components(surface, pieces);
    if (pieces.size() < 2 || pieces.size() > most_pieces) return false;
    for (const Surface& piece : pieces)
      if (!pmp::is_outward_oriented(piece) || pmp::does_self_intersect(piece)) return false;
    Surface all = std::move(pieces.front());
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      Surface both;
      if (!pmp::corefine_and_compute_union(all, pieces[i], both)) return false;
      all = std::move(both);
    }
    all.collect_garbage();
    mesh = from_surface(all);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace handhold
