#include "realtime/block_system.hpp"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "realtime/small_solve.hpp"

namespace handhold::realtime {
namespace {

Matrix6 random_block(std::mt19937& random) {
  std::uniform_real_distribution<double> in(-1, 1);
  return Matrix6::NullaryExpr([&] { return in(random); });
}

/// Random couplings, not symmetric in value; Eigen's dense LU with pivots says what the solution is.
TEST(BlockSystem, SolvesWhatDenseEliminationSolves) {
  std::mt19937 random(3);
  for (const int rows : {2, 5, 17}) {
    BlockSystem system;
    system.reserve(20);
    system.begin(rows);
    std::vector<std::pair<int, int>> couplings;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < i; ++j)
        if (j == i - 1 || random() % 4 == 0) couplings.emplace_back(i, j);
    for (const auto& [i, j] : couplings) system.couple(i, j);
    system.analyse();
    system.clear();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6 * rows, 6 * rows);
    Eigen::VectorXd b(6 * rows);
    std::vector<Vector6> x(std::size_t(rows), Vector6::Zero());
    for (int i = 0; i < rows; ++i) {
      system.block(i, i) = random_block(random) + 20 * rows * Matrix6::Identity();
      A.block<6, 6>(6 * i, 6 * i) = system.block(i, i);
      x[std::size_t(i)] = random_block(random).col(0);
      b.segment<6>(6 * i) = x[std::size_t(i)];
    }
    for (const auto& [i, j] : couplings) {
      system.block(i, j) = random_block(random);
      system.block(j, i) = random_block(random);
      A.block<6, 6>(6 * i, 6 * j) = system.block(i, j);
      A.block<6, 6>(6 * j, 6 * i) = system.block(j, i);
    }
    const Eigen::VectorXd truth = A.partialPivLu().solve(b);
    system.solve(x);
    for (int i = 0; i < rows; ++i)
      EXPECT_LT((x[std::size_t(i)] - truth.segment<6>(6 * i)).norm(), 1e-14) << rows;  // rounding, |x| is 0.01
  }
}

TEST(SmallSolve, InvertsAndSolvesPositiveDefiniteMatrices) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const Matrix6 B = random_block(random);
    const Matrix6 A = B * B.transpose() + 0.1 * Matrix6::Identity();
    const Vector6 b = random_block(random).col(2);
    EXPECT_LT((A * solve_symmetric(A, b) - b).norm(), 1e-13);  // condition up to 100
    EXPECT_LT((A * inverse_of(A) - Matrix6::Identity()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace handhold::realtime
