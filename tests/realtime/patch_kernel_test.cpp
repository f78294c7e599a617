// SPDX-License-Identifier: GPL-3.0-or-later
// The sums and forces of sticking patches, which the kernel takes from moments two patches at a time, against the same
// sample by sample, straight from the element's law (docs/contact-law.md). The numbers are arbitrary: 1 rad, 1 m,
// 1 m/s, so that no term is small. Tolerance: 1e-12 of the sum of the terms' sizes, some thousand roundings.

#include "realtime/contact/patch_kernel.hpp"

#include <random>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double lead = 0.3, h = 0.4;  // [s]
constexpr Stiffness stiffness{50, 3, 50 * h + 3, 50 * lead + 3};

struct Patches {
  std::mt19937 random{7};
  Contacts contacts{};
  std::vector<Role> role{};
  std::vector<StickMoments> moments{};
  std::vector<SlotStep> steps{};
  BodyStep target{};

  double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  Vector3d vector() { return {number(), number(), number()}; }
  Matrix3d rotation() { return Eigen::AngleAxisd(1, vector().normalized()).toRotationMatrix(); }

  /// `sticks`: a letter a sample, 's' or any other.
  void add(const std::string& sticks) {
    const int count = int(sticks.size()), first = int(contacts.size());
    const std::size_t size = std::size_t(first + count + count % 2);
    contacts.patches.push_back({.first = first, .count = count, .active = true});
    contacts.id.resize(size);
    contacts.mode.resize(size, Mode::apart);
    role.resize(size, Role::idle);
    for (Vector3Array* array : {&contacts.p_P, &contacts.C_O, &contacts.n_O, &contacts.f_O}) array->resize(size);
    for (int i = 0; i < count; ++i) {
      const std::size_t slot = std::size_t(first + i);
      contacts.p_P.set(slot, vector());
      contacts.C_O.set(slot, vector());
      contacts.n_O.set(slot, vector().normalized());
      if (sticks[std::size_t(i)] != 's') continue;
      contacts.mode[slot] = Mode::stick;
      role[slot] = Role::linear;
    }
    moments.emplace_back();
    steps.emplace_back(int(steps.size()));
    steps.back().motion = {rotation(), vector(), Matrix3d(rotation() + rotation()), vector()};
    update(contacts.patches.back(), contacts, role, moments.back());
  }

  template <class Visit>
  void each_linear(Visit&& visit) const {
    for (const SlotStep& step : steps)
      for (int i = 0; i < contacts.patches[std::size_t(step.patch)].count; ++i) {
        const std::size_t slot = contacts.patches[std::size_t(step.patch)].slot(i);
        if (role[slot] == Role::linear) visit(step, slot, sample_step(step.motion, target, lead, contacts, slot));
      }
  }
};

/// Two full patches, one without sticking samples between them, one of odd size, and a mixed one.
Patches some_patches() {
  Patches p;
  p.target.R = p.rotation();
  p.target.arm_O = p.vector();
  for (const char* sticks : {"ssssssss", "....", "ssssssss", "sssss", "s..s.s"}) p.add(sticks);
  return p;
}

TEST(PatchKernel, SumsAreThoseOfTheSamples) {
  const Patches p = some_patches();
  const StickSums sums = sum_sticking(p.steps.data(), p.steps.data() + p.steps.size(), stiffness, p.target, p.moments);
  StickSums expected;
  double size = 0;
  p.each_linear([&](const SlotStep&, std::size_t, const SampleStep& s) {
    const Vector3d f = stiffness.k * s.reach + stiffness.c * s.v;
    ++expected.count;
    expected.arm += s.arm;
    expected.arm_arm += s.arm * s.arm.transpose();
    expected.force += f;
    expected.torque += s.arm.cross(f);
    expected.v += s.v;
    expected.arm_v += s.arm.cross(s.v);
    expected.power += f.dot(s.v);
    expected.squared_v += s.v.squaredNorm();
    size += (1 + s.arm.norm() + s.v.norm()) * (1 + s.arm.norm() + s.v.norm() + f.norm());
  });
  EXPECT_EQ(sums.count, 24);
  const double tolerance = 1e-12 * size;
  EXPECT_LT((sums.arm - expected.arm).norm(), tolerance);
  EXPECT_LT((sums.arm_arm - expected.arm_arm).norm(), tolerance);
  EXPECT_LT((sums.force - expected.force).norm(), tolerance);
  EXPECT_LT((sums.torque - expected.torque).norm(), tolerance);
  EXPECT_LT((sums.v - expected.v).norm(), tolerance);
  EXPECT_LT((sums.arm_v - expected.arm_v).norm(), tolerance);
  EXPECT_NEAR(sums.power, expected.power, tolerance);
  EXPECT_NEAR(sums.squared_v, expected.squared_v, tolerance);
}

