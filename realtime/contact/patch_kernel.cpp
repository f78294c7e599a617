// SPDX-License-Identifier: Apache-2.0
#include "realtime/contact/patch_kernel.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "realtime/solve/lanes.hpp"

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
/// d = q − R_O (C − mean), f = k d + ahead W q.
[[gnu::always_inline]] inline void add(const PatchMotion& m0, const PatchMotion& m1, const StickMoments& s0,
                                       const StickMoments& s1, const Stiffness& stiffness, const BodyStep& target,
                                       LaneSums& sums) {
  const LaneMatrix R = gather(m0.R, m1.R), W = gather(m0.W, m1.W), R_O = both(target.R);
  const Lanes n{s0.count, s1.count};
  const Lanes3 x = R * gather(s0.p, s1.p), a = x + gather(m0.t, m1.t);
  const Lanes3 r = a + (both(target.arm_O) - R_O * gather(s0.C, s1.C));
  const Lanes3 v = W * x + gather(m0.u, m1.u);
  const Lanes3 f = stiffness.k * r + stiffness.ahead * v;
  const LaneMatrix qq = times_transposed(R * gather(s0.pp, s1.pp), R);
  const LaneMatrix qd = qq - times_transposed(R * gather(s0.pC, s1.pC), R_O);
  const LaneMatrix Wq_q = W * qq;
  const Lanes squared = inner(W, Wq_q);
  const Lanes power = stiffness.k * inner(W, transposed(qd)) + stiffness.ahead * squared;
  const Lanes3 q_v = axial(Wq_q), q_d = axial(transposed(qd));  // Σ v × q, Σ d × q
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

/// Calls visit(patch, next patch or null) with the patches that have linear samples.
template <class Step, class Visit>
[[gnu::always_inline]] inline void in_pairs(Step* begin, Step* end, const std::vector<StickMoments>& moments,
                                            Visit&& visit) {
  Step* first = nullptr;
  for (Step* step = begin; step != end; ++step) {
    if (moments[std::size_t(step->patch)].count == 0) continue;
    if (!first) {
      first = step;
      continue;
    }
    visit(*first, step);
    first = nullptr;
  }
  if (first) visit(*first, static_cast<Step*>(nullptr));
}

/// Of relative velocity: δ(p) = dv + dw × arm.
struct Change {
  Lanes3 dv, dw;
};

/// Force of a sample in the body's frame: f = A p + b − k C.
struct ForceMap {
  LaneMatrix A;
  Lanes3 b;
};

[[gnu::always_inline]] inline LaneMatrix cross_matrix(const Lanes3& w) {
  const Lanes zero{};
  return {{{zero, -w.z, w.y}, {w.z, zero, -w.x}, {-w.y, w.x, zero}}};
}

/// Of two patches, a lane each: W f = k (R p + t + arm_O − R_O C) + ahead (W R p + u) − slope (dv + dw × (R p + t)).
[[gnu::always_inline]] inline ForceMap force_map(const PatchMotion& m0, const PatchMotion& m1,
                                                 const Stiffness& stiffness, const BodyStep& target,
                                                 const Change& change) {
  const Lanes k = both(stiffness.k);
  const Lanes3 t = gather(m0.t, m1.t);
  LaneMatrix A = both(stiffness.ahead) * gather(m0.W, m1.W);
  A.row[0].x += k;
  A.row[1].y += k;
  A.row[2].z += k;
  Lanes3 b = k * (t + both(target.arm_O)) + stiffness.ahead * gather(m0.u, m1.u);
  const Lanes3 w = stiffness.slope * change.dw;
  A = (A - cross_matrix(w)) * gather(m0.R, m1.R);
  b = b - stiffness.slope * change.dv - cross(w, t);
  const LaneMatrix back = transposed(both(target.R));
  return {back * A, back * b};
}

/// Both lanes of what one lane holds.
template <int i>
[[gnu::always_inline]] inline Lanes lane(Lanes v) {
  return Lanes{v[i], v[i]};
}
template <int i>
[[gnu::always_inline]] inline Lanes3 lane(const Lanes3& v) {
  return {lane<i>(v.x), lane<i>(v.y), lane<i>(v.z)};
}
template <int i>
[[gnu::always_inline]] inline ForceMap lane(const ForceMap& m) {
  return {{{lane<i>(m.A.row[0]), lane<i>(m.A.row[1]), lane<i>(m.A.row[2])}}, lane<i>(m.b)};
}

[[gnu::always_inline]] inline Lanes3 force_at(const ForceMap& map, double k, const Contacts& contacts, std::size_t i) {
  return map.A * load(contacts.p_P, i) + map.b - k * load(contacts.C_O, i);
}

/// All bits set in a lane whose sample pulls, or is outside its static cone.
[[gnu::always_inline]] inline auto fails(const Lanes3& f, const Lanes3& n, double mu_static) {
  const Lanes zero{};
  const Lanes N = zero - dot(f, n);
  const Lanes3 t = f + N * n;
  const Lanes cap = mu_static * N;
  return (N <= zero) | (dot(t, t) > cap * cap);
}

/// A patch of which every sample is linear, an even number.
[[gnu::always_inline]] inline bool all_hold(const ForceMap& map, double k, double mu_static, const PatchSlot& patch,
                                            Contacts& contacts) {
  const Lanes zero{};
  auto outside = zero < zero;
  for (std::size_t i = patch.slot(0), end = patch.slot(patch.count); i < end; i += lanes) {
    const Lanes3 f = force_at(map, k, contacts, i);
    outside |= fails(f, load(contacts.n_O, i), mu_static);
    store(contacts.f_O, i, f);
  }
  return !outside[0] && !outside[1];
}

/// Any other: samples that are not linear keep the force they have.
bool linear_hold(const ForceMap& map, double k, double mu_static, const PatchSlot& patch, const std::vector<Role>& role,
                 Contacts& contacts) {
  bool holds = true;
  for (int i = 0; i < patch.count; i += lanes) {
    const std::size_t slot = patch.slot(i);
    const bool linear[lanes] = {role[slot] == Role::linear, i + 1 < patch.count && role[slot + 1] == Role::linear};
    if (!linear[0] && !linear[1]) continue;
    const Lanes3 f = force_at(map, k, contacts, slot);
    const auto outside = fails(f, load(contacts.n_O, slot), mu_static);
    for (int at = 0; at < lanes; ++at) {
      if (!linear[at]) continue;
      holds = holds && !outside[at];
      contacts.f_O.set(slot + std::size_t(at), {f.x[at], f.y[at], f.z[at]});
    }
  }
  return holds;
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
  in_pairs(begin, end, moments, [&](const SlotStep& first, const SlotStep* second) {
    const StickMoments& moment = moments[std::size_t(first.patch)];
    if (second)
      add(first.motion, second->motion, moment, moments[std::size_t(second->patch)], stiffness, target, lane);
    else
      add(first.motion, first.motion, moment, none, stiffness, target, lane);
  });
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

void evaluate_sticking(SlotStep* begin, SlotStep* end, const Stiffness& stiffness, double mu_static, const Vector3d& dv,
                       const Vector3d& dw, const BodyStep& target, const std::vector<Role>& role,
                       const std::vector<StickMoments>& moments, Contacts& contacts) {
  const Change change{both(dv), both(dw)};
  in_pairs(begin, end, moments, [&](SlotStep& first, SlotStep* second) {
    const ForceMap map = force_map(first.motion, second ? second->motion : first.motion, stiffness, target, change);
    for (SlotStep* const step : {&first, second})
      if (step) {
        const StickMoments& moment = moments[std::size_t(step->patch)];
        const PatchSlot& patch = contacts.patches[std::size_t(step->patch)];
        const ForceMap own = step == second ? lane<1>(map) : lane<0>(map);
        step->holds = moment.count == patch.count && patch.count % lanes == 0
                          ? all_hold(own, stiffness.k, mu_static, patch, contacts)
                          : linear_hold(own, stiffness.k, mu_static, patch, role, contacts);
      }
  });
}

}  // namespace handhold::realtime
