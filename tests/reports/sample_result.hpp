#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "compare/judge/suite.hpp"

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

inline compare::Finding sample_finding(const std::string& quantity, const std::string& unit, double truth,
                                       double reference, double realtime, double reference_limit,
                                       double realtime_limit) {
  compare::Finding out;
  out.expectation.quantity = quantity;
  out.expectation.unit = unit;
  out.expectation.truth = truth;
  out.expectation.source = "L2 = L1: t_s = (N0 - m g / (2 mu_s)) / r, mu_s > mu_d & N0 > 0";
  out.expectation.reference.value = reference_limit;
  out.expectation.realtime.value = realtime_limit;
  out.reference = {reference, std::abs(reference - truth),
                   sample_gate(quantity + " error, reference", std::abs(reference - truth), reference_limit, unit)};
  out.realtime = {realtime, std::abs(realtime - truth),
                  sample_gate(quantity + " error, real time", std::abs(realtime - truth), realtime_limit, unit)};
  return out;
}

inline compare::OrderStudy sample_study() {
  compare::OrderStudy out;
  out.substep = {1. / 360, 1. / 720, 1. / 1440, 1. / 2880};
  out.error = {2.1e-3, 1.02e-3, 5.3e-4, 2.6e-4};
  out.order = {1.01, 0.02};
  out.gate = {"order of accuracy - 1", 0.01, compare::Bound::at_most, 0.2, "", catalogue::Pedigree::exact,
              "first-order method"};
  return out;
}

/// A slide of 4.905/2 t² as truth; the reference 1e-9 off, real time a little late.
inline compare::CurveData sample_curve() {
  compare::CurveData out;
  out.label = "slip [m]";
  for (int i = 0; i <= 90; ++i) {
    const double t = i / 90.0, slide = 0.5 * 0.49 * std::pow(std::max(0.0, t - 0.2), 2);
    out.t.push_back(t);
    out.truth.push_back(slide);
    out.reference.push_back(slide + 1.4e-9 * std::sin(9 * t));
    out.realtime.push_back(slide * 1.01 + 2e-5 * t);
  }
  return out;
}

/// Two cases with, among gates that hold, one that fails, one with a NaN, and one that is vacuous; texts that need
/// escaping.
inline compare::SuiteResult sample_result() {
  compare::RunResult slides;
  slides.name = "slides";
  slides.findings.push_back(
      sample_finding("slip onset", "s", 0.2, 0.2 + 3e-10, 0.2031, 1e-9, 2.8e-3));  // real time fails
  slides.findings.push_back(
      sample_finding("slip distance", "m", 0.0784, 0.0784 + 2e-10, 0.0791, 1e-9, 1e-3));  // all hold
  slides.findings.back().study = sample_study();
  slides.curve = sample_curve();
  slides.realtime_frame = {90, 41e-6, 52e-6, 88e-6, 131e-6, 131e-6};
  slides.reference_seconds = 0.42;
  slides.realtime_seconds = 0.012;

  compare::RunResult holds;
  holds.name = "holds at 0.98";
  holds.findings.push_back(
      sample_finding("stop time", "s", 1.25, 1.25 + 1e-12, std::numeric_limits<double>::quiet_NaN(), 1e-9, 1e-2));
  holds.realtime_note = "diverged at t = 0.3 s: the body's speed is not finite";

  compare::SuiteResult out;
  out.cases.push_back({"C01",
                       "Incline <b>bold</b> & \"steep\"",
                       "L1",
                       "A block lies on a palm tilted by θ.",
                       "a = g (sin θ − μ_d cos θ)",
                       "k is high.",
                       {slides}});
  out.cases.push_back(
      {"D02", "Pinch opens", "L2", "A pinch opens on a linear ramp.", "t_s = (N0 − m g / (2 μ_s)) / r", "", {holds}});
  out.provenance = {{"command", "handhold suite --only C01,D02"}, {"version", "0.1.0"}, {"compiler", "g++ 12.2 <-O2>"}};
  out.seconds = 1.5;
  return out;
}

}  // namespace handhold::reports