TEST(PatchKernel, ResultsAreThoseOfTheSamples) {
  Patches p = some_patches();
  const Vector3d dv = p.vector(), dw = p.vector();
  const StickSums sums = sum_sticking(p.steps.data(), p.steps.data() + p.steps.size(), stiffness, p.target, p.moments);
  const StickResult result = result_of(sums, stiffness, dv, dw);
  evaluate_sticking(p.steps.data(), p.steps.data() + p.steps.size(), stiffness, 1, dv, dw, p.target, p.role, p.moments,
                    p.contacts);
  StickResult expected;
  double size = 0;
  const Matrix3d& R = p.target.R;
  p.each_linear([&](const SlotStep&, std::size_t slot, const SampleStep& s) {
    const Vector3d change = dv + dw.cross(s.arm), v = s.v - change;
    const Vector3d f = stiffness.k * (s.reach - h * change) + stiffness.c * v;
    EXPECT_LT((R * p.contacts.f_O[slot] - f).norm(), 1e-12 * stiffness.k) << slot;
    expected.force += f;
    expected.torque += s.arm.cross(f);
    expected.power += f.dot(v);
    expected.squared_v += v.squaredNorm();
    size += (1 + s.arm.norm() + s.v.norm() + change.norm()) * (1 + s.v.norm() + change.norm() + f.norm());
  });
  const double tolerance = 1e-12 * size;
  EXPECT_LT((result.force - expected.force).norm(), tolerance);
  EXPECT_LT((result.torque - expected.torque).norm(), tolerance);
  EXPECT_NEAR(result.power, expected.power, tolerance);
  EXPECT_NEAR(result.squared_v, expected.squared_v, tolerance);
}

/// One sample that pulls or is outside its cone is found wherever in a patch it is, and only its own patch is told.
TEST(PatchKernel, OneSampleThatDoesNotHoldIsFound) {
  Patches p = some_patches();
  // Every anchor 1 cm behind its sample's end, along the normal: f = −k 0.01 n where nothing moves.
  for (SlotStep& step : p.steps) {
    step.motion.W.setZero();
    step.motion.u.setZero();
  }
  const auto press = [&](const SlotStep& step, std::size_t slot, const Vector3d& lag_O) {
    const Vector3d end_O =
        p.target.R.transpose() * (step.motion.R * p.contacts.p_P[slot] + step.motion.t + p.target.arm_O);
    p.contacts.C_O.set(slot, end_O + 0.01 * p.contacts.n_O[slot] - lag_O);
  };
  const auto holds = [&](std::size_t patch) {
    evaluate_sticking(p.steps.data(), p.steps.data() + p.steps.size(), stiffness, 0.5, Vector3d::Zero(),
                      Vector3d::Zero(), p.target, p.role, p.moments, p.contacts);
    bool others = true;
    for (const SlotStep& step : p.steps) others = others && (std::size_t(step.patch) == patch || step.holds);
    EXPECT_TRUE(others);
    return p.steps[patch].holds;
  };
  const Patches before = p;
  before.each_linear(
      [&](const SlotStep& step, std::size_t slot, const SampleStep&) { press(step, slot, Vector3d::Zero()); });
  before.each_linear([&](const SlotStep& step, std::size_t slot, const SampleStep&) {
    const auto patch = std::size_t(step.patch);
    const Vector3d n = p.contacts.n_O[slot], t = n.unitOrthogonal();
    press(step, slot, 0.0049 * t);
    EXPECT_TRUE(holds(patch)) << slot;
    press(step, slot, 0.0051 * t);
    EXPECT_FALSE(holds(patch)) << slot;
    press(step, slot, 0.02 * n);
    EXPECT_FALSE(holds(patch)) << slot;
    press(step, slot, Vector3d::Zero());
  });
}

/// Moments are kept until they are told of a change, and stay out of date while roles are not what modes say.
TEST(StickMoments, AreKeptUntilTold) {
  Patches p;
  p.add("ssss");
  StickMoments& moments = p.moments[0];
  EXPECT_FALSE(moments.stale);
  p.role[1] = Role::free;  // found to pull
  update(p.contacts.patches[0], p.contacts, p.role, moments);
  EXPECT_EQ(moments.count, 4);
  moments.stale = true;
  update(p.contacts.patches[0], p.contacts, p.role, moments);
  EXPECT_EQ(moments.count, 3);
  EXPECT_TRUE(moments.stale);  // the next step begins with its mode, which is stick
  p.role[1] = Role::linear;
  update(p.contacts.patches[0], p.contacts, p.role, moments);
  EXPECT_EQ(moments.count, 4);
  EXPECT_FALSE(moments.stale);
}

}  // namespace
}  // namespace handhold::realtime
