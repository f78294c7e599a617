// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/mesh_repair.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/geometry/cgal_repair.hpp"
#include "cases/geometry/mesh_cleanup.hpp"
#include "cases/geometry/mesh_topology.hpp"
#include "cases/geometry/scanline.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double accepted_uncertainty = 0.02;  // of the volume, from filled holes
// Of the extent: border points so near are joined if that closes everything, first those of rounded coordinates, then
// those of a hairline crack, a twentieth of a millimetre in an object of ten centimetres.
constexpr std::array<double, 2> near_points{1e-6, 5e-4};

Eigen::AlignedBox3d bounds(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : mesh.vertices) box.extend(v);
  return box;
}

// Volume by counting voxels, 128 along the longest side: finds overlaps and shells inside out that the surface integral
// cannot see. Turned askew, because faces along the grid's planes would make the count worse by an order.
double counted_volume(Mesh mesh) {
  const Eigen::Matrix3d R = (Eigen::AngleAxisd(0.7, Vector3d::UnitX()) * Eigen::AngleAxisd(0.4, Vector3d::UnitY()) *
                             Eigen::AngleAxisd(1.1, Vector3d::UnitZ()))
                                .toRotationMatrix();
  const Vector3d middle = bounds(mesh).center();
  for (Vector3d& v : mesh.vertices) v = R * (v - middle);
  const Eigen::AlignedBox3d box = bounds(mesh);
  Grid grid;
  grid.spacing = box.sizes().maxCoeff() / 128;
  grid.size = (box.sizes() / grid.spacing).array().ceil().cast<int>() + 2;
  grid.origin = box.min() - Vector3d::Constant(0.5 * grid.spacing);
  std::size_t count = 0;
  for (const std::uint64_t word : rasterise(mesh, grid)) count += std::bitset<64>(word).count();
  return static_cast<double>(count) * std::pow(grid.spacing, 3);
}

