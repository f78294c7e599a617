#include "cases/input/mesh/binary_file.hpp"

#include <bit>

#include <fmt/format.h>

namespace handhold {

static_assert(std::endian::native == std::endian::little, "the cache's format is little-endian");

namespace {

// Eight tables, to take eight bytes a step: one table is slower than the disk.
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xEDB88320u ^ sum >> 1 : sum >> 1;
    tables[0][byte] = sum;
  }
  for (std::size_t t = 1; t < 8; ++t) {
    for (std::size_t byte = 0; byte < 256; ++byte)
      tables[t][byte] = tables[t - 1][byte] >> 8 ^ tables[0][tables[t - 1][byte] & 0xFF];
  }
  return tables;
}

constexpr Tables tables = make_tables();

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t sum) {
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return sum;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t sum = 0xFFFFFFFFu;
  while (bytes.size() >= 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), 8);
    word ^= sum;
    sum = 0;
    for (std::size_t t = 0; t < 8; ++t) sum ^= tables[7 - t][word >> 8 * t & 0xFF];
    bytes.remove_prefix(8);
  }
  for (const char c : bytes) sum = sum >> 8 ^ tables[0][(sum ^ static_cast<unsigned char>(c)) & 0xFF];
  return ~sum;
}

std::string fingerprint(std::string_view bytes) {
  return fmt::format("{:016x}{:016x}", fnv1a(bytes, 0xcbf29ce484222325ull), fnv1a(bytes, 0x9e3779b97f4a7c15ull));
}

}  // namespace handhold
