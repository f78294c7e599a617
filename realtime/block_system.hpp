#pragma once

#include <cstdint>
#include <vector>

#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// Sparse linear system of 6 x 6 blocks, one row a body: A x = b by block LU, eliminating bodies with few neighbours
/// first (minimum degree; the lower row on ties). Its pattern is symmetric, its values need not be. No pivoting between
/// blocks: their diagonal ones hold the masses.
class BlockSystem {
 public:
  /// Room for `rows` bodies: all that is ever allocated.
  void reserve(int rows);

  /// Starts a system of `rows` rows without couplings.
  void begin(int rows);
  void couple(int i, int j);
  /// Orders the rows, once all couplings are known.
  void analyse();

  /// Sets every block to zero.
  void clear();
  /// Row i, column j: i == j, or a coupled pair.
  [[nodiscard]] Matrix6& block(int i, int j) { return blocks_[index(i, j)]; }

  /// Solves in place; the values of the blocks are lost.
  void solve(std::vector<Vector6>& b);

 private:
  [[nodiscard]] std::size_t index(int i, int j) const { return std::size_t(i) * std::size_t(rows_) + std::size_t(j); }

  int rows_{};
  std::vector<Matrix6> blocks_{};       // dense table, of which only the pattern is touched
  std::vector<std::uint8_t> linked_{};  // pattern, with fill
  std::vector<int> order_{};            // of elimination
  std::vector<int> degree_{};
  std::vector<int> later_{}, later_start_{};  // neighbours of a row that are eliminated after it
};

}  // namespace handhold::realtime
