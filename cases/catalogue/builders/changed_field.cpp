// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "cases/catalogue/builders/changed.hpp"

namespace handhold::catalogue {
namespace {

/// A grid's entries with j running the other way.
template <class Entry>
std::vector<Entry> mirrored(const std::vector<Entry>& entries, const Eigen::Vector3i& size) {
  std::vector<Entry> made;
  made.reserve(entries.size());
  for (int k = 0; k < size.z(); ++k)
    for (int j = size.y() - 1; j >= 0; --j) {
      const auto row = entries.begin() + std::ptrdiff_t(k * size.y() + j) * size.x();
      made.insert(made.end(), row, row + size.x());
    }
  return made;
}

void mirror(VoxelField::Data& data) {
  const Grid grid = data.grid;
  data.grid.origin.y() = -(grid.origin.y() + grid.spacing * (grid.size.y() - 1));
  data.distance = mirrored(data.distance, grid.size);
  std::vector<std::uint8_t> inside(grid.count());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = data.occupied[i >> 6] >> (i & 63) & 1;
  inside = mirrored(inside, grid.size);
  std::fill(data.occupied.begin(), data.occupied.end(), 0);
  for (std::size_t i = 0; i < inside.size(); ++i) data.occupied[i >> 6] |= std::uint64_t(inside[i]) << (i & 63);
  for (Eigen::Vector3d& v : data.mesh.vertices) v.y() = -v.y();
  for (auto& triangle : data.mesh.triangles) std::swap(triangle[1], triangle[2]);  // outward stays outward
  data.cell_origin.y() = -(data.cell_origin.y() + data.cell_size * data.cell_count.y());
  std::vector<std::uint32_t> cells(data.cell_start.size() - 1), start{0}, triangles;
  std::iota(cells.begin(), cells.end(), 0);
  for (const std::uint32_t cell : mirrored(cells, data.cell_count)) {
    const auto all = data.cell_triangles.begin();
    triangles.insert(triangles.end(), all + data.cell_start[cell], all + data.cell_start[cell + 1]);
    start.push_back(std::uint32_t(triangles.size()));
  }
  data.cell_start = start;
  data.cell_triangles = triangles;
}

}  // namespace

std::shared_ptr<const VoxelField> changed(const VoxelField& field, const Change& change) {
  VoxelField::Data data = field.data();
  const double L = change.length;
  for (Eigen::Vector3d& v : data.mesh.vertices) v *= L;
  for (float& d : data.distance) d *= float(L);
  data.grid.origin *= L;
  data.cell_origin *= L;
  for (double* length : {&data.grid.spacing, &data.band, &data.cell_size}) *length *= L;
  if (change.mirrored) mirror(data);
  return std::make_shared<const VoxelField>(std::move(data));
}

}  // namespace handhold::catalogue
