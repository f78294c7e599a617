// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::PrintedPinch;
using closed_form::SpringFrames;
using printed::HostOptions;
using printed::Integrator;

const Eigen::Vector3d across = Eigen::Vector3d::UnitY();  // tangential, and gravity is not felt along it

/// A stuck object, kicked along y.
PrintedProblem kicked(double mass, double speed, double damping, const HostOptions& host, int frames) {
  const PrintedPinch pinch{.face = {.friction = sticky}, .mass = mass};
  PrintedProblem p = in_a_pinch(Ground::planes, pinch, {}, frames);
  p.law.damping = damping;
  p.host = host;
  p.V_WO.v = speed * across;
  return p;
}

Run growth_run(const std::string& name, const HostOptions& host, double truth, const std::string& source,
               double damping = 0) {
  const PrintedPinch pinch;
  Run run{.name = name, .problem = [=] { return kicked(0.2, 0.1, damping, host, 13); }};
  run.claims = {printed_claim(
      "growth per frame", truth, source,
      {.kind = Measure::Kind::growth, .axis = across, .at = 13 * pinch.face.frame, .from = pinch.face.frame},
      rounding_limit(1, 1, 4, "places of a millimetre are exact to 1e-16 of themselves"))};
  return run;
}

std::vector<Run> growth_runs() {
  const SpringFrames s{.mass = 0.2, .stiffness = 1600};
  std::vector<Run> runs{
      growth_run("as PhysX", {}, 1, "semi-implicit Euler, K dt^2/m < 4: no growth"),
      growth_run("explicit Euler", {.integrator = Integrator::explicit_euler}, explicit_growth(s), "sqrt(1 + w)"),
      growth_run("a pose one frame old", {.old_pose = true}, delayed_growth(s), "sqrt(1 + w)"),
      growth_run("force held, exact motion", {.integrator = Integrator::exact_hold}, exact_hold_growth(s),
                 "sqrt(1 + w/2)")};
  for (const int n : {2, 3, 4, 8})
    runs.push_back(growth_run(fmt::format("force held over {} sub-steps", n), {.substeps = n, .hold_force = true},
                              held_growth(s, n), "sqrt(1 + w (n - 1)/(2 n))"));
  const double damping = 0.3, w = spring_number(s), loss = 16 * damping * s.frame / s.mass;
  for (const int n : {1, 4})
    runs.push_back(growth_run(fmt::format("dashpots, {} sub-steps", n), {.substeps = n, .hold_force = true},
                              std::sqrt(1 - loss + w * (n - 1) / (2 * n)), "sqrt(1 - c dt/m + w (n - 1)/(2 n))",
                              damping));
  return runs;
}

/// A kick of 1 mm/s moves it by 11 um in a frame: it stays within 1 mm, or has left it after so many frames (1.2, 1.02
/// and 6.9 a frame) and not yet the finite numbers.
Run bound_run(const std::string& name, double mass, double damping, const HostOptions& host, int frames, bool stable,
              const std::string& source) {
  Run run{.name = name, .problem = [=] { return kicked(mass, 0.001, damping, host, frames); }};
  run.claims = {
      printed_count("stays within 1 mm", stable, source, {.kind = Measure::Kind::held, .axis = across, .level = 1e-3})};
  return run;
}

std::vector<Run> bound_runs() {
  const SpringFrames s{.mass = 0.2, .stiffness = 1600};
  const double least = closed_form::least_stable_mass(s.stiffness, s.frame);
  const double most = (4 - spring_number(s)) / 2 * s.mass / s.frame / 16;  // a sample's dashpot
  std::vector<Run> runs;
  for (const double share : {0.99, 1.01})
    runs.push_back(bound_run(fmt::format("{} of the least mass", share), share * least, 0, {}, 40, share > 1,
                             "stable iff m > K dt^2/4"));
  for (const double share : {0.99, 1.01})
    runs.push_back(bound_run(fmt::format("{} of the strongest dashpot", share), s.mass, share * most, {}, 300,
                             share < 1, "stable iff w + 2 c dt/m < 4"));
  for (const double share : {0.2, 0.3})
    runs.push_back(bound_run(fmt::format("{} of the least mass, 2 sub-steps anew", share), share * least, 0,
                             {.substeps = 2}, 12, share > 0.25, "sub-steps computed anew: m > K (dt/2)^2/4"));
  return runs;
}

}  // namespace

Case printed_stability_case() {
  Case c = printed_case("L3-08", "Stability of the undamped contact spring at frame rate");
  c.statement = "0.2 kg stuck between two fingers, 2 x 8 x 100 N/m, kicked along the faces; 90 Hz.";
  c.formula = "w = K dt^2/m: stable for w < 4; never if force or pose is old";
  c.runs = growth_runs();
  for (Run& run : bound_runs()) c.runs.push_back(std::move(run));
  return c;
}

}  // namespace handhold::catalogue
