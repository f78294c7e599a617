#include "realtime/block_system.hpp"

#include <algorithm>

#include "realtime/small_solve.hpp"

namespace handhold::realtime {

void BlockSystem::reserve(int rows) {
  const std::size_t n = std::size_t(rows);
  blocks_.resize(n * n);
  linked_.resize(n * n);
  order_.reserve(n);
  degree_.reserve(n);
  later_.reserve(n * n);
  later_start_.reserve(n + 1);
}

void BlockSystem::begin(int rows) {
  rows_ = rows;
  std::fill_n(linked_.begin(), std::size_t(rows) * std::size_t(rows), std::uint8_t(0));
}

void BlockSystem::couple(int i, int j) { linked_[index(i, j)] = linked_[index(j, i)] = 1; }

void BlockSystem::analyse() {
  constexpr int done = -1;
  order_.clear();
  later_.clear();
  later_start_.assign(1, 0);
  degree_.assign(std::size_t(rows_), 0);
  for (int i = 0; i < rows_; ++i) degree_[i] = int(std::count(&linked_[index(i, 0)], &linked_[index(i, 0)] + rows_, 1));
  for (int step = 0; step < rows_; ++step) {
    int row = done;
    for (int i = 0; i < rows_; ++i)
      if (degree_[i] != done && (row == done || degree_[i] < degree_[row])) row = i;
    const std::size_t first = later_.size();
    for (int j = 0; j < rows_; ++j)
      if (linked_[index(row, j)] && degree_[j] != done) later_.push_back(j);
    degree_[row] = done;
    order_.push_back(row);
    later_start_.push_back(int(later_.size()));
    // Its neighbours become neighbours of each other.
    for (std::size_t a = first; a < later_.size(); ++a) {
      --degree_[later_[a]];
      for (std::size_t b = a + 1; b < later_.size(); ++b) {
        if (linked_[index(later_[a], later_[b])]) continue;
        couple(later_[a], later_[b]);
        ++degree_[later_[a]];
        ++degree_[later_[b]];
      }
    }
  }
}

void BlockSystem::clear() {
  for (int i = 0; i < rows_; ++i)
    for (int j = 0; j < rows_; ++j)
      if (i == j || linked_[index(i, j)]) blocks_[index(i, j)].setZero();
}

void BlockSystem::solve(std::vector<Vector6>& b) {
  for (int step = 0; step < rows_; ++step) {
    const int k = order_[step];
    const Matrix6 inverse = inverse_of(block(k, k));
    block(k, k) = inverse;
    for (int at = later_start_[step]; at < later_start_[step + 1]; ++at) {
      const int i = later_[at];
      const Matrix6 factor = block(i, k) * inverse;
      b[i].noalias() -= factor * b[k];
      for (int to = later_start_[step]; to < later_start_[step + 1]; ++to)
        block(i, later_[to]).noalias() -= factor * block(k, later_[to]);
    }
  }
  for (int step = rows_ - 1; step >= 0; --step) {
    const int k = order_[step];
    Vector6 right = b[k];
    for (int at = later_start_[step]; at < later_start_[step + 1]; ++at)
      right.noalias() -= block(k, later_[at]) * b[later_[at]];
    b[k].noalias() = block(k, k) * right;
  }
}

}  // namespace handhold::realtime