void turn_around(Mesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

using Corners = std::array<Vector3d, 3>;

std::vector<Corners> corners(const Mesh& mesh) {
  std::vector<Corners> result;
  for (const auto& [a, b, c] : mesh.triangles) result.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return result;
}

// Faces that run the other way than they did; later ones are new.
std::size_t count_flipped(const std::vector<Corners>& before, const Mesh& mesh) {
  const std::vector<Corners> after = corners(mesh);
  std::size_t flipped = 0;
  for (std::size_t f = 0; f < before.size() && f < after.size(); ++f) {
    const auto& [a, b, c] = before[f];
    const auto same = [&](int i) { return after[f][i] == a && after[f][(i + 1) % 3] == b; };
    flipped += !same(0) && !same(1) && !same(2);
  }
  return flipped;
}

std::size_t unmatched_edges(const Mesh& mesh) {
  const MeshTopology topology = mesh_topology(mesh);
  return topology.open_edges + topology.non_manifold_edges;
}

// Of two equal faces one stays, or none if they face each other's way: whichever is closed. A solid whose every face is
// given twice needs the one, a solid with a fin or an inner wall the other.
std::size_t drop_doubled(Mesh& mesh) {
  Mesh cancelled = mesh;
  const std::size_t dropped = drop_duplicates(mesh), more = cancel_opposite(cancelled);
  if (more == dropped || cancelled.triangles.size() < 4 || unmatched_edges(cancelled) >= unmatched_edges(mesh))
    return dropped;
  mesh = std::move(cancelled);
  return more;
}

// Whether that closed the mesh.
bool join_borders(Mesh& mesh, double tolerance, RepairReport& report) {
  if (mesh.triangles.size() < 4 || mesh_topology(mesh).open_edges == 0) return false;
  Mesh joined = mesh;
  const std::size_t more = weld_borders(joined, tolerance);
  const std::size_t degenerate = drop_degenerate(joined), duplicate = drop_doubled(joined);
  if (more == 0 || joined.triangles.size() < 4 || mesh_topology(joined).open_edges > 0) return false;
  mesh = std::move(joined);
  report.points_welded += more;
  report.degenerate_faces += degenerate;
  report.duplicate_faces += duplicate;
  return true;
}

/// Returns how far apart the points were that had to be joined, at most [m]; 0 where they were equal but for rounding.
double clean(Mesh& mesh, RepairReport& report) {
  report.points_welded = weld(mesh, 0);
  report.degenerate_faces = drop_degenerate(mesh);
  report.duplicate_faces = drop_doubled(mesh);
  double crack = 0;
  for (const double near : near_points) {
    const double tolerance = near * bounds(mesh).sizes().maxCoeff();
    if (join_borders(mesh, tolerance, report) && near > near_points[0]) crack = tolerance;
  }
  if (mesh.triangles.size() < 4) {
    throw InputError(
        fmt::format("mesh: only {} faces are neither degenerate nor doubled, a solid has at least 4 (give a "
                    "closed surface)",
                    mesh.triangles.size()));
  }
  return crack;
}

void close(Mesh& mesh, const HoleFilling& triangular, RepairReport& report) {
  const HoleFilling filling = fill_holes(mesh);
  report.holes_filled = triangular.filled + filling.filled;
  const MeshTopology topology = mesh_topology(mesh);
  if (filling.left > 0 || topology.open_edges > 0) {
    throw InputError(
        fmt::format("mesh: {} open edges remain around {} holes that cannot be filled (close them in a mesh "
                    "editor)",
                    topology.open_edges, std::max<std::size_t>(1, filling.left)));
  }
  const double volume = std::abs(solid_properties(mesh).volume);
  report.volume_uncertainty = (triangular.uncertain_volume + filling.uncertain_volume) / volume;
  if (report.volume_uncertainty <= accepted_uncertainty) return;
  throw InputError(
      fmt::format("mesh: its {} holes leave {:.0f} % of the volume open, accepted are {:.0f} % (close them in a mesh "
                  "editor)",
                  report.holes_filled, 100 * report.volume_uncertainty, 100 * accepted_uncertainty));
}

void face_outward(Mesh& mesh, const RepairReport& report) {
  if (report.components > 1 && report.intersecting_pairs == 0) orient_outward(mesh);
  const double volume = solid_properties(mesh).volume;
  if (volume < 0) turn_around(mesh);
  if (std::abs(volume) > 1e-9 * bounds(mesh).volume()) return;
  throw InputError(fmt::format("mesh: encloses no volume, {:g} m³ (give the surface of a solid, not a sheet)", volume));
}

// A filled or overlapping surface may be closed and still mean something else than its integral says.
void compare_volumes(const Mesh& mesh, const RepairReport& report) {
  if (report.holes_filled == 0) return;
  const double volume = solid_properties(mesh).volume, counted = counted_volume(mesh);
  if (std::abs(counted / volume - 1) <= accepted_uncertainty) return;
  throw InputError(
      fmt::format("mesh: with its {} holes filled it encloses {:g} m³ by its surface but {:g} m³ by voxels (close "
                  "the holes in a mesh editor)",
                  report.holes_filled, volume, counted));
}

// Pieces that pierce each other become one; those that only touch stay as they are, and nothing pierces. Says what was
// done. What cannot be united is refused if its integral counts a part of it twice.
std::string unite(Mesh& mesh, RepairReport& report) {
  if (report.intersecting_pairs == 0 || report.components < 2) return "";
  const double sum = solid_properties(mesh).volume;
  Mesh united = mesh;
  if (!unite_pieces(united)) {
    const double counted = counted_volume(mesh);
    if (std::abs(counted / sum - 1) <= accepted_uncertainty) return "";
    throw InputError(
        fmt::format("mesh: its {} pieces overlap, they count {:g} m³ together and enclose {:g} m³ (unite them in a "
                    "mesh editor)",
                    report.components, sum, counted));
  }
  report.intersecting_pairs = 0;
  const double volume = solid_properties(united).volume;
  if (std::abs(volume - sum) <= 1e-9 * sum) return "";
  mesh = std::move(united);
  report.components = mesh_topology(mesh).components;
  return fmt::format("overlapping pieces united: {:.6g} cm³, not the {:.6g} cm³ of their sum", 1e6 * volume, 1e6 * sum);
}

std::string method(const RepairReport& report) {
  std::vector<std::string> steps;
  if (report.points_welded > 0) steps.push_back("points joined");
  if (report.degenerate_faces + report.duplicate_faces > 0) steps.push_back("faces dropped");
  if (report.faces_flipped > 0) steps.push_back("oriented");
  if (report.holes_filled > 0) steps.push_back("holes filled");
  return steps.empty() ? "as given" : fmt::format("{}", fmt::join(steps, ", "));
}

std::string confidence(const RepairReport& report, std::size_t given_faces) {
  std::string text;
  if (report.holes_filled > 0) {
    text = fmt::format("{} holes filled: volume known to about {:.2g} %", report.holes_filled,
                       std::max(0.01, 100 * report.volume_uncertainty));
  } else if (report.faces_flipped == given_faces) {
    text = "inside out as given, all faces turned: certain";
  } else if (report.faces_flipped > 0) {
    text = fmt::format("{:.2g} % of faces flipped: certain",
                       100 * static_cast<double>(report.faces_flipped) / static_cast<double>(given_faces));
  } else {
    text = report.closed_as_given ? "closed and consistent as given" : "consistent as given";
  }
  if (report.intersecting_pairs > 0) {
    text += fmt::format("; but {} pairs of faces pierce each other: volume and inertia may count overlaps twice",
                        report.intersecting_pairs);
  }
  return text;
}

}  // namespace

