// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/fingerprint.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace handhold {
namespace {

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t sum) {
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return sum;
}

}  // namespace

std::string fingerprint(std::string_view bytes) {
  return fmt::format("{:016x}{:016x}", fnv1a(bytes, 0xcbf29ce484222325ull), fnv1a(bytes, 0x9e3779b97f4a7c15ull));
}

}  // namespace handhold
