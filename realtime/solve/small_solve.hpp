// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// A = L D Lᵀ without pivots, of a symmetric positive definite A of which the lower triangle is read.
struct SymmetricFactor {
  Matrix6 L{Matrix6::Zero()};        ///< below the diagonal; its diagonal is 1
  Vector6 inverse{Vector6::Zero()};  ///< of D

  void factor(const Matrix6& A) {
    Vector6 D;
    for (int j = 0; j < 6; ++j) {
      double scaled[6];
      D[j] = A(j, j);
      for (int k = 0; k < j; ++k) {
        scaled[k] = L(j, k) * D[k];
        D[j] -= L(j, k) * scaled[k];
      }
      inverse[j] = 1 / D[j];
      for (int i = j + 1; i < 6; ++i) {
        double sum = A(i, j);
        for (int k = 0; k < j; ++k) sum -= L(i, k) * scaled[k];
        L(i, j) = sum * inverse[j];
      }
    }
  }
  /// x becomes L⁻¹ x.
  void forward(Vector6& x) const {
    for (int j = 0; j < 6; ++j)
      for (int i = j + 1; i < 6; ++i) x[i] -= L(i, j) * x[j];
  }
  /// B becomes B L⁻ᵀ.
  void forward_right(Matrix6& B) const {
    for (int j = 0; j < 6; ++j)
      for (int i = j + 1; i < 6; ++i) B.col(i) -= L(i, j) * B.col(j);
  }
  /// x becomes L⁻ᵀ x.
  void backward(Vector6& x) const {
    for (int i = 5; i >= 0; --i)
      for (int k = i + 1; k < 6; ++k) x[i] -= L(k, i) * x[k];
  }
};

/// Solves A x = b for a symmetric positive definite A, of which the lower triangle is read.
[[nodiscard]] inline Vector6 solve_symmetric(const Matrix6& A, const Vector6& b) {
  SymmetricFactor of_A;
  of_A.factor(A);
  Vector6 x = b;
  of_A.forward(x);
  x.array() *= of_A.inverse.array();
  of_A.backward(x);
  return x;
}

/// Inverse by Gauss and Jordan without pivots: of masses plus what contacts add to them. With friction that slides its
/// symmetric part need not be definite; what is lost then is seen in the residual of the next Newton step. Unrolled, or
/// its loads would wait for its stores.
[[nodiscard]] inline Matrix6 inverse_of(Matrix6 A) {
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const double pivot = 1 / A(k, k);
    Vector6 column = A.col(k);
    column[k] = -1;
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
      if (j == k) continue;
      const double right = A(k, j) * pivot;
      A(k, j) = 0;
      A.col(j) -= right * column;
    }
    A.col(k) = -pivot * column;
  }
  return A;
}

}  // namespace handhold::realtime
