#include "realtime/patch_kernel.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "realtime/lanes.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const StickMoments none{};

/// StickSums, but for the last addition.
struct LaneSums {
  Lanes count{}, power{}, squared_v{};
  Lanes3 arm{}, square{}, mixed{}, force{}, torque{}, v{}, arm_v{}, size{};
};

/// Adds two patches, a lane each. Every sum is that of the mean plus that about the mean: q = R (p − mean),
/// d = q − R_O (C − mean), f = U (k d + ahead W q).
[[gnu::always_inline]] inline void add(const PatchMotion& m0, const PatchMotion& m1, const StickMoments& s0,
                                       const StickMoments& s1, const Stiffness& stiffness, const BodyStep& target,
                                       LaneSums& sums) {
  const LaneMatrix R = gather(m0.R, m1.R), W = gather(m0.W, m1.W), R_O = both(target.R);
  const Lanes n{s0.count, s1.count};
  const Lanes3 x = R * gather(s0.p, s1.p), a = x + gather(m0.t, m1.t);
  const Lanes3 r = a + (both(target.arm_O) - R_O * gather(s0.C, s1.C));
  Lanes3 v = W * x + gather(m0.u, m1.u);
  Lanes3 f = stiffness.k * r + stiffness.ahead * v;
  const LaneMatrix qq = times_transposed(R * gather(s0.pp, s1.pp), R);
  const LaneMatrix qd = qq - times_transposed(R * gather(s0.pC, s1.pC), R_O);
  const LaneMatrix Wq_q = W * qq;
  const Lanes squared = inner(W, Wq_q);
  const Lanes power = stiffness.k * inner(W, transposed(qd)) + stiffness.ahead * squared;
  LaneMatrix v_q = Wq_q;
  LaneMatrix d_q = transposed(qd);
  if (target.turned) {
    const LaneMatrix U = both(target.turn);
    v = U * v;
    f = U * f;
    v_q = U * v_q;
    d_q = U * d_q;
  }
  const Lanes3 q_v = axial(v_q), q_d = axial(d_q);  // Σ v × q, Σ d × q
  const Lanes3 nf = n * f, nv = n * v, na = n * a;
  sums.count += n;
  sums.arm += na;
  sums.square += Lanes3{na.x * a.x, na.y * a.y, na.z * a.z} + Lanes3{qq.row[0].x, qq.row[1].y, qq.row[2].z};
  sums.mixed += Lanes3{na.y * a.z, na.z * a.x, na.x * a.y} + Lanes3{qq.row[1].z, qq.row[2].x, qq.row[0].y};
  sums.force += nf;
  sums.torque += cross(a, nf) - (stiffness.k * q_d + stiffness.ahead * q_v);
  sums.v += nv;
  sums.arm_v += cross(a, nv) - q_v;
  sums.power += dot(nf, v) + power;
  sums.squared_v += dot(nv, v) + squared;
  const auto magnitude = [](Lanes y) { return y < 0 ? -y : y; };
  sums.size += Lanes3{magnitude(nf.x), magnitude(nf.y), magnitude(nf.z)};
}

}  // namespace

SampleStep sample_step(const PatchMotion& motion, const BodyStep& target, double lead, const Contacts& contacts,
                       std::size_t slot) {
  SampleStep s;
  const Vector3d x = motion.R * contacts.p_P[slot];
  s.arm = x + motion.t;
  s.v = motion.W * x + motion.u;
  s.reach = s.arm + (target.arm_O - target.R * contacts.C_O[slot]) + lead * s.v;
  s.n = target.R * contacts.n_O[slot];
  if (!target.turned) return s;
  for (Vector3d* turned : {&s.v, &s.reach, &s.n}) *turned = Vector3d(target.turn * *turned);
  return s;
}

void update(const PatchSlot& patch, const Contacts& contacts, const std::vector<Role>& role, StickMoments& moments) {
  if (!moments.stale) return;
  moments = {};
  moments.stale = false;
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    const bool linear = role[slot] == Role::linear;
    if (linear != (contacts.mode[slot] == Mode::stick)) moments.stale = true;  // it will not be so in the next step
    if (!linear) continue;
    ++moments.count;
    moments.p += contacts.p_P[slot];
    moments.C += contacts.C_O[slot];
  }
  if (moments.count == 0) return;
  moments.p /= moments.count;
  moments.C /= moments.count;
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    if (role[slot] != Role::linear) continue;
    const Vector3d p = contacts.p_P[slot] - moments.p, C = contacts.C_O[slot] - moments.C;
    moments.pp += p * p.transpose();
    moments.pC += p * C.transpose();
  }
}

