// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/data/deflate.hpp"
#include "reports/data/packed_columns.hpp"

namespace handhold::reports {

/// Reads packed columns as the page does: written from the format's description, not from the packer.
class Unpacked {
 public:
  explicit Unpacked(const std::string& packed) {
    const std::string bytes = inflated(packed);
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);  // little endian, as the machines of the tests
    header = nlohmann::json::parse(bytes.substr(4, length));
    data_ = bytes.substr(4 + length);
  }

  /// To be said before the first column: how many 16-bit numbers there are in all.
  void expect(std::size_t numbers) { numbers_ = numbers; }

  std::vector<std::uint16_t> integers(std::size_t n) {
    std::vector<std::uint16_t> out;
    std::uint16_t value = 0;
    for (std::size_t k = 0; k < n; ++k, ++at_) {
      const auto z = std::uint16_t(byte(at_) | byte(numbers_ + at_) << 8);
      const int difference = z & 1 ? -(z + 1) / 2 : z / 2;
      value = std::uint16_t(value + difference);
      out.push_back(value);
    }
    return out;
  }

  std::vector<double> numbers(std::size_t n, const nlohmann::json& scale) {
    std::vector<double> out;
    for (const std::uint16_t q : integers(n))
      out.push_back(scale["lo"].get<double>() + scale["step"].get<double>() * q);
    return out;
  }

  /// Column `i` of the columns of bytes behind all numbers.
  std::vector<int> bytes(std::size_t i, std::size_t n) const {
    std::vector<int> out;
    for (std::size_t k = 0; k < n; ++k) out.push_back(byte(2 * numbers_ + i * n + k));
    return out;
  }

  [[nodiscard]] std::size_t size() const { return data_.size(); }

  nlohmann::json header{};

 private:
  [[nodiscard]] int byte(std::size_t i) const { return static_cast<unsigned char>(data_.at(i)); }

  std::string data_{};
  std::size_t numbers_{}, at_{};
};

}  // namespace handhold::reports
