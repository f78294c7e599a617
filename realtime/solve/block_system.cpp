// SPDX-License-Identifier: Apache-2.0
#include "realtime/solve/block_system.hpp"

#include <algorithm>
#include <bit>

#include <Eigen/Geometry>

#include "realtime/solve/lanes.hpp"
#include "realtime/solve/small_solve.hpp"

namespace handhold::realtime {
namespace {

constexpr int word_bits = 64;
constexpr int done = -1;  // degree of a row that is eliminated

int words_for(int rows) { return (rows + word_bits - 1) / word_bits; }

enum class Right { as_is, transposed };

/// C -= A B, or A Bᵀ. Two columns at a time, so that they and one of A stay in registers: elimination is nothing else.
template <Right right>
void subtract_product(const Matrix6& A, const Matrix6& B, Matrix6& C) {
  for (int j = 0; j < 6; j += 2) {
    double *c = C.data() + 6 * j, *d = c + 6;
    Lanes c0 = load(c), c2 = load(c + 2), c4 = load(c + 4), d0 = load(d), d2 = load(d + 2), d4 = load(d + 4);
    for (int k = 0; k < 6; ++k) {
      const double* a = A.data() + 6 * k;
      const Lanes a0 = load(a), a2 = load(a + 2), a4 = load(a + 4);
      const double p = right == Right::as_is ? B(k, j) : B(j, k), q = right == Right::as_is ? B(k, j + 1) : B(j + 1, k);
      c0 -= a0 * p, c2 -= a2 * p, c4 -= a4 * p;
      d0 -= a0 * q, d2 -= a2 * q, d4 -= a4 * q;
    }
    store(c, c0), store(c + 2, c2), store(c + 4, c4);
    store(d, d0), store(d + 2, d2), store(d + 4, d4);
  }
}

/// A T.
Matrix6 from_source(const Matrix6& A, const Eigen::Vector3d& r) {
  Matrix6 B = A;
  B.col(3) += r.y() * A.col(2) - r.z() * A.col(1);
  B.col(4) += r.z() * A.col(0) - r.x() * A.col(2);
  B.col(5) += r.x() * A.col(1) - r.y() * A.col(0);
  return B;
}

/// B -= sign Tᵀ A.
template <int sign>
void subtract_at_source(const Matrix6& A, const Eigen::Vector3d& r, Matrix6& B) {
  for (int j = 0; j < 6; ++j) {
    const Eigen::Vector3d force = A.col(j).head<3>();
    const Eigen::Vector3d torque = A.col(j).tail<3>() + r.cross(force);
    B.col(j).head<3>() -= sign * force;
    B.col(j).tail<3>() -= sign * torque;
  }
}

void put(std::uint64_t* set, int i) { set[i / word_bits] |= std::uint64_t(1) << i % word_bits; }
void take(std::uint64_t* set, int i) { set[i / word_bits] &= ~(std::uint64_t(1) << i % word_bits); }

}  // namespace

void BlockSystem::reserve(int rows) {
  const std::size_t n = std::size_t(rows);
  blocks_.resize(n * n);
  slots_.resize(n * n);
  factors_.resize(n);
  for (std::vector<Word>* sets : {&couplings_, &analysed_, &linked_}) sets->resize(n * std::size_t(words_for(rows)));
  for (std::vector<int>* list : {&order_, &place_, &degree_, &later_start_}) list->reserve(n + 1);
  later_.reserve(n * n / 2);
}

void BlockSystem::begin(int rows) {
  rows_ = rows;
  words_ = words_for(rows);
  std::fill_n(couplings_.begin(), rows * words_, Word(0));
}

void BlockSystem::couple(int i, int j) {
  put(set_of(couplings_, i), j);
  put(set_of(couplings_, j), i);
}

void BlockSystem::analyse() {
  const auto end = couplings_.begin() + rows_ * words_;
  if (rows_ == analysed_rows_ && std::equal(couplings_.begin(), end, analysed_.begin())) return;
  analysed_rows_ = rows_;
  std::copy(couplings_.begin(), end, analysed_.begin());
  std::copy(couplings_.begin(), end, linked_.begin());
  order_rows();
  place_blocks();
}

void BlockSystem::order_rows() {
  order_.clear();
  later_.clear();
  later_start_.assign(1, 0);
  place_.resize(std::size_t(rows_));
  degree_.resize(std::size_t(rows_));
  const auto count = [&](int i) {
    const Word* set = set_of(linked_, i);
    int sum = 0;
    for (int w = 0; w < words_; ++w) sum += std::popcount(set[w]);
    return sum;
  };
  for (int i = 0; i < rows_; ++i) degree_[i] = count(i);
  for (int step = 0; step < rows_; ++step) {
    int row = done;
    for (int i = 0; i < rows_; ++i)
      if (degree_[i] != done && (row == done || degree_[i] < degree_[row])) row = i;
    degree_[row] = done;
    place_[row] = step;
    order_.push_back(row);
    const std::size_t first = later_.size();
    const Word* links = set_of(linked_, row);
    for (int w = 0; w < words_; ++w)
      for (Word left = links[w]; left != 0; left &= left - 1) later_.push_back(w * word_bits + std::countr_zero(left));
    later_start_.push_back(int(later_.size()));
    // Its neighbours become neighbours of each other.
    for (std::size_t at = first; at < later_.size(); ++at) {
      Word* set = set_of(linked_, later_[at]);
      for (int w = 0; w < words_; ++w) set[w] |= links[w];
      take(set, later_[at]);
      take(set, row);
      degree_[later_[at]] = count(later_[at]);
    }
  }
}

void BlockSystem::place_blocks() {
  const std::size_t n = std::size_t(rows_), pairs = later_.size();
  for (int step = 0; step < rows_; ++step) {
    const int k = order_[step];
    slots_[index(k, k)] = std::uint32_t(step);
    const auto first = later_.begin() + later_start_[step], last = later_.begin() + later_start_[step + 1];
    std::sort(first, last, [&](int i, int j) { return place_[i] < place_[j]; });
    for (auto at = first; at != last; ++at) {
      const std::size_t entry = n + std::size_t(at - later_.begin());
      slots_[index(*at, k)] = std::uint32_t(entry);
      slots_[index(k, *at)] = std::uint32_t(entry + pairs);
    }
  }
}

void BlockSystem::clear(bool symmetric) {
  symmetric_ = symmetric;
  std::fill_n(blocks_.begin(), order_.size() + (symmetric ? 1 : 2) * later_.size(), Matrix6::Zero());
}

void BlockSystem::add_contact(int target, int source, const Eigen::Vector3d& offset, const Matrix6& S) {
  if (target >= 0) block(target, target) += S;
  if (source < 0) return;
  const Matrix6 ST = from_source(S, offset);
  subtract_at_source<-1>(ST, offset, block(source, source));
  if (target < 0) return;
  const bool target_first = place_[target] < place_[source];
  if (!symmetric_ || !target_first) block(target, source) -= ST;
  if (!symmetric_ || target_first) subtract_at_source<1>(S, offset, block(source, target));
}

void BlockSystem::solve(std::vector<Vector6>& b) { symmetric_ ? solve_ldl(b) : solve_lu(b); }

void BlockSystem::solve_lu(std::vector<Vector6>& b) {
  const std::size_t n = std::size_t(rows_), pairs = later_.size();
  for (int step = 0; step < rows_; ++step) {
    const int k = order_[step], first = later_start_[step], last = later_start_[step + 1];
    const Matrix6 inverse = inverse_of(blocks_[step]);
    blocks_[step] = inverse;
    for (int at = first; at < last; ++at) {
      const int i = later_[at];
      const Matrix6 factor = blocks_[n + at] * inverse;
      b[i].noalias() -= factor * b[k];
      for (int to = first; to < last; ++to)
        subtract_product<Right::as_is>(factor, blocks_[n + pairs + to], block(i, later_[to]));
    }
  }
  for (int step = rows_ - 1; step >= 0; --step) {
    const int k = order_[step];
    Vector6 right = b[k];
    for (int at = later_start_[step]; at < later_start_[step + 1]; ++at)
      right.noalias() -= blocks_[n + pairs + at] * b[later_[at]];
    b[k].noalias() = blocks_[step] * right;
  }
}

/// A = L D Lᵀ. Blocks below the diagonal become those of L D, those above it L's own.
void BlockSystem::solve_ldl(std::vector<Vector6>& b) {
  const std::size_t n = std::size_t(rows_), pairs = later_.size();
  for (int step = 0; step < rows_; ++step) {
    const int k = order_[step], first = later_start_[step], last = later_start_[step + 1];
    SymmetricFactor& diagonal = factors_[step];
    diagonal.factor(blocks_[step]);
    diagonal.forward(b[k]);
    for (int at = first; at < last; ++at) {
      const int i = later_[at];
      Matrix6 &below = blocks_[n + at], &scaled = blocks_[n + pairs + at];
      diagonal.forward_right(below);
      scaled = below * diagonal.inverse.asDiagonal();
      for (int to = first; to < at; ++to)
        subtract_product<Right::transposed>(scaled, blocks_[n + to], block(i, later_[to]));
      subtract_product<Right::transposed>(scaled, below, blocks_[place_[i]]);
      b[i].noalias() -= scaled * b[k];
    }
    b[k].array() *= diagonal.inverse.array();
  }
  for (int step = rows_ - 1; step >= 0; --step) {
    const int k = order_[step];
    for (int at = later_start_[step]; at < later_start_[step + 1]; ++at)
      b[k].noalias() -= blocks_[n + pairs + at].transpose() * b[later_[at]];
    factors_[step].backward(b[k]);
  }
}

}  // namespace handhold::realtime
