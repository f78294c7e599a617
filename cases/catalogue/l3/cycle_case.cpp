// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr double shallow = 0.002, deep = 0.005, shear = 0.002;  // [m]
constexpr double tiny_offset = 1e-16;                           // eps -> 0
constexpr double gap = 1e-14;                                   // of break-away, as a share of its lag

/// Lag and depth of the hand, one place a frame. Forces are linear between them, but for break-away, which lies between
/// two that are 2 gap apart: the trapezoidal rule is exact.
std::array<Eigen::Vector2d, 8> places() {
  const double first = Friction{}.mu_static * shallow;
  return {{{0, 0},
           {0, shallow},
           {first * (1 - gap), shallow},
           {first * (1 + gap), shallow},
           {shear, shallow},
           {shear, deep},
           {0, deep},
           {0, 0}}};
}

PrintedProblem scene() {
  PrintedProblem p = on_a_face(
      Ground::planes, {.offset = tiny_offset, .frame = 1}, [](double) { return 0.0; }, int(places().size()) - 1);
  p.phalanges.front().pose = [way = places()](double t) {
    const Eigen::Vector2d& at = way[std::size_t(std::lround(t))];
    return Pose{.p = {at.x(), 0, -at.y()}};
  };
  return p;
}

}  // namespace

Case printed_cycle_case() {
  Case c = printed_case("L3-12", "Press, shear, release gives energy");
  c.statement = "One sample, quasi-static: 2 mm in, sheared by 2 mm until it slips, 5 mm in, sheared back, out.";
  c.formula = "gain gamma (1 - mu_d) (s^2 - (mu_s d1)^2)/2 a cycle (eps -> 0); Coulomb takes energy";
  const closed_form::PrintedFace face{.depth = shallow};
  const double gain = cycle_gain(face, shear);
  // Three frames slip or stick at a lag that the rays before have shortened; the break-away's jump is 2 gap wide.
  const double error = face.gamma * shear * shear * (3 * tiny_offset / shallow + 2 * gap);
  Run run{.name = "cycle", .problem = scene};
  run.claims = {
      printed_claim("energy gained", gain, "gamma (1 - mu_d) (s^2 - (mu_s d1)^2)/2",
                    {.kind = Measure::Kind::work, .at = 7, .from = 0},
                    {.value = error / gain,
                     .relative = true,
                     .reason = "eps/d of the lag is lost in each of three frames, + the width of the break-away"}),
      printed_count("slips when sheared", 1, "s > mu_s d1", count_at(4, Mode::slip)),
      printed_count("sticks when pressed", 1, "s <= mu_s d2", count_at(5, Mode::stick))};
  c.runs = {run};
  return c;
}

}  // namespace handhold::catalogue
