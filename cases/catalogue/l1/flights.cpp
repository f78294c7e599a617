// SPDX-License-Identifier: GPL-3.0-or-later
// A body flies, lands or tumbles: L1-A01 to A03, B02.

#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/landing.hpp"
#include "cases/closed_form/projectile.hpp"
#include "cases/closed_form/tops.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;

constexpr double mass = 0.2;

Case projectile() {
  const exact::Projectile p{};
  const double end = 0.4, apex = exact::apex_time(p);
  const Run flies =
      run("flies",
          [=] {
            RigidProblem problem = block(mass, {}, end);
            problem.supports.clear();
            problem.V_WB.v = {p.speed, 0, p.climb};
            return problem;
          },
          "L1: x = v t, z = v_z t - g t^2 / 2", polynomial(end, 2),
          {way("way along x", x_axis, end, exact::distance(p, end)), way("height", z_axis, end, exact::height(p, end)),
           speed("climb at the end", z_axis, end, exact::climb_at(p, end)),
           way("greatest height", z_axis, apex, exact::apex_height(p)),
           speed("climb at the top", z_axis, apex, 0, p.climb), energy_balance(0.2)});
  return {.id = "L1-A01",
          .title = "Projectile",
          .statement = "A body is thrown; nothing touches it.",
          .formula = "z = v_z t - g t^2 / 2",
          .runs = {flies}};
}

/// A free body with the given attitude R(t) and rates w_B(t).
template <class Top>
Run tumbles(const std::string& name, const Top& top, const Eigen::Vector3d& moments, double end, double grown) {
  std::vector<RigidClaim> claims;
  const Eigen::Vector3d start = exact::rates(top, 0);
  for (const double t : {std::floor(45 * end) / 90, end}) {
    const Eigen::Vector3d w = exact::attitude(top, t) * exact::rates(top, t);
    for (int i = 0; i < 3; ++i)
      claims.push_back(spin(fmt::format("spin about {} at t = {:.3g} s", "xyz"[i], t), Eigen::Vector3d::Unit(i), t,
                            w[i], 1, start.norm()));
  }
  claims.push_back(energy_balance(start.dot(moments.cwiseProduct(start)) / 2));
  claims.back().sensitivity = 2 * moments.maxCoeff() * start.norm();
  claims.back().why = "times the angular momentum";
  return run(
      name,
      [=] {
        RigidProblem p;
        p.mass = mass;
        p.inertia = moments.asDiagonal();
        p.V_WB.w = start;
        p.gravity.setZero();
        p.duration = end;
        return p;
      },
      "L1: R(t) w_B(t) of the free top (Landau and Lifshitz, Mechanics, sections 33, 36, 37)",
      controlled(grown * start.norm(), fmt::format("an attitude error of e turns spins by {:.3g} e; neighbouring "
                                                   "motions part {:.0f}-fold",
                                                   start.norm(), grown)),
      claims);
}

Case symmetric_top() {
  const exact::SymmetricTop can{}, disc{1e-4, 1.9e-4, 8, 2};
  return {
      .id = "L1-A02",
      .title = "Free symmetric top",
      .statement = "A can and a disc tumble freely.",
      .formula = "w1 + i w2 turns at (I3 - I1) / I1 w3",
      .runs = {tumbles("can", can, {4e-4, 4e-4, 1.5e-4}, 1.3, 10), tumbles("disc", disc, {1e-4, 1e-4, 1.9e-4}, 2, 10)}};
}

Case asymmetric_top() {
  const exact::AsymmetricTop box{}, racket{box.moments, 5, 4.01};
  // Near its middle axis a racket leaves the axis at w sqrt((I3 - I2)(I2 - I1) / (I1 I3)) and comes back to it.
  return {.id = "L1-A03",
          .title = "Free asymmetric top: the tennis racket",
          .statement = "A box tumbles freely; another spins near its middle axis and flips over and over.",
          .formula = "w = (A1 cn, A2 sn, A3 dn)(p t)",
          .runs = {tumbles("box", box, box.moments, 1.7, 10), tumbles("racket", racket, box.moments, 2.1, 100)}};
}

Run lands(const std::string& name, const exact::Landing& l, double palm) {
  const double t = exact::landing_time(l), v = exact::velocity_after(l), w = exact::spin_after(l), end = t + 0.02;
  const bool grips = exact::grips(l);
  const double slows = grips ? 0 : std::copysign(l.friction.mu_dynamic * g, v - l.radius * w);
  std::vector<RigidClaim> claims{
      event_time("landing", EventKind::touch, 1, t, exact::landing_speed(l)),
      speed_at("speed on the palm after", x_axis, EventKind::touch, 1, v, exact::landing_speed(l)),
      speed_at("speed of fall after", z_axis, EventKind::touch, 1, 0, exact::landing_speed(l)),
      way("way on the palm at the end", x_axis, end, l.velocity * t + v * (end - t) - slows * 0.02 * 0.02 / 2),
      speed("speed at the end", x_axis, end, v - slows * (end - t), exact::landing_speed(l)),
      event_count(EventKind::touch, 1),
      event_count(EventKind::breakaway, grips ? 0 : 1),
      mode(0, end, grips ? Mode::stick : Mode::slip),
      energy_balance(0.1)};
  if (grips) claims.push_back(dissipated(end, mass * exact::impact_loss_per_mass(l)));
  if (l.radius > 0) {
    RigidClaim after = spin("spin after", y_axis, 0, w, 1 / l.radius, 1 / l.radius);
    after.claim.measure.at = {};
    after.claim.measure.event = EventKind::touch;
    claims.push_back(after);
  }
  return run(
      name,
      [=] {
        RigidProblem p = l.radius > 0 ? ball(mass, l.radius, l.beta, 0, end) : block(mass, {}, end);
        p.supports[0].friction = l.friction;
        p.supports[0].motion = steady(palm * x_axis);
        p.X_WB.p.z() += l.height;
        p.V_WB.v.x() = palm + l.velocity;
        p.V_WB.w.y() = l.spin;
        return p;
      },
      "L1: plastic, J_n = m sqrt(2 g h); J_t = m |u| / (1 + 1/beta) within the cone, else mu_d J_n", polynomial(end, 4),
      claims);
}

Case landing() {
  const Friction friction{0.5, 0.4};
  const exact::Landing stays{.friction = friction}, slides{.velocity = 3, .friction = friction};
  const exact::Landing rolls{
      .height = 0.1, .velocity = 0.4, .spin = -10, .beta = 0.4, .radius = 0.03, .friction = friction};
  const exact::Landing skids{.velocity = 1, .spin = -60, .beta = 0.4, .radius = 0.03, .friction = friction};
  return {
      .id = "L1-B02",
      .title = "Landing askew",
      .statement = "A block or a spinning ball falls on a palm that rests or moves: a plastic impact with friction.",
      .formula = "J_t = min(m |u| / (1 + 1/beta), mu J_n)",
      .runs = {lands("block, stays", stays, 0), lands("block, slides on", slides, 0),
               lands("block, palm moves along", stays, 0.35), lands("ball, rolls at once", rolls, 0),
               lands("ball, skids on", skids, 0)}};
}

}  // namespace

std::vector<Case> rigid_flights() { return {projectile(), symmetric_top(), asymmetric_top(), landing()}; }

}  // namespace handhold::catalogue
