// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/voxel_file.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/surface_samples.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/byte_stream.hpp"
#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

const Vector3d size(0.02, 0.03, 0.04);

std::shared_ptr<const VoxelField> box() { return voxelize(make_box(size), {0.004, 0.008}); }

std::string packed() { return pack_voxels(*box(), surface_samples(make_box(size), 0.04)); }

// Where docs/hhvox.md says that things are.
constexpr std::size_t version_at = 8, checksum_at = 12, content_at = 16, spacing_at = 40, nodes_at = 48, band_at = 60,
                      cell_size_at = 92, cells_at = 100, lists_at = 112;

template <class T>
T value(const std::string& bytes, std::size_t at) {
  T x;
  std::memcpy(&x, bytes.data() + at, sizeof x);
  return x;
}

template <class T>
void put(std::string& bytes, std::size_t at, T x) {
  std::memcpy(bytes.data() + at, &x, sizeof x);
}

/// Makes the checksum right again: what an attacker does.
void sign(std::string& bytes) { put(bytes, checksum_at, crc32(std::string_view(bytes).substr(content_at))); }

/// Where the seven lists begin (their counts), in the order of the document.
std::vector<std::size_t> list_places(const std::string& bytes) {
  const std::size_t each[] = {24, 12, 8, 4, 4, 4, 24};
  std::vector<std::size_t> places;
  std::size_t at = lists_at;
  for (const std::size_t item : each) {
    places.push_back(at);
    at += 8 + value<std::uint64_t>(bytes, at) * item;
  }
  EXPECT_EQ(at, bytes.size());
  return places;
}

/// An InputError, or a shape that answers: nothing else may come of any bytes.
void expect_safe(const std::string& bytes) {
  try {
    const VoxelFile file = unpack_voxels(bytes, "X.hhvox");
    for (const Vector3d& p : {Vector3d(0.011, 0, 0), Vector3d(0, 0.02, 0.03), Vector3d(1, 1, 1)}) {
      (void)file.field->distance(p);
      (void)file.field->closest(p, 0.1);
      (void)file.field->raycast(p, -p.normalized(), 10);
    }
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("X.hhvox: ", 0), 0u) << error.what();
  }
}

TEST(VoxelFile, GivesBackWhatItWasGiven) {
  const std::vector<Vector3d> samples = surface_samples(make_box(size), 0.04);
  const std::shared_ptr<const VoxelField> field = box();
  const VoxelField::Data& given = field->data();
  const VoxelFile file = unpack_voxels(pack_voxels(*box(), samples), "X.hhvox");
  const VoxelField::Data& read = file.field->data();
  EXPECT_EQ(read.mesh.vertices, given.mesh.vertices);
  EXPECT_EQ(read.mesh.triangles, given.mesh.triangles);
  EXPECT_EQ(read.grid.origin, given.grid.origin);
  EXPECT_EQ(read.grid.spacing, given.grid.spacing);
  EXPECT_EQ(read.grid.size, given.grid.size);
  EXPECT_EQ(read.band, given.band);
  EXPECT_EQ(read.occupied, given.occupied);
  EXPECT_EQ(read.distance, given.distance);
  EXPECT_EQ(read.cell_size, given.cell_size);
  EXPECT_EQ(read.cell_origin, given.cell_origin);
  EXPECT_EQ(read.cell_count, given.cell_count);
  EXPECT_EQ(read.cell_start, given.cell_start);
  EXPECT_EQ(read.cell_triangles, given.cell_triangles);
  EXPECT_EQ(file.samples_O, samples);
}

/// Reads by the offsets of docs/hhvox.md, without our reader.
TEST(VoxelFile, IsLaidOutAsDocumented) {
  const std::string bytes = packed();
  EXPECT_EQ(bytes.substr(0, 8), "HHVOX\r\n\x1a");
  EXPECT_EQ(value<std::uint32_t>(bytes, version_at), 1u);
  EXPECT_EQ(value<std::uint32_t>(bytes, checksum_at), crc32(bytes.substr(content_at)));
  EXPECT_EQ(value<double>(bytes, spacing_at), 0.004);
  EXPECT_EQ(value<double>(bytes, band_at), 0.008);
  const std::shared_ptr<const VoxelField> field = box();
  const VoxelField::Data& data = field->data();
  EXPECT_EQ(value<double>(bytes, content_at), data.grid.origin.x());
  EXPECT_EQ(value<std::int32_t>(bytes, nodes_at + 8), data.grid.size.z());
  EXPECT_EQ(value<double>(bytes, cell_size_at), data.cell_size);
  EXPECT_EQ(value<std::int32_t>(bytes, cells_at), data.cell_count.x());
  const std::vector<std::size_t> lists = list_places(bytes);
  EXPECT_EQ(value<std::uint64_t>(bytes, lists[0]), 8u);   // corners of a box
  EXPECT_EQ(value<std::uint64_t>(bytes, lists[1]), 12u);  // its triangles
  EXPECT_EQ(value<std::uint64_t>(bytes, lists[6]), 8u);   // samples at its corners
  EXPECT_EQ(value<double>(bytes, lists[0] + 8), data.mesh.vertices[0].x());
  EXPECT_EQ(value<float>(bytes, lists[3] + 8), data.distance[0]);
}

