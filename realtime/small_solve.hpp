#pragma once

#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// Solves A x = b for a symmetric positive definite A, of which the lower triangle is read: A = L D Lᵀ without pivots.
[[nodiscard]] inline Vector6 solve_symmetric(const Matrix6& A, const Vector6& b) {
  double L[6][6], D[6], inverse[6];
  Vector6 x = b;
  for (int j = 0; j < 6; ++j) {
    double scaled[6];
    D[j] = A(j, j);
    for (int k = 0; k < j; ++k) {
      scaled[k] = L[j][k] * D[k];
      D[j] -= L[j][k] * scaled[k];
    }
    inverse[j] = 1 / D[j];
    for (int i = j + 1; i < 6; ++i) {
      double sum = A(i, j);
      for (int k = 0; k < j; ++k) sum -= L[i][k] * scaled[k];
      L[i][j] = sum * inverse[j];
      x[i] -= L[i][j] * x[j];
    }
  }
  for (int i = 5; i >= 0; --i) {
    x[i] *= inverse[i];
    for (int k = i + 1; k < 6; ++k) x[i] -= L[k][i] * x[k];
  }
  return x;
}

/// Inverse by Gauss and Jordan without pivots: of masses plus what contacts add to them, whose symmetric part is
/// positive definite.
[[nodiscard]] inline Matrix6 inverse_of(Matrix6 A) {
  for (int k = 0; k < 6; ++k) {
    const double pivot = 1 / A(k, k);
    Vector6 column = A.col(k);
    column[k] = -1;
    A.col(k).setZero();
    for (int j = 0; j < 6; ++j) {
      const double right = A(k, j) * pivot;
      A(k, j) = 0;
      A.col(j) -= right * column;
    }
    A.col(k) = -pivot * column;
  }
  return A;
}

}  // namespace handhold::realtime
