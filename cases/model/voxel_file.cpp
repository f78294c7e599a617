// SPDX-License-Identifier: Apache-2.0
#include "cases/model/voxel_file.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

#include "cases/model/byte_stream.hpp"
#include "cases/model/limits.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;
using Samples = std::vector<Eigen::Vector3d>;

// The line ends and the end-of-file mark show a file that was transferred as text.
constexpr std::string_view magic = "HHVOX\r\n\x1a";
constexpr std::uint32_t version = 1;
constexpr std::size_t most_samples = 255;  // of a body, see SampleId

/// All after the checksum, to be written or read, in the order of docs/hhvox.md.
template <class Stream, class Data, class Points>
void transfer(Stream& stream, Data& data, Points& samples_O) {
  const auto triple = [&](auto& v) {
    for (int axis = 0; axis < 3; ++axis) stream.value(v[axis]);
  };
  triple(data.grid.origin);
  stream.value(data.grid.spacing);
  triple(data.grid.size);
  stream.value(data.band);
  triple(data.cell_origin);
  stream.value(data.cell_size);
  triple(data.cell_count);
  stream.list(data.mesh.vertices);
  stream.list(data.mesh.triangles);
  stream.list(data.occupied);
  stream.list(data.distance);
  stream.list(data.cell_start);
  stream.list(data.cell_triangles);
  stream.list(samples_O);
}

void require(bool holds, const std::string& name, const char* what) {
  if (!holds) throw InputError(name + ": " + what);
}

}  // namespace

std::string pack_voxels(const VoxelField& field, const Samples& samples_O) {
  if (samples_O.size() > most_samples)
    throw InputError(sentence(samples_O.size(), " surface samples: at most ", most_samples, " (space them wider)"));
  ByteWriter content, head;
  transfer(content, field.data(), samples_O);
  head.value(version);
  head.value(crc32(content.bytes()));
  return std::string(magic) + head.bytes() + content.bytes();
}

VoxelFile unpack_voxels(std::string_view bytes, const std::string& name) {
  require(bytes.substr(0, magic.size()) == magic, name,
          "must be a .hhvox file (handhold voxelize writes one; transfer it as binary)");
  ByteReader stream(bytes.substr(magic.size()));
  std::uint32_t written_version = 0, sum = 0;
  stream.value(written_version);
  stream.value(sum);
  require(!stream.failed(), name, "ends too early (copy it again)");
  if (written_version != version)
    throw InputError(sentence(name, ": version ", written_version, ": must be ", version,
                              " (write it anew with handhold voxelize)"));
  require(crc32(stream.rest()) == sum, name, "must be as it was written; its checksum differs (copy it again)");

  VoxelField::Data data;
  VoxelFile file;
  transfer(stream, data, file.samples_O);
  require(stream.done(), name, "its lists must fill it exactly (write it anew with handhold voxelize)");
  require(file.samples_O.size() <= most_samples, name, "must have at most 255 surface samples (space them wider)");
  try {
    for (const Eigen::Vector3d& p : file.samples_O) check_vector("surface sample", p, "m", most_length);
    file.field = std::make_shared<const VoxelField>(std::move(data));
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
  return file;
}

void write_voxel_file(const fs::path& file, const VoxelField& field, const Samples& samples_O) {
  const std::string bytes = pack_voxels(field, samples_O);
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), std::streamsize(bytes.size()));
  require(bool(stream.flush()), file.string(), "cannot be written (check the folder and the space left)");
}

VoxelFile read_voxel_file(const fs::path& file) {
  std::error_code error;
  require(fs::is_regular_file(file, error), file.string(), "no such file (check the path)");
  std::ifstream stream(file, std::ios::binary);
  require(bool(stream), file.string(), "cannot be read (check its permissions)");
  return unpack_voxels(std::string(std::istreambuf_iterator<char>(stream), {}), file.string());
}

}  // namespace handhold
