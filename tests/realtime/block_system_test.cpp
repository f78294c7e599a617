// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/solve/block_system.hpp"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "realtime/solve/small_solve.hpp"

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

/// A symmetric and diagonally dominant, so positive definite, system of `rows` rows with couplings between neighbours
/// and some others.
struct Symmetric {
  std::vector<std::pair<int, int>> couplings{};
  Eigen::MatrixXd A{};
  std::vector<Vector6> b{};

  Symmetric(int rows, unsigned every, std::mt19937& random) {
    A = Eigen::MatrixXd::Zero(6 * rows, 6 * rows);
    for (int i = 0; i < rows; ++i) {
      const Matrix6 B = random_block(random);
      A.block<6, 6>(6 * i, 6 * i) = B + B.transpose() + 20 * rows * Matrix6::Identity();
      b.push_back(random_block(random).col(0));
      for (int j = 0; j < i; ++j) {
        if (j != i - 1 && random() % every != 0) continue;
        couplings.emplace_back(i, j);
        A.block<6, 6>(6 * i, 6 * j) = random_block(random);
        A.block<6, 6>(6 * j, 6 * i) = A.block<6, 6>(6 * i, 6 * j).transpose();
      }
    }
  }

  double error(BlockSystem& system, bool symmetric) const {
    const int rows = int(b.size());
    system.begin(rows);
    for (const auto& [i, j] : couplings) system.couple(i, j);
    system.analyse();
    system.clear(symmetric);
    for (int i = 0; i < rows; ++i) system.block(i, i) = A.block<6, 6>(6 * i, 6 * i);
    for (const auto& [i, j] : couplings) {
      system.block(i, j) = A.block<6, 6>(6 * i, 6 * j);
      system.block(j, i) = A.block<6, 6>(6 * j, 6 * i);
    }
    std::vector<Vector6> x = b;
    system.solve(x);
    Eigen::VectorXd right(6 * rows), found(6 * rows);
    for (int i = 0; i < rows; ++i) {
      right.segment<6>(6 * i) = b[std::size_t(i)];
      found.segment<6>(6 * i) = x[std::size_t(i)];
    }
    return (A.llt().solve(right) - found).norm();
  }
};

/// Eigen's dense Cholesky factorisation says what the solution is. 70 rows: sets of rows of more than one word.
TEST(BlockSystem, SolvesSymmetricSystemsByTheLowerBlocks) {
  std::mt19937 random(5);
  BlockSystem system;
  system.reserve(70);
  for (const int rows : {2, 5, 17, 70})
    EXPECT_LT(Symmetric(rows, 8, random).error(system, true), 1e-14) << rows;  // rounding, |x| is at most 0.05
}

/// The order of elimination is kept for the same couplings, and only for them.
TEST(BlockSystem, NoticesOtherCouplings) {
  std::mt19937 random(9);
  BlockSystem system;
  system.reserve(12);
  const Symmetric sparse(12, 1000, random), dense(12, 2, random), small(7, 2, random);
  for (const Symmetric* one : {&sparse, &sparse, &dense, &sparse, &small, &dense, &small})
    for (const bool symmetric : {false, true}) EXPECT_LT(one->error(system, symmetric), 1e-14);
}

/// Against the products of the definition, T made of what it does to unit velocities.
TEST(BlockSystem, PutsAContactWhereItsBodiesAre) {
  std::mt19937 random(11);
  const Eigen::Vector3d offset = random_block(random).col(0).head<3>();
  const Matrix6 S = random_block(random);
  Matrix6 T;
  for (int j = 0; j < 6; ++j) {
    const Vector6 u = Vector6::Unit(j);
    const Eigen::Vector3d v = u.head<3>(), w = u.tail<3>();
    T.col(j) << v + w.cross(offset), w;  // velocity at the target's centre
  }
  for (const auto& [target, source] : {std::pair(0, 1), std::pair(1, 0), std::pair(-1, 0), std::pair(1, -1)}) {
    BlockSystem system;
    system.reserve(2);
    system.begin(2);
    system.couple(0, 1);
    system.analyse();
    system.clear();
    system.add_contact(target, source, offset, S);
    const int t = target < 0 ? 1 - source : target, s = 1 - t;
    const bool moves_t = target >= 0, moves_s = source >= 0;
    const Matrix6 zero = Matrix6::Zero(), ST = S * T, TS = T.transpose() * S, TST = T.transpose() * ST;
    const auto same = [](const Matrix6& A, const Matrix6& B) { return (A - B).norm() < 1e-14; };  // rounding
    EXPECT_TRUE(same(system.block(t, t), moves_t ? S : zero));
    EXPECT_TRUE(same(system.block(s, s), moves_s ? TST : zero));
    EXPECT_TRUE(same(system.block(t, s), moves_t && moves_s ? Matrix6(-ST) : zero));
    EXPECT_TRUE(same(system.block(s, t), moves_t && moves_s ? Matrix6(-TS) : zero));
  }
}

/// A ring of bodies of mass 1, with contacts in both directions: half of the blocks say the same as all of them.
TEST(BlockSystem, NeedsOneBlockOfAContactIfItIsSymmetric) {
  std::mt19937 random(13);
  constexpr int rows = 6;
  BlockSystem system;
  system.reserve(rows);
  std::vector<Vector6> x[2];
  for (const bool symmetric : {false, true}) {
    random.seed(13);
    system.begin(rows);
    for (int i = 0; i < rows; ++i) system.couple(i, (i + 1) % rows);
    system.analyse();
    system.clear(symmetric);
    for (int i = 0; i < rows; ++i) {
      const int j = (i + 1) % rows;
      const Matrix6 B = random_block(random), S = B * B.transpose();
      const Eigen::Vector3d offset = random_block(random).col(0).head<3>();
      system.block(i, i) += Matrix6::Identity();
      system.add_contact(i, j, offset, S);
      system.add_contact(j, i, -offset, S);
      x[symmetric].push_back(random_block(random).col(1));
    }
    system.solve(x[symmetric]);
  }
  for (std::size_t i = 0; i < x[0].size(); ++i) EXPECT_LT((x[0][i] - x[1][i]).norm(), 1e-12);  // condition up to 100
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
