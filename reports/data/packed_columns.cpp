// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/packed_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "reports/data/deflate.hpp"

namespace handhold::reports {
namespace {

constexpr double most = 65535;

std::uint16_t quantised(double value, const Quantisation& scale) {
  if (!std::isfinite(value)) return 0;
  return std::uint16_t(std::clamp(std::round((value - scale.lo) / scale.step), 0.0, most));
}

/// Small differences of either sign become small numbers.
std::uint16_t zigzag(std::uint16_t difference) {
  const auto sign = std::uint16_t(difference & 0x8000 ? 0xffff : 0);
  return std::uint16_t(std::uint16_t(difference << 1) ^ sign);
}

std::string little_endian(std::uint32_t value) {
  std::string out;
  for (int shift = 0; shift < 32; shift += 8) out += char(value >> shift & 255);
  return out;
}

/// FNV-1a, 64 bits.
std::uint64_t hash(std::string_view bytes) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

}  // namespace

Quantisation quantisation_of(const std::vector<double>& values) {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  if (!(lo <= hi)) return {};
  const double step = (hi - lo) / most;
  return {lo, step > 0 ? step : 1};
}

void PackedColumns::add(const std::vector<double>& values, const Quantisation& scale) {
  std::vector<std::uint16_t> column;
  column.reserve(values.size());
  for (const double v : values) column.push_back(quantised(v, scale));
  add(column);
}

void PackedColumns::add(const std::vector<std::uint16_t>& values) {
  std::uint16_t before = 0;
  for (const std::uint16_t q : values) {
    const std::uint16_t z = zigzag(std::uint16_t(q - std::exchange(before, q)));
    low_ += char(z & 255);
    high_ += char(z >> 8);
  }
}

void PackedColumns::add_bytes(const std::vector<std::uint8_t>& values) { bytes_.append(values.begin(), values.end()); }

std::string PackedColumns::packed(std::string_view header) const {
  std::string out = little_endian(std::uint32_t(header.size()));
  return deflated(out.append(header).append(low_).append(high_).append(bytes_));
}

std::string store(std::string_view kind, std::string bytes, Blobs& blobs) {
  const std::string name = fmt::format("{}-{:016x}", kind, hash(bytes));
  blobs.emplace(name, std::move(bytes));
  return name;
}

}  // namespace handhold::reports