RepairReport repair(Mesh& mesh) {
  RepairReport report;
  const double crack = clean(mesh, report);
  const std::vector<Corners> given = corners(mesh);
  MeshTopology topology = mesh_topology(mesh);
  report.closed_as_given = topology.open_edges == 0 && crack == 0;

  // Solids that touch along an edge are closed and oriented, but no manifold: splitting them would tear them open.
  const bool touching = topology.closed_and_oriented() && topology.non_manifold_edges > 0;
  HoleFilling triangular;
  if (topology.clashing_edges + topology.non_manifold_edges == 0) triangular = fill_triangular_holes(mesh);
  if (!touching && !is_manifold(mesh)) orient_soup(mesh);
  if (triangular.filled > 0 || mesh_topology(mesh).open_edges > 0) {
    if (topology.non_manifold_edges > 0) {
      throw InputError(
          fmt::format("mesh: {} edges have more than two faces and {} only one (remove inner walls and doubled "
                      "faces in a mesh editor)",
                      topology.non_manifold_edges, topology.open_edges));
    }
    close(mesh, triangular, report);
  }
  topology = mesh_topology(mesh);
  if (!topology.closed_and_oriented()) {
    throw InputError(
        "mesh: its faces cannot be given one outer side, as those of a Moebius strip (correct it in a mesh editor)");
  }
  report.components = topology.components;
  if (!touching) report.intersecting_pairs = count_self_intersections(mesh);
  face_outward(mesh, report);
  compare_volumes(mesh, report);
  report.faces_flipped = count_flipped(given, mesh);
  report.oriented_as_given = report.faces_flipped == 0;
  const std::string united = unite(mesh, report);
  report.method = method(report);
  report.confidence = confidence(report, given.size());
  if (crack > 0)
    report.confidence += fmt::format("; a crack was closed, its points lay up to {:.2g} mm apart", 1e3 * crack);
  if (!united.empty()) {
    report.method = report.method == "as given" ? "pieces united" : report.method + ", pieces united";
    report.confidence += "; " + united;
  }
  return report;
}

}  // namespace handhold