TEST(VoxelFile, RefusesWhatIsCutOff) {
  const std::string bytes = packed();
  for (std::size_t length = 0; length < bytes.size(); length += 64) {
    std::string cut = bytes.substr(0, length);
    expect_input_error([&] { (void)unpack_voxels(cut, "X.hhvox"); }, {"X.hhvox: "});
    if (length < lists_at) continue;
    sign(cut);
    expect_input_error([&] { (void)unpack_voxels(cut, "X.hhvox"); }, {"X.hhvox: "});
  }
  expect_input_error([&] { (void)unpack_voxels(bytes + '\0', "X.hhvox"); }, {"checksum"});
}

TEST(VoxelFile, RefusesEveryByteThatIsNotAsWritten) {
  const std::string bytes = packed();
  for (std::size_t at = 0; at < bytes.size(); at += at < 256 ? 1 : 61) {
    std::string flipped = bytes;
    flipped[at] = char(flipped[at] ^ (1 << at % 8));
    expect_input_error([&] { (void)unpack_voxels(flipped, "X.hhvox"); }, {"X.hhvox: "});
  }
}

TEST(VoxelFile, IsSafeEvenIfTheChecksumIsForged) {
  const std::string bytes = packed();
  for (std::size_t at = content_at; at < bytes.size(); at += at < 512 ? 1 : 61) {
    for (const int change : {0x01, 0x80, 0xff}) {
      std::string forged = bytes;
      forged[at] = char(forged[at] ^ change);
      sign(forged);
      expect_safe(forged);
    }
  }
}

TEST(VoxelFile, TakesNoMemoryForCountsThatItCannotHold) {
  const std::string bytes = packed();
  for (const std::size_t place : list_places(bytes)) {
    const auto count = value<std::uint64_t>(bytes, place);
    for (const std::uint64_t forged_count :
         {count + 1, count - 1, std::uint64_t(1) << 32, std::uint64_t(1) << 61, ~std::uint64_t(0)}) {
      std::string forged = bytes;
      put(forged, place, forged_count);
      sign(forged);
      expect_input_error([&] { (void)unpack_voxels(forged, "X.hhvox"); }, {"X.hhvox: "});
    }
  }
}

TEST(VoxelFile, RefusesValuesThatNoShapeHas) {
  const auto refused = [](std::size_t at, auto x, const std::string& word) {
    std::string forged = packed();
    put(forged, at, x);
    sign(forged);
    expect_input_error([&] { (void)unpack_voxels(forged, "X.hhvox"); }, {"X.hhvox: ", word});
  };
  const std::vector<std::size_t> lists = list_places(packed());
  refused(version_at, std::uint32_t(2), "version 2");
  for (const double x : {double(NAN), double(INFINITY), 0.0, -0.004, 1e-300, 1e300}) {
    refused(spacing_at, x, "spacing");
    refused(band_at, x, "band");
    refused(cell_size_at, x, "size");
  }
  for (const std::int32_t n : {0, -1, 1, 1 << 30}) refused(nodes_at, n, "nodes a side");
  for (const std::int32_t n : {0, -1, 1 << 30}) refused(cells_at, n, "cells");
  refused(content_at, double(NAN), "origin");
  refused(lists[0] + 8, double(NAN), "band beyond the solid");
  refused(lists[0] + 8, 1.0, "band beyond the solid");
  refused(lists[1] + 8, std::int32_t(8), "vertex that does not exist");
  refused(lists[1] + 8, std::int32_t(-1), "vertex that does not exist");
  refused(lists[3] + 8, float(NAN), "finite");
  refused(lists[4] + 8, std::uint32_t(1), "ascend from 0");
  refused(lists[5] + 8, std::uint32_t(12), "triangle that does not exist");
  refused(lists[6] + 8, double(INFINITY), "surface sample");
}

/// Counts whose product is 0 or 1 in 64 bits would pass for lists that are empty.
TEST(VoxelFile, RefusesCountsWhoseProductOverflows) {
  std::string forged = packed();
  for (int axis = 0; axis < 3; ++axis)
    put(forged, cells_at + 4 * std::size_t(axis), std::int32_t(1 << (22 - (axis > 0))));
  sign(forged);
  expect_input_error([&] { (void)unpack_voxels(forged, "X.hhvox"); }, {"cells"});
}

TEST(VoxelFile, NamesTheFileThatCannotBeReadOrWritten) {
  const fs::path folder = fs::temp_directory_path() / "handhold_voxel_file_test";
  fs::create_directories(folder);
  const fs::path file = folder / "box.hhvox";
  write_voxel_file(file, *box());
  EXPECT_TRUE(read_voxel_file(file).samples_O.empty());
  EXPECT_EQ(read_voxel_file(file).field->data().distance, box()->data().distance);
  expect_input_error([&] { (void)read_voxel_file(folder / "none.hhvox"); }, {"none.hhvox: "});
  expect_input_error([&] { (void)read_voxel_file(folder); }, {"handhold_voxel_file_test: "});
  std::ofstream(file) << "solid cube\n";
  expect_input_error([&] { (void)read_voxel_file(file); }, {"box.hhvox: must be a .hhvox file"});
  expect_input_error([&] { write_voxel_file(folder / "no/such/folder.hhvox", *box()); }, {"folder.hhvox: "});
  expect_input_error([] { (void)pack_voxels(*box(), std::vector<Vector3d>(256, Vector3d::Zero())); }, {"256"});
  fs::remove_all(folder);
}

}  // namespace
}  // namespace handhold
