// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/object_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

std::string millimetres(const Eigen::Vector3d& v, std::string_view between) {
  const auto tenths = [](double metres) { return std::round(1e4 * metres) / 10 + 0.0; };  // + 0.0: no "-0.0"
  return fmt::format("{:.1f}{}{:.1f}{}{:.1f} mm", tenths(v.x()), between, tenths(v.y()), between, tenths(v.z()));
}

std::string percent(double share) { return fmt::format("{:+.2g} %", 100 * share); }

std::string moments(const Eigen::Matrix3d& inertia) {  // at 1000 kg/m³, in g cm²: numbers a hand can imagine
  const Eigen::Vector3d d = inertia.diagonal() * 1000 * 1e7;
  return fmt::format("{:.4g}, {:.4g}, {:.4g} g cm² about the centre at 1000 kg/m³", d.x(), d.y(), d.z());
}

std::string counted(std::size_t count, std::string_view what) {
  return count == 0 ? "" : fmt::format(", {} {}", count, what);
}

}  // namespace

std::string repair_text(const RepairReport& repair, const std::vector<std::string>& warnings) {
  std::string done = repair.method.empty() ? "as given" : one_line(repair.method);
  done += counted(repair.points_welded, "points joined") +
          counted(repair.degenerate_faces, "degenerate faces dropped") +
          counted(repair.duplicate_faces, "duplicate faces dropped") +
          counted(repair.faces_flipped, "faces turned around") + counted(repair.holes_filled, "holes filled");
  std::string out = summary_line("surface", done);
  if (repair.components > 1) out += summary_line("", fmt::format("{} separate pieces", repair.components));
  if (repair.intersecting_pairs > 0)
    out += summary_line("", fmt::format("{} pairs of faces pierce each other", repair.intersecting_pairs));
  if (!repair.confidence.empty()) out += summary_line("", repair.confidence);
  for (const std::string& warning : warnings) out += summary_line("warning", warning);
  return out;
}

std::string voxel_text(const VoxelReport& report) {
  std::string out = one_line(report.source) + "\n";
  out += summary_line("size", millimetres(report.size, " x "));
  out += summary_line("triangles", std::to_string(report.triangles));
  out += summary_line("voxels", fmt::format("{} inside, of {:.3g} mm, in a grid of {} nodes, distances up to {:.3g} mm",
                                            report.voxels, 1e3 * report.voxel_size, report.nodes, 1e3 * report.band));
  out += summary_line("volume", fmt::format("{:.5g} cm³, by voxels {:.5g} cm³ ({})", 1e6 * report.polyhedron.volume,
                                            1e6 * report.counted.volume, percent(report.volume_difference)));
  out += summary_line("centre", millimetres(report.polyhedron.center, ", "));
  out += summary_line("moments", moments(report.polyhedron.inertia));
  out += summary_line("", fmt::format("by voxels, largest difference {}", percent(report.inertia_difference)));
  out += summary_line("thinnest wall", std::isfinite(report.thinnest_wall)
                                           ? fmt::format("about {:.2g} mm", 1e3 * report.thinnest_wall)
                                           : "none found");
  out += repair_text(report.repair, report.warnings);
  return out + summary_line("time", readable(report.seconds, "s"));
}

}  // namespace handhold::reports
