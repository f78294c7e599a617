// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

// An object that is let go on unstretched springs.

namespace handhold::catalogue {
namespace {

using closed_form::PrintedPinch;
using closed_form::SpringFrames;

const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

SpringFrames springs_of(const PrintedPinch& p) { return {p.mass, p.samples * p.face.gamma, p.face.frame}; }

double static_lag(const PrintedPinch& p) { return p.face.friction.mu_static * p.face.depth; }

Run threshold_run(Ground ground, const std::string& name, const PrintedPinch& p, int frames, bool slips,
                  const std::string& source) {
  Run run{.name = name, .problem = [=] { return in_a_pinch(ground, p, {}, frames); }};
  run.claims = {printed_count("holds", !slips, source, none_of(EventKind::breakaway))};
  return run;
}

Run release_run(Ground ground, double share) {
  PrintedPinch p{.face = {.frame = 1e-4}};
  p.mass = share * closed_form::release_mass(p.samples * p.face.gamma, p.gravity, static_lag(p));
  // The first peak of the lag comes after 250 frames. It is higher than the limit's by m_min/(4 m) = 1e-5, and frames
  // miss it by at most w/16 = 1e-5 of it.
  return threshold_run(ground, share > 1 ? "1 + 2e-5 of the threshold" : "1 - 2e-5 of the threshold", p, 600, share > 1,
                       "dt -> 0: slips iff 2 m g/K > mu_s d, half of the static limit; at 0.1 ms within 2e-5");
}

Run overshoot_run(Ground ground, const PrintedPinch& p, const std::string& name) {
  const int n = 37, frames = 1000;
  const SpringFrames s = springs_of(p);
  const double most = largest_released_lag(s, p.gravity), lag = released_lag(s, p.gravity, n);
  Run run{.name = name, .problem = [=] { return in_a_pinch(ground, p, {}, frames); }};
  const auto stays_below = [&](double level) {
    return Measure{.kind = Measure::Kind::held, .axis = down, .level = level};
  };
  run.claims = {
      printed_claim("lag at frame 37", lag,
                    "(m g/K) [1 - cos((n + 1/2) theta)/cos(theta/2)], cos theta = 1 - K dt^2/(2 m)",
                    displacement_at(n * p.face.frame, down),
                    rounding_limit(most, lag, n, "an undamped spring keeps every frame's")),
      printed_count("stays below its supremum in 1000 frames", 1, "(m g/K) (1 + 1/sqrt(1 - m_min/m)), + 1e-12",
                    stays_below(most * (1 + 1e-12))),
      printed_count("stays below 0.9999 of it", 0, "so many phases come near the crest", stays_below(0.9999 * most))};
  return run;
}

std::vector<Run> window_runs(Ground ground) {
  PrintedPinch p;
  const auto window =
      closed_form::release_window(p.samples * p.face.gamma, p.face.frame, p.gravity, static_lag(p)).value();
  std::vector<Run> runs;
  for (const bool upper : {false, true}) {
    for (const double share : {0.995, 1.005}) {
      p.mass = share * (upper ? window.most : window.least);
      runs.push_back(threshold_run(ground, fmt::format("{} of the {} mass", share, upper ? "largest" : "least"), p,
                                   5000, upper == (share > 1),
                                   "slips iff 1/(u (1 - u)) > mu_s d K/(m_min g), 5000 phases"));
    }
  }
  return runs;
}

}  // namespace

Case printed_release_case() {
  Case c = printed_case("L3-10", "Let go on unstretched springs, it slips at half the weight");
  c.statement = "An object between two fingers, 2 x 8 samples 2.5 mm deep, springs unstretched; frames of 0.1 ms.";
  c.formula = "first slip iff m g > mu_s N, half of the static 2 mu_s N";
  for (const double share : {1 - 2e-5, 1 + 2e-5})
    for (Run& run : on_both([=](Ground g) { return release_run(g, share); })) c.runs.push_back(std::move(run));
  return c;
}

Case printed_overshoot_case() {
  Case c = printed_case("L3-18", "Overshoot of the undamped spring, and the window of masses that do not slip");
  c.statement = "As L3-10 at frame rate, with friction that never slips, and with mu_s = 0.5 at the window's edges.";
  c.formula = "sup s = (m g/K) (1 + 1/sqrt(1 - m_min/m)), m_min = K dt^2/4; no slip iff sup s <= mu_s d";
  for (const double mass : {0.1, 0.06}) {
    const PrintedPinch p{.face = {.friction = sticky}, .mass = mass};
    for (Run& run : on_both([=](Ground g) { return overshoot_run(g, p, fmt::format("{} kg", mass)); }))
      c.runs.push_back(std::move(run));
  }
  const PrintedPinch slow{.face = {.friction = sticky, .frame = 1.0 / 60}, .samples = 40, .mass = 0.3};
  for (Run& run : on_both([=](Ground g) { return overshoot_run(g, slow, "0.3 kg, 40 samples, 60 Hz"); }))
    c.runs.push_back(std::move(run));
  for (Run& run : window_runs(Ground::planes)) c.runs.push_back(std::move(run));
  return c;
}

}  // namespace handhold::catalogue
