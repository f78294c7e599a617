// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/tops.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::integrate;
using testing::Point;
using testing::State;

void expect_equal(const Eigen::Matrix3d& R, const nlohmann::json& row_major, double tolerance) {
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(R(i / 3, i % 3), row_major[std::size_t(i)].get<double>(), tolerance);
}

void expect_equal(const Eigen::Vector3d& w, const nlohmann::json& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(w[i], expected[std::size_t(i)].get<double>(), tolerance);
}

/// Euler's equations and q' = q ω / 2 by GSL.
Point integrate_top(const Eigen::Vector3d& I, const Eigen::Vector3d& w0, double t) {
  const auto rates = [&](double, const State& y) {
    const Eigen::Vector3d w(y[0], y[1], y[2]);
    const Eigen::Vector3d dw = I.cwiseProduct(w).cross(w).cwiseQuotient(I);
    const Eigen::Quaterniond q(y[3], y[4], y[5], y[6]);
    const Eigen::Quaterniond dq = q * Eigen::Quaterniond(0, w[0] / 2, w[1] / 2, w[2] / 2);
    return State{dw[0], dw[1], dw[2], dq.w(), dq.x(), dq.y(), dq.z()};
  };
  return integrate(rates, {0, {w0[0], w0[1], w0[2], 1, 0, 0, 0}}, t);
}

Eigen::Matrix3d attitude_of(const Point& p) {
  return Eigen::Quaterniond(p.y[3], p.y[4], p.y[5], p.y[6]).normalized().toRotationMatrix();
}

TEST(SymmetricTop, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("A02");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const SymmetricTop top{s.given("I1"), s.given("I3"), s.given("w1"), s.given("w3")};
    expect_equal(attitude(top, s.given("T")), s.expected.at("R"), 1e-13);
    expect_equal(rates(top, s.given("T")), s.expected.at("w"), 1e-12);
  }
}

TEST(SymmetricTop, TurnsAsIntegrationSays) {
  const SymmetricTop top{3e-4, 5e-4, 4, 9};
  const Point p = integrate_top({3e-4, 3e-4, 5e-4}, {4, 0, 9}, 2.2);
  EXPECT_LT((attitude(top, 2.2) - attitude_of(p)).norm(), 1e-10);
  EXPECT_LT((rates(top, 2.2) - Eigen::Vector3d(p.y[0], p.y[1], p.y[2])).norm(), 1e-10);
}

TEST(AsymmetricTop, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("A03");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const AsymmetricTop top{{s.given("I1"), s.given("I2"), s.given("I3")}, s.given("w1"), s.given("w3")};
    expect_equal(rates(top, s.given("T")), s.expected.at("w"), 1e-11);  // the second set flips: its errors grow
    // The catalogue's frame has z along L and −x along the body's second axis at t = 0.
    const Eigen::Vector3d L = top.moments.cwiseProduct(rates(top, 0));
    const Eigen::Matrix3d R_L0 = (Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(-std::atan2(L[0], L[2]), Eigen::Vector3d::UnitY()))
                                     .toRotationMatrix();
    expect_equal(Eigen::Matrix3d(R_L0 * attitude(top, s.given("T"))), s.expected.at("R"), 1e-11);
    EXPECT_NEAR(period(top), s.number("period"), 1e-11);
  }
}

/// On both sides of the separatrix, 1.94 rad/s, for more than a period.
TEST(AsymmetricTop, TurnsAsIntegrationSays) {
  for (const double w3 : {7.0, 2.0, 1.0}) {
    const Eigen::Vector3d I(1e-4, 1.7e-4, 2.4e-4);
    const AsymmetricTop top{I, 3, w3};
    const double T = 1.3 * period(top);
    const Point p = integrate_top(I, {3, 0, w3}, T);
    EXPECT_LT((rates(top, T) - Eigen::Vector3d(p.y[0], p.y[1], p.y[2])).norm(), 1e-10) << w3;
    EXPECT_LT((attitude(top, T) - attitude_of(p)).norm(), 1e-10) << w3;
    const Point full = integrate_top(I, {3, 0, w3}, period(top));
    EXPECT_NEAR(full.y[0], 3, 1e-10);
    EXPECT_NEAR(full.y[1], 0, 1e-10);
  }
}

}  // namespace
}  // namespace handhold::closed_form
