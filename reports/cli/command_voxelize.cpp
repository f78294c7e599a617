// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/geometry/surface_samples.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/input/mesh/mesh_import.hpp"
#include "cases/model/voxel_file.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/object_source.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/object_text.hpp"

namespace handhold::reports {
namespace {

struct VoxelizeCommand {
  std::string object{};
  double voxel_size_mm{0};
  double scale{1};
  std::string out{};
  double sample_spacing_mm{0};
};

void write(const VoxelizeCommand& command, const Mesh& mesh, const VoxelField& field) {
  std::vector<Eigen::Vector3d> samples;
  if (command.sample_spacing_mm > 0) samples = surface_samples(mesh, command.sample_spacing_mm * 1e-3);
  write_voxel_file(command.out, field, samples);
}

VoxelReport report(const VoxelizeCommand& command) {
  ProgressLine progress(ProgressLine::Elsewhere::silent);
  progress.step("reading " + command.object);
  const ImportedMesh imported = read_object(command.object, command.scale);
  progress.step("voxelizing " + command.object);
  const auto start = std::chrono::steady_clock::now();
  const std::shared_ptr<const VoxelField> field = voxelize(imported.mesh, {command.voxel_size_mm * 1e-3, 0});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!command.out.empty()) write(command, imported.mesh, *field);
  progress.step("measuring " + command.object);
  return describe(imported, *field, seconds);
}

}  // namespace

void add_voxelize(CLI::App& app, Invocation&) {
  CLI::App* command =
      app.add_subcommand("voxelize", "Voxelize an object and compare its volume and inertia with its surface's");
  const auto options = std::make_shared<VoxelizeCommand>();
  command->add_option("object", options->object, "mesh file (OBJ, STL, PLY, OFF, glTF, ...) or shape:kind")->required();
  command
      ->add_option("--voxel-size", options->voxel_size_mm,
                   "edge of a voxel [mm] (default: longest side / 128, 0.5 to 1.5 mm)")
      ->check(number_in(0.01, 100));
  command->add_option("--scale", options->scale, "file units to metres, e.g. 0.001 for millimetres")
      ->check(number_in(1e-9, 1e9))
      ->capture_default_str();
  CLI::Option* out = command->add_option("--out", options->out, "write the voxels as a .hhvox file (docs/hhvox.md)");
  command
      ->add_option("--sample-spacing", options->sample_spacing_mm,
                   "with --out: also write points that touch other bodies, at most so far apart [mm]")
      ->check(number_in(0.01, 1e6))
      ->needs(out);
  command->footer(
      "Examples:\n  handhold voxelize mug.obj\n  handhold voxelize part.stl --scale 0.001 --voxel-size 0.5\n  handhold "
      "voxelize shape:mug,height=0.12 --out mug.hhvox");
  command->callback([options] { say(voxel_text(report(*options))); });
}

}  // namespace handhold::reports
