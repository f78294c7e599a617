// SPDX-License-Identifier: GPL-3.0-or-later
// What happens at events to an anchor at an edge or corner, and what the law does not decide there.

#include "reference/contacts.hpp"
#include "reference/settling_slot.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

constexpr double grazing = 1e-6;  // slope towards an edge, above the noise of an anchor over a tenth of a millimetre
constexpr double alike = 1e-9;    // of two forces: above the noise of the integration

}  // namespace

/// A touch that the law does not decide: says so, and takes on a convex edge the face that is pressed more lightly, as
/// the law has it everywhere else on the edge.
void Contacts::decide(const Slot& x, Foot& foot, Settling& now) const {
  if (foot.depth > x.element.shallow) {
    if (x.surface.between_sheets(x.s.p_O, foot, x.element.shallow))
      now.undecided.push_back({int(x.index), "appears inside as near to one sheet as to another"});
    return;
  }
  if (!x.surface.convex_crease(foot, x.element.shallow).caught()) return;
  now.undecided.push_back({int(x.index), "touches on a convex edge, where either face may be taken"});
  const Foothold on = x.surface.convex_crease(foot, touch_depth);
  if (!on.caught()) return;
  const Way way = x.surface.way(x.undamped() ? x.s.v_O : x.pull(foot.p_O), on);
  if (!(way.N > 0) || way.hold.caught()) return;
  foot.hold = way.hold;
  foot.n_O = way.n;
}

/// c = 0: a lag outside the cone jumps to where it is on it.
void Contacts::slip_to_cone(Slot& x, const Vector3d& direction) {
  const double mu = x.element.friction.mu_dynamic;
  if (const std::optional<Place> place = x.surface.slide(x.s.p_O, x.place(), mu)) {
    x.anchor = place->p_O;
    x.hold = place->hold;
  } else {
    x.anchor = with_lag(x.index, x.s.p_O, x.anchor, x.hold, direction, mu, 0);
  }
}

/// Slips on along a way; where a hollow edge or corner holds it, it rests.
void Contacts::take_way(Slot& x, const Way& way) {
  x.hold = way.hold;
  if (x.undamped()) slip_to_cone(x, way.w);
  if (!x.hold.caught()) return;
  const Way at = x.surface.way(x.pull(), x.hold);
  const double cone = x.element.friction.mu_dynamic * at.N, on_it = x.undamped() ? 1 - 1e-9 : 1;
  if (at.hold.caught() && !(at.w.norm() > on_it * cone)) x.enter(Mode::stick, EventKind::restick);
}

/// At a convex crease, when w led there.
void Contacts::say_undecided(const Slot& x, const Way& way, const Vector3d& w, Settling& now) const {
  if (!x.surface.convex_crease({x.anchor, {}, 0, x.hold}, touch_depth).caught()) return;
  const Vector3d u = x.hold.side >= 0 ? x.surface.along_edge(w, x.hold).edge : Vector3d::Zero();
  if (x.hold.side >= 0 && (w - w.dot(u) * u).norm() <= grazing * w.norm())
    now.undecided.push_back({int(x.index), "grazes along a convex edge: it goes on beyond it"});
  if (x.hold.corner >= 0 && way.rival <= alike * x.pull().norm())
    now.undecided.push_back({int(x.index), "two ways lead off a corner that press alike: the first is taken"});
}

/// The anchor has come to the border of its face, to the end of its edge, or leaves its edge.
void Contacts::go_over(Slot& x, Settling& now) {
  const bool at_border = x.surface.overrun(x.anchor, x.hold) > 0;
  const Vector3d w = x.s.response.trial;
  if (at_border) {
    const Place border = x.surface.border(x.place());
    x.anchor = border.p_O;
    x.hold = border.hold;
    if (!x.hold.caught()) {
      if (x.undamped()) slip_to_cone(x, x.spring());
      return;
    }
  }
  const Way way = x.surface.way(x.pull(), x.hold);
  if (at_border) say_undecided(x, way, w, now);
  if (way.N > 0)
    take_way(x, way);
  else
    release(x);
}

}  // namespace handhold::reference
