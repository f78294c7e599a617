// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

#include <Eigen/Core>

#include "realtime/soa.hpp"

// Two of everything, in the vector registers of the least machine. Plain IEEE arithmetic in a fixed order: the same
// bits at every level of optimisation.

namespace handhold::realtime {

using Lanes = double __attribute__((vector_size(2 * sizeof(double))));
constexpr int lanes = 2;

[[gnu::always_inline]] inline Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
[[gnu::always_inline]] inline void store(double* p, Lanes v) { std::memcpy(p, &v, sizeof v); }
[[gnu::always_inline]] inline Lanes both(double s) { return Lanes{s, s}; }
[[gnu::always_inline]] inline double total(Lanes v) { return v[0] + v[1]; }

struct Lanes3 {
  Lanes x, y, z;
};

[[gnu::always_inline]] inline Lanes3 load(const Vector3Array& a, std::size_t i) {
  return {load(a.x() + i), load(a.y() + i), load(a.z() + i)};
}
[[gnu::always_inline]] inline void store(Vector3Array& a, std::size_t i, const Lanes3& v) {
  store(a.x() + i, v.x);
  store(a.y() + i, v.y);
  store(a.z() + i, v.z);
}
/// A lane each.
[[gnu::always_inline]] inline Lanes3 gather(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {Lanes{a.x(), b.x()}, Lanes{a.y(), b.y()}, Lanes{a.z(), b.z()}};
}
[[gnu::always_inline]] inline Lanes3 both(const Eigen::Vector3d& a) { return {both(a.x()), both(a.y()), both(a.z())}; }
[[gnu::always_inline]] inline Eigen::Vector3d total(const Lanes3& v) { return {total(v.x), total(v.y), total(v.z)}; }

[[gnu::always_inline]] inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Lanes3 operator*(Lanes s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
[[gnu::always_inline]] inline Lanes3 operator*(double s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
[[gnu::always_inline]] inline Lanes3& operator+=(Lanes3& a, const Lanes3& b) { return a = a + b; }
[[gnu::always_inline]] inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[gnu::always_inline]] inline Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// By rows: A v is three dot products, A Bᵀ nine.
struct LaneMatrix {
  Lanes3 row[3];
};

[[gnu::always_inline]] inline LaneMatrix gather(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  LaneMatrix m;
  for (int i = 0; i < 3; ++i) m.row[i] = {Lanes{a(i, 0), b(i, 0)}, Lanes{a(i, 1), b(i, 1)}, Lanes{a(i, 2), b(i, 2)}};
  return m;
}
[[gnu::always_inline]] inline LaneMatrix both(const Eigen::Matrix3d& a) { return gather(a, a); }
[[gnu::always_inline]] inline Lanes3 operator*(const LaneMatrix& A, const Lanes3& v) {
  return {dot(A.row[0], v), dot(A.row[1], v), dot(A.row[2], v)};
}
[[gnu::always_inline]] inline LaneMatrix operator+(const LaneMatrix& A, const LaneMatrix& B) {
  return {A.row[0] + B.row[0], A.row[1] + B.row[1], A.row[2] + B.row[2]};
}
[[gnu::always_inline]] inline LaneMatrix operator-(const LaneMatrix& A, const LaneMatrix& B) {
  return {A.row[0] - B.row[0], A.row[1] - B.row[1], A.row[2] - B.row[2]};
}
[[gnu::always_inline]] inline LaneMatrix operator*(Lanes s, const LaneMatrix& A) {
  return {s * A.row[0], s * A.row[1], s * A.row[2]};
}
/// A Bᵀ.
[[gnu::always_inline]] inline LaneMatrix times_transposed(const LaneMatrix& A, const LaneMatrix& B) {
  return {B * A.row[0], B * A.row[1], B * A.row[2]};
}
[[gnu::always_inline]] inline LaneMatrix operator*(const LaneMatrix& A, const LaneMatrix& B) {
  LaneMatrix C;
  for (int i = 0; i < 3; ++i) C.row[i] = A.row[i].x * B.row[0] + A.row[i].y * B.row[1] + A.row[i].z * B.row[2];
  return C;
}
/// Σ A_ij B_ij.
[[gnu::always_inline]] inline Lanes inner(const LaneMatrix& A, const LaneMatrix& B) {
  return dot(A.row[0], B.row[0]) + dot(A.row[1], B.row[1]) + dot(A.row[2], B.row[2]);
}
[[gnu::always_inline]] inline LaneMatrix transposed(const LaneMatrix& A) {
  return {{{A.row[0].x, A.row[1].x, A.row[2].x},
           {A.row[0].y, A.row[1].y, A.row[2].y},
           {A.row[0].z, A.row[1].z, A.row[2].z}}};
}
/// Σ x × y of Σ x yᵀ.
[[gnu::always_inline]] inline Lanes3 axial(const LaneMatrix& A) {
  return {A.row[1].z - A.row[2].y, A.row[2].x - A.row[0].z, A.row[0].y - A.row[1].x};
}

}  // namespace handhold::realtime
