// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

// One sample that is drawn over a fixed face.

namespace handhold::catalogue {
namespace {

using closed_form::FrameOrder;
using closed_form::PrintedFace;
using closed_form::PrintedSlide;

const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

std::string order_name(FrameOrder order) { return order == FrameOrder::force_first ? "force first" : "anchor first"; }

/// State after frame n of a hand that begins without lag.
PrintedSlide slide(const PrintedFace& face, double v, FrameOrder order, int n) {
  PrintedSlide s;
  for (int k = 0; k < n; ++k) s = next_slide(face, s.lag, v, order);
  return s;
}

/// x(t) of a hand with speed v that is at 0 after `frames`.
Scalar until_zero(const PrintedFace& face, double v, int frames) {
  return [=](double t) { return v * (t - frames * face.frame); };
}

double steady_lag(const PrintedFace& face, double v) { return v * face.frame / (1 - contraction(face)); }

/// At the end of such a way places are small, but v t is rounded for now and for the frame before: half of the four
/// roundings of the whole way.
double end_reach(const PrintedFace& face, double v, int frames) {
  return v * frames * face.frame / 2 + 2 * steady_lag(face, v);
}

// --- L3-02 -----------------------------------------------------------------------------------------------------------

constexpr int slide_frames = 200;  // q^200 = 6e-30

Run slide_run(Ground ground, const PrintedFace& face, double v, FrameOrder order) {
  Run run{.name = fmt::format("{} m/s, {}", v, order_name(order)), .problem = [=] {
            PrintedProblem p = on_a_face(ground, face, until_zero(face, v, slide_frames), slide_frames);
            p.law = law_of(face, order);
            return p;
          }};
  const int early = 4;
  const double begin = v * slide_frames * face.frame;
  const double after = order == FrameOrder::force_first ? 1 : contraction(face);
  run.claims = {
      printed_claim(fmt::format("force at frame {}", early), slide(face, v, order, early).force,
                    "s' = s + v dt; beyond mu_s d the ray leaves q of it and the force is mu_d gamma s",
                    force_at(early * face.frame, along),
                    ray_limit(ground, face, begin, after * slide(face, v, FrameOrder::force_first, early - 1).lag)),
      printed_claim("steady force", steady_slide_force(face, v, order),
                    "mu_d gamma v dt (d + eps)/eps before the ray, times q after it",
                    force_at(slide_frames * face.frame, along),
                    ray_limit(ground, face, end_reach(face, v, slide_frames), after * steady_lag(face, v))),
      printed_count("slipping at the end", 1, "v > mu_s d eps/(dt (d + eps))",
                    count_at(slide_frames * face.frame, Mode::slip))};
  return run;
}

Run coarse_run(Ground ground, FrameOrder order) {
  const PrintedFace face{.depth = 0.005, .offset = 0.0001, .frame = 1.0 / 60};
  const double v = 0.5;
  const int frames = 100;
  Run run{.name = fmt::format("eps = 0.1 mm, 60 Hz, {}", order_name(order)), .problem = [=] {
            PrintedProblem p = on_a_face(ground, face, until_zero(face, v, frames), frames);
            p.law = law_of(face, order);
            return p;
          }};
  const PrintedSlide end = slide(face, v, order, frames);
  run.claims = {printed_claim("force at frame 100", end.force, "the same map, q = 0.98: still on its way",
                              force_at(frames * face.frame, along),
                              ray_limit(ground, face, v * frames * face.frame, end.lag / contraction(face)))};
  return run;
}

// --- L3-03 -----------------------------------------------------------------------------------------------------------

/// Frames of whole periods: from the one after the first slip to the sixth slip.
struct Periods {
  int first{}, last{};
  double force{};  ///< summed over them [N]
  static constexpr int count = 5;
};

Periods periods(const PrintedFace& face, double v) {
  Periods out;
  PrintedSlide s;
  int slips = 0;
  for (int k = 1; slips <= Periods::count; ++k) {
    s = next_slide(face, s.lag, v, FrameOrder::force_first);
    if (slips > 0) out.force += s.force;
    slips += s.slips;
    if (slips == 1 && s.slips) out.first = k + 1;
    out.last = k;
  }
  return out;
}

Run chatter_run(Ground ground, double kinetic) {
  const PrintedFace face{.friction = {0.5, kinetic}};
  const double v = 1.0007e-4;  // at 1e-4 a break-away is a tie, lag = mu_s d: rounding decides
  const Periods p = periods(face, v);
  const int frames = p.last - p.first + 1;
  Limit added = ray_limit(ground, face, v * p.last * face.frame, face.friction.mu_static * face.depth);
  added.value += frames * unit_roundoff;
  added.reason += "; + u for every frame that is added";
  Run run{.name = fmt::format("mu_d = {}", kinetic), .problem = [=] {
            return on_a_face(
                ground, face, [v](double t) { return v * t; }, p.last);
          }};
  const Measure sum{
      .kind = Measure::Kind::force_sum, .axis = along, .at = p.last * face.frame, .from = p.first * face.frame};
  Measure slips{.kind = Measure::Kind::mode_count, .at = sum.at, .from = sum.from, .mode = Mode::slip};
  run.claims = {
      printed_claim("force summed over five periods, by the limit",
                    frames * chatter_friction(face) * face.gamma * face.depth,
                    "mean F/N -> mu_s (1 + q)/2, whatever mu_d is", sum,
                    {.value = chatter_error(face, v),
                     .relative = true,
                     .reason = "the limit v -> 0 is off by what chatter_error (printed_law.hpp) derives"}),
      printed_claim("force summed over five periods, by the map", p.force, "s' = s + v dt, beyond mu_s d q of it", sum,
                    added),
      printed_count("slipping frames", Periods::count, "one a period; a share of v/v_c of all frames", slips)};
  return run;
}

// --- L3-04 -----------------------------------------------------------------------------------------------------------

Run impulse_run(Ground ground, double v) {
  const PrintedFace face;
  const int frames = 500;
  // The frames' deviations come into a sum that is as long as the way; the sum itself rounds once a frame.
  const double middle = v * frames * face.frame / 2;
  Limit limit = rounding_limit(places_on(ground, middle), 2 * middle, std::sqrt(double(frames)), "sqrt(n), at random");
  limit.value += frames * unit_roundoff;
  limit.reason += "; + u for every frame that is added";
  const double last = slide(face, v, FrameOrder::force_first, frames).lag;
  Run run{.name = fmt::format("{} m/s", v), .problem = [=] {
            return on_a_face(
                ground, face, [=](double t) { return v * t - middle; }, frames);
          }};
  run.claims = {printed_claim(
      "force summed over the slipping frames", slip_impulse(face, v, frames, 0, last),
      "mu_d gamma (n v dt + s_0 - s_n) (d + eps)/eps",
      {.kind = Measure::Kind::force_sum, .axis = along, .at = frames * face.frame, .from = 0, .mode = Mode::slip},
      limit)};
  return run;
}

// --- L3-15 -----------------------------------------------------------------------------------------------------------

Run light_run(FrameOrder order) {
  const PrintedFace face{.depth = 1e-9};
  const double v = 0.2;
  const int frames = 60;
  Run run{.name = "depth 1 nm, " + order_name(order), .problem = [=] {
            PrintedProblem p = on_a_face(Ground::planes, face, until_zero(face, v, frames), frames);
            p.law = law_of(face, order);
            return p;
          }};
  const Measure force = force_at(frames * face.frame, along);
  run.claims = {printed_claim("force", steady_slide_force(face, v, order), "as L3-02", force,
                              ray_limit(Ground::planes, face, end_reach(face, v, frames), steady_lag(face, v)))};
  if (order == FrameOrder::anchor_first) return run;
  run.claims.push_back(printed_claim(
      "force without any squeeze", face.friction.mu_dynamic * face.gamma * v * face.frame,
      "d -> 0: mu_d gamma v dt, while the normal force is 1e-7 N", force,
      {.value = 1.01 * face.depth / face.offset, .relative = true, .reason = "(d + eps)/eps instead of 1, and 1 %"}));
  return run;
}

}  // namespace

Case printed_slide_case() {
  Case c = printed_case("L3-02", "Steady sliding is viscous and hangs on the frame rate");
  c.statement = "One sample at 2.5 mm is drawn over a face at constant speed; eps = 1 mm, 90 Hz.";
  c.formula = "F/N = mu_d v/v1, v1 = d eps/(dt (d + eps)); Coulomb: mu_d";
  for (const FrameOrder order : {FrameOrder::force_first, FrameOrder::anchor_first}) {
    for (const double v : {0.2, 0.05})
      for (Run& run : on_both([=](Ground g) { return slide_run(g, {}, v, order); })) c.runs.push_back(std::move(run));
    for (Run& run : on_both([=](Ground g) { return coarse_run(g, order); })) c.runs.push_back(std::move(run));
  }
  return c;
}

Case printed_chatter_case() {
  Case c = printed_case("L3-03", "Slow sliding chatters, and its mean does not know mu_d");
  c.statement = "As L3-02 at 0.1 mm/s: stick and slip frames alternate.";
  c.formula = "saw-tooth from q mu_s d to mu_s d; mean F/N -> mu_s (1 + q)/2";
  for (const double kinetic : {0.4, 0.1})
    for (Run& run : on_both([=](Ground g) { return chatter_run(g, kinetic); })) c.runs.push_back(std::move(run));
  return c;
}

Case printed_impulse_case() {
  Case c = printed_case("L3-04", "The slipping frames' forces sum to a viscous law at any speed");
  c.statement = "As L3-02, in chatter and in steady sliding.";
  c.formula = "sum F = mu_d gamma (n v dt + s_0 - s_n) (d + eps)/eps";
  for (const double v : {0.013, 0.03, 0.3})
    for (Run& run : on_both([=](Ground g) { return impulse_run(g, v); })) c.runs.push_back(std::move(run));
  return c;
}

Case printed_light_squeeze_case() {
  Case c = printed_case("L3-15", "Friction does not vanish with the squeeze");
  c.statement = "As L3-02 at a depth of 1 nm. Planes only: a face at 1/32 m cannot show a nanometre to 1e-12.";
  c.formula = "F -> mu_d gamma v dt as d -> 0, so F/N -> infinity";
  c.runs = {light_run(FrameOrder::force_first), light_run(FrameOrder::anchor_first)};
  return c;
}

}  // namespace handhold::catalogue