StickSums sum_sticking(const SlotStep* begin, const SlotStep* end, const Stiffness& stiffness, const BodyStep& target,
                       const std::vector<StickMoments>& moments) {
  LaneSums lane;
  const auto of = [&](const SlotStep& step) -> const StickMoments& { return moments[std::size_t(step.patch)]; };
  const auto next = [&](const SlotStep* at) {
    return std::find_if(at, end, [&](const SlotStep& s) { return of(s).count > 0; });
  };
  for (const SlotStep* first = next(begin); first != end;) {
    const SlotStep* const second = next(first + 1);
    const bool alone = second == end;
    add(first->motion, alone ? first->motion : second->motion, of(*first), alone ? none : of(*second), stiffness,
        target, lane);
    first = alone ? end : next(second + 1);
  }
  const Vector3d s = total(lane.square), m = total(lane.mixed);
  StickSums sums;
  sums.count = total(lane.count);
  sums.arm = total(lane.arm);
  sums.arm_arm << s.x(), m.z(), m.y(), m.z(), s.y(), m.x(), m.y(), m.x(), s.z();
  sums.force = total(lane.force);
  sums.torque = total(lane.torque);
  sums.v = total(lane.v);
  sums.arm_v = total(lane.arm_v);
  sums.power = total(lane.power);
  sums.squared_v = total(lane.squared_v);
  sums.size = total(lane.size).sum();
  return sums;
}

StickResult result_of(const StickSums& sums, const Stiffness& stiffness, const Vector3d& dv, const Vector3d& dw) {
  const double s = stiffness.slope;
  const Vector3d shift = sums.count * dv + dw.cross(sums.arm);                                // Σ δ
  const Vector3d twist = sums.arm.cross(dv) + sums.arm_arm.trace() * dw - sums.arm_arm * dw;  // Σ a × δ
  StickResult r;
  r.force = sums.force - s * shift;
  r.torque = sums.torque - s * twist;
  const double force = dv.dot(sums.force) + dw.dot(sums.torque);  // Σ f·δ
  const double v = dv.dot(sums.v) + dw.dot(sums.arm_v);           // Σ v·δ
  const double squared = dv.dot(shift) + dw.dot(twist);           // Σ |δ|²
  r.power = sums.power - force - s * v + s * squared;
  r.squared_v = std::max(sums.squared_v - 2 * v + squared, 0.0);  // rounding may leave less than nothing
  return r;
}

bool evaluate_sticking(const SlotStep& step, const Stiffness& stiffness, double mu_static, const Vector3d& dv,
                       const Vector3d& dw, const BodyStep& target, const std::vector<Role>& role,
                       const StickMoments& moments, Contacts& contacts) {
  // f = A p + b − k C in the body's frame.
  const PatchMotion& m = step.motion;
  Matrix3d E = stiffness.ahead * m.W;
  E.diagonal().array() += stiffness.k;
  Vector3d e = stiffness.k * (m.t + target.arm_O) + stiffness.ahead * m.u;
  Matrix3d R = target.R;
  if (target.turned) {
    E = Matrix3d(target.turn * E);
    e = Vector3d(target.turn * e);
    R = Matrix3d(target.turn * R);
  }
  const Vector3d w = stiffness.slope * dw;
  E(0, 1) += w.z();
  E(0, 2) -= w.y();
  E(1, 0) -= w.z();
  E(1, 2) += w.x();
  E(2, 0) += w.y();
  E(2, 1) -= w.x();
  e -= stiffness.slope * dv + w.cross(m.t);
  const Matrix3d ER = E * m.R;
  const Matrix3d A_O = R.transpose() * ER;
  const Vector3d b_O = R.transpose() * e;
  const LaneMatrix A = both(A_O);
  const Lanes3 b = both(b_O);
  const PatchSlot& patch = contacts.patches[std::size_t(step.patch)];
  const bool all = moments.count == patch.count;
  const Lanes zero{};
  auto outside = zero < zero;
  for (std::size_t i = patch.slot(0), end = patch.slot(patch.count); i < end; i += lanes) {
    const Lanes3 n = load(contacts.n_O, i);
    Lanes3 f = A * load(contacts.p_P, i) + b - stiffness.k * load(contacts.C_O, i);
    const Lanes N = zero - dot(f, n);
    const Lanes3 t = f + N * n;
    const Lanes cap = mu_static * N;
    auto fails = (N <= zero) | (dot(t, t) > cap * cap);
    if (!all || i + 1 == end) {
      const bool first = role[i] == Role::linear, second = i + 1 < end && role[i + 1] == Role::linear;
      if (!first && !second) continue;
      const Lanes weight{first ? 1.0 : 0.0, second ? 1.0 : 0.0};
      f = weight * f;
      fails &= weight != zero;
    }
    outside |= fails;
    store(contacts.f_O, i, f);
  }
  return !outside[0] && !outside[1];
}

}  // namespace handhold::realtime
