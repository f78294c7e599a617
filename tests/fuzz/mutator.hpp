// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace handhold::fuzz {

/// Spoils the bytes of files, the same way on every machine for the same seed: bits, bytes, ranges, lines, numbers in
/// text and in binary, nesting, and pieces of other files of the kind.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : state_(seed) {}

  /// One of `seeds` with one to four changes; at most some megabytes.
  [[nodiscard]] std::string mutant(const std::string& seed, const std::vector<std::string>& others);

  /// Below `limit`; 0 if that is 0.
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : next() % limit; }

 private:
  struct Range {
    std::size_t at, length;
  };

  std::uint64_t next();
  Range range(const std::string& bytes, std::size_t longest);
  Range line(const std::string& bytes);
  Range word(const std::string& bytes);
  void change(std::string& bytes, const std::vector<std::string>& others);

  std::uint64_t state_;
};

}  // namespace handhold::fuzz
