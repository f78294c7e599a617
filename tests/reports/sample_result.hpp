// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "compare/judge/result.hpp"

namespace handhold::reports {

inline compare::Gate sample_gate(const std::string& quantity, double measured, double limit, const std::string& unit) {
  return {quantity,
          measured,
          compare::Bound::at_most,
          limit,
          unit,
          catalogue::Pedigree::exact,
          "v dt / 2 a slide: one sub-step late"};
}

inline compare::Judgement sample_judgement(const std::string& engine, const std::string& quantity,
                                           const std::string& unit, double truth, double value, double limit) {
  const double error = std::abs(value - truth);
  return {.engine = engine,
          .value = value,
          .error = error,
          .gate = sample_gate(quantity + " error, " + engine, error, limit, unit)};
}

/// A claim and what two engines say: "exact", whose errors are small, and "fast".
inline compare::ClaimResult sample_claim(const std::string& quantity, const std::string& unit, double truth,
                                         double exact, double fast, double exact_limit, double fast_limit) {
  compare::ClaimResult out;
  out.claim.quantity = quantity;
  out.claim.unit = unit;
  out.claim.truth = truth;
  out.claim.source = "L2 = L1: t_s = (N0 - m g / (2 mu_s)) / r, mu_s > mu_d & N0 > 0";
  out.judgements = {sample_judgement("exact", quantity, unit, truth, exact, exact_limit),
                    sample_judgement("fast", quantity, unit, truth, fast, fast_limit)};
  return out;
}

inline compare::OrderStudy sample_study() {
  compare::OrderStudy out;
  out.engine = "fast";
  out.step = {1. / 360, 1. / 720, 1. / 1440, 1. / 2880};
  out.error = {2.1e-3, 1.02e-3, 5.3e-4, 2.6e-4};
  out.order = {1.01, 0.02};
  out.gate = {"order of accuracy - 1", 0.01, compare::Bound::at_most, 0.2, "", catalogue::Pedigree::exact,
              "first-order method"};
  return out;
}

/// A slide as truth; one engine 1e-9 off, the other a little late.
inline compare::CurveData sample_curve() {
  compare::CurveData out;
  std::vector<double> exact, fast;
  out.label = "slip [m]";
  for (int i = 0; i <= 90; ++i) {
    const double t = i / 90.0, slide = 0.5 * 0.49 * std::pow(std::max(0.0, t - 0.2), 2);
    out.t.push_back(t);
    out.truth.push_back(slide);
    exact.push_back(slide + 1.4e-9 * std::sin(9 * t));
    fast.push_back(slide * 1.01 + 2e-5 * t);
  }
  out.engines = {{"exact", exact}, {"fast", fast}};
  return out;
}

/// Two cases with, among gates that hold, one that fails, one with a NaN, and one that is vacuous; a claim that nobody
/// asked one of the engines; texts that need escaping.
inline compare::SuiteResult sample_result() {
  compare::RunResult slides;
  slides.name = "slides";
  slides.claims.push_back(sample_claim("slip onset", "s", 0.2, 0.2 + 3e-10, 0.2031, 1e-9, 2.8e-3));  // real time fails
  slides.claims.push_back(sample_claim("slip distance", "m", 0.0784, 0.0784 + 2e-10, 0.0791, 1e-9, 1e-3));  // all hold
  slides.claims.back().studies = {sample_study()};
  slides.curve = sample_curve();
  slides.plays = {{.engine = "exact", .seconds = 0.42},
                  {.engine = "fast", .seconds = 0.012, .frame = {90, 41e-6, 52e-6, 88e-6, 131e-6, 131e-6}}};

  compare::RunResult holds;
  holds.name = "holds at 0.98";
  holds.claims.push_back(
      sample_claim("stop time", "s", 1.25, 1.25 + 1e-12, std::numeric_limits<double>::quiet_NaN(), 1e-9, 1e-2));
  holds.claims.push_back(sample_claim("sag", "m", 1e-3, 1e-3 + 4e-13, 0, 1e-12, 0));
  holds.claims.back().judgements[1] = compare::not_asked({.name = "fast"}, "it would ring");
  holds.plays = {{.engine = "exact"},
                 {.engine = "fast", .note = "diverged at t = 0.3 s: the body's speed is not finite"}};

  compare::SuiteResult out;
  out.engines = {{.name = "exact",
                  .version = "1",
                  .levels = {Level::compliant},
                  .errs = {compare::ErrorModel::Kind::controlled, 1e-10, 0},
                  .records = {true, true, true, false},
                  .settings = {{"accuracy", "1e-10"}}},
                 {.name = "fast",
                  .version = "2",
                  .levels = {Level::compliant},
                  .errs = {compare::ErrorModel::Kind::stepped, 0, 1. / 360},
                  .records = {true, true, true, true}}};
  out.cases.push_back({.id = "C01",
                       .title = "Incline <b>bold</b> & \"steep\"",
                       .statement = "A block lies on a palm tilted by θ.",
                       .formula = "a = g (sin θ − μ_d cos θ)",
                       .note = "k is high.",
                       .truth_level = "L1",
                       .level = Level::compliant,
                       .runs = {slides}});
  out.cases.push_back({.id = "D02",
                       .title = "Pinch opens",
                       .statement = "A pinch opens on a linear ramp.",
                       .formula = "t_s = (N0 − m g / (2 μ_s)) / r",
                       .truth_level = "L2",
                       .level = Level::compliant,
                       .runs = {holds}});
  out.provenance = {{"version", "0.1.0"}, {"compiler", "g++ 12.2 <-O2>"}};
  out.occasion = {{"command", "handhold suite --only C01,D02"}};
  out.seconds = 1.5;
  return out;
}

}  // namespace handhold::reports
