#include "realtime/patch_kernel.hpp"

#include <cstring>

namespace handhold::realtime {
namespace {

/// Two samples: a vector register of the least machine.
using Lanes = double __attribute__((vector_size(2 * sizeof(double))));
constexpr int lanes = 2;

[[gnu::always_inline]] inline Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
[[gnu::always_inline]] inline void store(double* p, Lanes v) { std::memcpy(p, &v, sizeof v); }
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

[[gnu::always_inline]] inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Lanes3 operator+(const Lanes3& a, const Eigen::Vector3d& b) {
  return {a.x + b.x(), a.y + b.y(), a.z + b.z()};
}
[[gnu::always_inline]] inline Lanes3 operator*(double s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
[[gnu::always_inline]] inline Lanes3 operator*(Lanes s, const Lanes3& a) { return {s * a.x, s * a.y, s * a.z}; }
[[gnu::always_inline]] inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[gnu::always_inline]] inline Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Lanes3 cross(const Eigen::Vector3d& a, const Lanes3& b) {
  return {a.y() * b.z - a.z() * b.y, a.z() * b.x - a.x() * b.z, a.x() * b.y - a.y() * b.x};
}
[[gnu::always_inline]] inline Lanes3 operator*(const Eigen::Matrix3d& A, const Lanes3& v) {
  return {A(0, 0) * v.x + A(0, 1) * v.y + A(0, 2) * v.z, A(1, 0) * v.x + A(1, 1) * v.y + A(1, 2) * v.z,
          A(2, 0) * v.x + A(2, 1) * v.y + A(2, 2) * v.z};
}
[[gnu::always_inline]] inline Eigen::Vector3d total(const Lanes3& v) { return {total(v.x), total(v.y), total(v.z)}; }

}  // namespace

void SampleSteps::resize(std::size_t slots) {
  for (Vector3Array* array : {&arm, &reach, &v, &n}) array->resize(slots);
  linear.resize(slots);
  used.resize(slots);
}

void project(const PatchMotion& motion, const Contacts& contacts, const PatchSlot& patch, SampleSteps& samples) {
  for (std::size_t i = patch.slot(0), end = patch.slot(patch.count); i < end; i += lanes) {
    if (!samples.used[i] && !samples.used[i + 1]) continue;
    const Lanes3 p_P = load(contacts.p_P, i);
    store(samples.arm, i, motion.R_a * p_P + motion.t_a);
    store(samples.v, i, motion.R_v * p_P + motion.t_v);
    store(samples.reach, i, motion.R_r * p_P + motion.t_r - motion.R * load(contacts.C_O, i));
    store(samples.n, i, motion.R * load(contacts.n_O, i));
  }
}

StickSums sum_sticking(const PatchSlot& patch, const Stiffness& stiffness, const SampleSteps& samples) {
  Lanes count{};
  Lanes3 arm{}, force{}, torque{}, square{}, mixed{};
  for (std::size_t i = patch.slot(0), end = patch.slot(patch.count); i < end; i += lanes) {
    if (samples.linear[i] + samples.linear[i + 1] == 0) continue;
    const Lanes w = load(samples.linear.data() + i);
    const Lanes3 a = load(samples.arm, i), wa = w * a;
    const Lanes3 f = w * (stiffness.k * load(samples.reach, i) + stiffness.c * load(samples.v, i));
    count += w;
    arm = arm + wa;
    square = square + Lanes3{wa.x * a.x, wa.y * a.y, wa.z * a.z};
    mixed = mixed + Lanes3{wa.y * a.z, wa.z * a.x, wa.x * a.y};
    force = force + f;
    torque = torque + cross(a, f);
  }
  const Eigen::Vector3d s = total(square), m = total(mixed);
  StickSums sums;
  sums.count = total(count);
  sums.arm = total(arm);
  sums.arm_arm << s.x(), m.z(), m.y(), m.z(), s.y(), m.x(), m.y(), m.x(), s.z();
  sums.force = total(force);
  sums.torque = total(torque);
  return sums;
}

StickResult evaluate_sticking(const PatchSlot& patch, const Stiffness& stiffness, double mu_static,
                              const Eigen::Vector3d& dv, const Eigen::Vector3d& dw, const SampleSteps& samples,
                              Vector3Array& f_W) {
  const Lanes zero{};
  Lanes3 force{}, torque{};
  Lanes power{}, squared_v{};
  bool holds = true;
  for (std::size_t i = patch.slot(0), end = patch.slot(patch.count); i < end; i += lanes) {
    if (samples.linear[i] + samples.linear[i + 1] == 0) continue;
    const Lanes w = load(samples.linear.data() + i);
    const Lanes3 a = load(samples.arm, i), n = load(samples.n, i);
    const Lanes3 change = cross(dw, a) + dv, v0 = load(samples.v, i);
    const Lanes3 v = w * (v0 - change);
    const Lanes3 f = w * (stiffness.k * load(samples.reach, i) + stiffness.c * v0 - stiffness.slope * change);
    const Lanes N = zero - dot(f, n);
    const Lanes3 t = f + N * n;
    const Lanes cap = mu_static * N;
    const auto outside = (w != zero) & ((N <= zero) | (dot(t, t) > cap * cap));
    holds = holds && !outside[0] && !outside[1];
    store(f_W, i, f);
    force = force + f;
    torque = torque + cross(a, f);
    power += dot(f, v);
    squared_v += dot(v, v);
  }
  return {holds, total(force), total(torque), total(power), total(squared_v)};
}

}  // namespace handhold::realtime
