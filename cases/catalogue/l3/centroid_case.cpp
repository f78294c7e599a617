// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::PrintedFace;
using closed_form::PrintedPinch;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
constexpr double radius = 0.008;  // of a capsule: its centroid's height when its skin touches [m]

/// A patch of eight on its centroid, whose height over the face is a function of time.
PrintedProblem scene(Ground ground, const Scalar& height, double frame, int frames) {
  PrintedProblem p = ring_on_a_face(
      ground, {.frame = frame}, 0.004, [](double) { return 0.0; }, frames);
  p.law.point = printed::Point::centroid;
  const double top = top_of(ground);
  p.phalanges.front().pose = [=](double t) { return Pose{.p = {0, 0, top + height(t)}}; };
  return p;
}

Run approach_run(Ground ground) {
  const double speed = 0.1, frame = 1e-3, above = 0.00205;  // of the skin, half a frame's way off a tie
  const int frames = 130;
  const auto height = [=](double t) { return radius + above - speed * t; };
  Run run{.name = "comes down", .problem = [=] { return scene(ground, height, frame, frames); }};
  const double end = frames * frame, touch = above / speed;
  run.claims = {
      printed_claim("first force", touch + closed_form::dead_time(radius, speed), "the skin's touch + r_c/V",
                    time_of(EventKind::touch), {.value = frame, .reason = "seen at the next frame"}),
      printed_claim("force 90 ms after touch", 0, "the centroid is outside, and a gate holds the pull back",
                    force_at(100 * frame, up), {.value = 0, .reason = "nothing acts"}),
      printed_claim("force in the end", 8 * PrintedFace{}.gamma * height(end), "n gamma d", force_at(end, up),
                    rounding_limit(top_of(ground) + radius, -height(end), 2, "the sum of eight has as many"))};
  return run;
}

Run ungated_run(Ground ground, printed::Sign sign) {
  const bool printed_sign = sign == printed::Sign::as_printed;
  Run run{.name = printed_sign ? "ungated, as printed" : "ungated, onto the object", .problem = [=] {
            PrintedProblem p = scene(
                ground, [](double) { return radius; }, 1.0 / 90, 1);
            p.law.gate = printed::Gate::none;
            p.law.apart_anchor = printed::ApartAnchor::stays;
            p.law.sign = sign;
            return p;
          }};
  const double pull = closed_form::largest_pull(PrintedFace{}.gamma, 8, radius);
  run.claims = {printed_claim("force when the skin touches", printed_sign ? -pull : pull,
                              "n gamma r_c: adhesion, or a jump that repels", force_at(0, up),
                              rounding_limit(top_of(ground) + radius, radius, 4, "the sum of eight"))};
  return run;
}

Run holding_run(Ground ground, double share) {
  PrintedPinch p{.mass = 0.2};
  p.face.depth = share * (holding_penetration(p, radius) - radius);
  Run run{.name = fmt::format("holds 0.2 kg, {} of the depth", share > 1 ? "1 + 1e-9" : "1 - 1e-9"), .problem = [=] {
            return in_a_pinch(ground, p, {.lag = p.mass * p.gravity / (p.samples * p.face.gamma)}, 1);
          }};
  run.claims = {printed_count("slipping samples", share < 1 ? 16 : 0, "penetration r_c + m g/(n gamma mu_s)",
                              count_at(0, Mode::slip))};
  return run;
}

}  // namespace

Case printed_centroid_case() {
  Case c = printed_case("L3-09", "The centroid: a dead zone of one radius, or adhesion without a gate");
  c.statement = "A capsule of radius 8 mm, its eight samples all at its centroid, comes down on a face or pinches.";
  c.formula = "delay r_c/V; ungated pull up to n gamma r_c; penetration to hold r_c + m g/(n gamma mu_s)";
  for (Run& run : on_both(approach_run)) c.runs.push_back(std::move(run));
  for (const printed::Sign sign : {printed::Sign::onto_object, printed::Sign::as_printed})
    for (Run& run : on_both([=](Ground g) { return ungated_run(g, sign); })) c.runs.push_back(std::move(run));
  for (const double share : {1 - 1e-9, 1 + 1e-9})
    for (Run& run : on_both([=](Ground g) { return holding_run(g, share); })) c.runs.push_back(std::move(run));
  return c;
}

}  // namespace handhold::catalogue
