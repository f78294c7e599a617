// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string_view>
#include <utility>

#include "cases/model/mass_properties.hpp"
#include "cases/model/voxel_file.hpp"
#include "realtime/c_support.hpp"

using handhold::VoxelField;
using handhold::VoxelFile;
using handhold::c::guarded;
using handhold::c::require;
using handhold::c::store;
using handhold::c::vector;

namespace {

/// Product of three counts that are above 0 and at most `most` each.
std::size_t product(const int count[3], int least, const char* rule) {
  constexpr int most = 1 << 20;  // so that the product cannot overflow
  require(std::min({count[0], count[1], count[2]}) >= least && std::max({count[0], count[1], count[2]}) <= most, rule);
  return std::size_t(count[0]) * std::size_t(count[1]) * std::size_t(count[2]);
}

VoxelField::Data data_of(const hh_field_data& d) {
  require(d.vertices && d.triangles && d.distances && d.occupied && d.cell_start && d.cell_triangles,
          "field: a list is missing (all six are needed)");
  require(d.vertex_count > 0 && d.triangle_count > 0, "field: needs vertices and triangles");
  const std::size_t nodes = product(d.grid_size, 2, "field: the grid needs 2 to 2^20 nodes a side");
  const std::size_t cells = product(d.cell_count, 1, "field: needs 1 to 2^20 cells along every axis");
  VoxelField::Data data;
  for (int i = 0; i < d.vertex_count; ++i) data.mesh.vertices.push_back(vector(d.vertices + 3 * std::ptrdiff_t(i)));
  for (int i = 0; i < d.triangle_count; ++i) {
    const int* t = d.triangles + 3 * std::ptrdiff_t(i);
    data.mesh.triangles.push_back({t[0], t[1], t[2]});
  }
  data.grid.origin = vector(d.grid_origin);
  data.grid.spacing = d.grid_spacing;
  data.grid.size = {d.grid_size[0], d.grid_size[1], d.grid_size[2]};
  data.band = d.band;
  data.distance.assign(d.distances, d.distances + nodes);
  data.occupied.assign((nodes + 63) / 64, 0);
  for (std::size_t i = 0; i < nodes; ++i) data.occupied[i / 64] |= std::uint64_t(d.occupied[i] != 0) << (i % 64);
  data.cell_size = d.cell_size;
  data.cell_origin = vector(d.cell_origin);
  data.cell_count = {d.cell_count[0], d.cell_count[1], d.cell_count[2]};
  data.cell_start.assign(d.cell_start, d.cell_start + cells + 1);
  data.cell_triangles.assign(d.cell_triangles, d.cell_triangles + d.cell_triangle_count);
  return data;
}

std::vector<Eigen::Vector3d> samples_of(const hh_field_data& d) {
  require(d.sample_count >= 0 && (d.samples || d.sample_count == 0), "field: sample_count without samples");
  std::vector<Eigen::Vector3d> samples;
  for (int i = 0; i < d.sample_count; ++i) samples.push_back(vector(d.samples + 3 * std::ptrdiff_t(i)));
  return samples;
}

void hand_out(VoxelFile file, hh_field** field) {
  *field = new hh_field{std::move(file.field), std::move(file.samples_O)};
}

}  // namespace

int hh_field_create(const hh_field_data* data, hh_field** field, hh_error* error) {
  return guarded(error, [&] {
    require(field, "hh_field_create: field must not be null");
    *field = nullptr;
    require(data, "hh_field_create: data must not be null");
    hand_out({std::make_shared<const VoxelField>(data_of(*data)), samples_of(*data)}, field);
  });
}

int hh_field_load(const char* path, hh_field** field, hh_error* error) {
  return guarded(error, [&] {
    require(field, "hh_field_load: field must not be null");
    *field = nullptr;
    require(path, "hh_field_load: path must not be null");
    hand_out(handhold::read_voxel_file(path), field);
  });
}

int hh_field_from_bytes(const void* bytes, size_t size, hh_field** field, hh_error* error) {
  return guarded(error, [&] {
    require(field, "hh_field_from_bytes: field must not be null");
    *field = nullptr;
    require(bytes, "hh_field_from_bytes: bytes must not be null");
    hand_out(handhold::unpack_voxels({static_cast<const char*>(bytes), size}, "field"), field);
  });
}

int hh_field_solid(const hh_field* field, double mass, double center_of_mass[3], double inertia[9], hh_error* error) {
  return guarded(error, [&] {
    require(field && center_of_mass && inertia, "hh_field_solid: no argument must be null");
    require(std::isfinite(mass) && mass > 0, "mass: must be above 0 kg");
    const handhold::SolidProperties solid = handhold::solid_properties(field->field->mesh());
    require(solid.volume > 0,
            "field: its surface must enclose a volume (triangles counter-clockwise seen from outside)");
    store(solid.center, center_of_mass);
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(inertia, 3, 3) = mass / solid.volume * solid.inertia;
  });
}

void hh_field_destroy(hh_field* field) { delete field; }
