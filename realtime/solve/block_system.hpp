// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "realtime/rigid_body.hpp"
#include "realtime/solve/small_solve.hpp"

namespace handhold::realtime {

/// Sparse linear system of 6 x 6 blocks, one row a body: A x = b, eliminating bodies with few neighbours first (minimum
/// degree; the lower row on ties). Its pattern is symmetric, its values need not be: block LU, or block LDLᵀ where they
/// are. No pivoting between blocks: their diagonal ones hold the masses. Only the blocks of the pattern are stored, and
/// the order of elimination is kept as long as the pattern stays the same, as in a tower at rest.
class BlockSystem {
 public:
  /// Room for `rows` bodies: all that is ever allocated.
  void reserve(int rows);

  /// Starts a system of `rows` rows without couplings.
  void begin(int rows);
  void couple(int i, int j);
  /// Orders the rows, once all couplings are known. Nothing to do if they are those of the last system.
  void analyse();

  /// Sets every block to zero. `symmetric`: A will be symmetric and positive definite, but for rounding; then `solve`
  /// reads only one block of each coupled pair.
  void clear(bool symmetric = false);
  /// Row i, column j: i == j, or a coupled pair.
  [[nodiscard]] Matrix6& block(int i, int j) { return blocks_[slot(i, j)]; }

  /// Adds the slope S of a contact's force and torque about the target's centre of mass, against the relative velocity
  /// there: `offset` leads from the source's centre to it. A body that does not move has the row -1. With
  /// T = [1, -offset×; 0, 1], which takes the source's velocity to the target's centre, S is added to block
  /// (target, target), Tᵀ S T to (source, source), -S T to (target, source) and -Tᵀ S to (source, target).
  void add_contact(int target, int source, const Eigen::Vector3d& offset, const Matrix6& S);

  /// Solves in place; the values of the blocks are lost.
  void solve(std::vector<Vector6>& b);

 private:
  using Word = std::uint64_t;  // of a set of rows

  void order_rows();
  void place_blocks();
  void solve_lu(std::vector<Vector6>& b);
  void solve_ldl(std::vector<Vector6>& b);

  [[nodiscard]] std::size_t index(int i, int j) const { return std::size_t(i) * std::size_t(rows_) + std::size_t(j); }
  [[nodiscard]] std::size_t slot(int i, int j) const { return slots_[index(i, j)]; }
  /// Rows that row i is coupled to.
  [[nodiscard]] Word* set_of(std::vector<Word>& sets, int i) const { return &sets[std::size_t(i * words_)]; }

  int rows_{}, words_{};
  std::vector<Word> couplings_{}, analysed_{};  // of the new system; of the last one that was analysed
  int analysed_rows_{-1};
  std::vector<Word> linked_{};  // couplings, with fill
  std::vector<int> order_{};    // of elimination
  std::vector<int> place_{};    // of a row in it
  std::vector<int> degree_{};
  std::vector<int> later_{}, later_start_{};  // neighbours of a row that are eliminated after it, in that order

  // Diagonal blocks in order of elimination, then the blocks (later row, earlier column), then (earlier, later), both
  // as in later_.
  std::vector<Matrix6> blocks_{};
  std::vector<std::uint32_t> slots_{};      // where block (i, j) is
  bool symmetric_{false};                   // the last third is not in use
  std::vector<SymmetricFactor> factors_{};  // of the diagonal blocks, in order of elimination
};

}  // namespace handhold::realtime
