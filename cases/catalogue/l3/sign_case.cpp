// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
const closed_form::SpringFrames springs{.mass = 0.2, .stiffness = 800, .frame = 1e-3};
constexpr double first_depth = 0.001;
constexpr int frames = 50;

/// A free object whose face rests on a patch of eight that is 1 mm in.
PrintedProblem scene(Ground ground, printed::Sign sign) {
  PrintedProblem p = ring_on_a_face(
      ground, {.depth = first_depth, .frame = springs.frame}, 0.003, [](double) { return 0.0; }, frames);
  p.law.sign = sign;
  p.mobility = Mobility::translation;
  p.inertia.mass = springs.mass;
  p.gravity.setZero();
  return p;
}

/// Of the gain of depth after n frames. Places are rounded as they grow, the spring's force by w of the depth's place,
/// and both gather at random; the truth's theta is known to u/w of itself, since 1 + w/2 is rounded, and a gain follows
/// it max(2, n theta) times.
Limit limit(Ground ground, int n, double gain) {
  const double w = spring_number(springs);
  const double places = std::abs(gain) + w * n * (top_of(ground) + first_depth);
  Limit limit = rounding_limit(places, std::abs(gain), std::sqrt(double(n)), "sqrt(n), they gather at random");
  limit.value += std::max(2.0, n * std::sqrt(w)) * unit_roundoff / w;
  limit.reason += "; the truth's theta is known to u/w";
  return limit;
}

Run attracted(Ground ground) {
  Run run{.name = "as printed", .problem = [=] { return scene(ground, printed::Sign::as_printed); }};
  for (const int n : {10, 25, 40}) {
    const double deeper = attracted_depth(springs, first_depth, n) - first_depth;
    run.claims.push_back(printed_claim("gain of depth at frame " + std::to_string(n), deeper,
                                       "d0 cosh((n + 1/2) theta) / cosh(theta/2) - d0, cosh theta = 1 + K dt^2/(2 m)",
                                       displacement_at(n * springs.frame, up), limit(ground, n, deeper)));
  }
  return run;
}

Run repelled(Ground ground) {
  Run run{.name = "onto the object", .problem = [=] { return scene(ground, printed::Sign::onto_object); }};
  int last = 0;  // the first frame with the object off the finger
  while (repelled_depth(springs, first_depth, last) > 0) ++last;
  const double off = repelled_depth(springs, first_depth, last);
  const double step = off - repelled_depth(springs, first_depth, last - 1);
  const auto gain = [&](int n, double depth) {
    return printed_claim("gain of depth at frame " + std::to_string(n), depth - first_depth,
                         "d0 cos((n + 1/2) theta) / cos(theta/2) - d0 until it is off, then straight on",
                         displacement_at(n * springs.frame, up), limit(ground, n, depth - first_depth));
  };
  run.claims = {
      gain(10, repelled_depth(springs, first_depth, 10)), gain(20, repelled_depth(springs, first_depth, 20)),
      gain(frames, off + (frames - last) * step),
      printed_claim("it is let go", std::numbers::pi / 2 / spring_rate(springs), "d0 cos(lambda t) = 0",
                    time_of(EventKind::release), {.value = springs.frame, .reason = "seen at the next frame"})};
  return run;
}

}  // namespace

Case printed_sign_case() {
  Case c = printed_case("L3-01", "Sign of eq. 1: as printed the force pulls the object into the finger");
  c.statement = "A free object of 0.2 kg, no gravity, its face on a resting patch of 8 x 100 N/m that is 1 mm in.";
  c.formula = "d'' = +lambda^2 d as printed, -lambda^2 d onto the object; lambda = sqrt(8 gamma / m)";
  for (const auto& make : {attracted, repelled})
    for (Run& run : on_both(make)) c.runs.push_back(std::move(run));
  return c;
}

}  // namespace handhold::catalogue
