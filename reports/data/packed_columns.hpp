// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace handhold::reports {

/// Packed data by name. A name is made from the bytes, so that the same mesh or recording is kept once.
using Blobs = std::map<std::string, std::string>;

/// A number as 16 bits: value = lo + step q, q = 0 ... 65535. The error is at most step / 2 plus the rounding of a
/// double; values that are not finite are stored as `lo`.
struct Quantisation {
  double lo{};
  double step{1};
};

/// The finest scale that holds all of `values`; {lo, 1} if they are all equal, so that they are stored exactly.
[[nodiscard]] Quantisation quantisation_of(const std::vector<double>& values);

/// Quaternion components: [-1, 1].
inline constexpr Quantisation unit_quantisation{-1, 2.0 / 65535};

/// Collects columns of 16-bit integers and of bytes, and packs them: differences down each column (mod 2^16), zigzag,
/// all low bytes before all high bytes, then the columns of bytes, deflated. Slow motion becomes mostly zeros.
class PackedColumns {
 public:
  void add(const std::vector<double>& values, const Quantisation& scale);
  void add(const std::vector<std::uint16_t>& values);
  void add_bytes(const std::vector<std::uint8_t>& values);

  /// Raw deflate of: length of `header` (32 bits, little endian), `header` (JSON, UTF-8), the columns.
  [[nodiscard]] std::string packed(std::string_view header) const;

 private:
  std::string low_{}, high_{}, bytes_{};
};

/// Puts `bytes` into `blobs` and returns their name: `kind`, a dash, and their hash in 16 hexadecimal digits.
std::string store(std::string_view kind, std::string bytes, Blobs& blobs);

}  // namespace handhold::reports
