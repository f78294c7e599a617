// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/invariants.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace handhold::reference {
namespace {

constexpr double slack = 1000;  // in units of the accuracy: drift over accuracy-sized steps

}  // namespace

bool check_invariants(const Contacts& contacts, const Modes& modes, const Evaluation& e, double accuracy, double t) {
  const double length = slack * accuracy;  // [m] and [m/s]
  const auto broken = [&](int slot, const char* what) {
    throw std::logic_error(fmt::format("{}: {} at t = {:.12g} s", contacts.describe(slot), what, t));
  };
  if (e.touch > 0) {
    const Element& law = contacts.element(e.touch_slot);
    if (e.touch > length * (1 + law.damping / law.stiffness)) broken(e.touch_slot, "apart, but inside");
  }
  for (int slot = 0; slot < contacts.slots(); ++slot) {
    const Mode mode = modes.mode[std::size_t(slot)];
    if (mode == Mode::apart) continue;
    const Element& law = contacts.element(slot);
    const Sample& s = e.samples[std::size_t(slot)];
    const double force = length * (law.stiffness + law.damping) * (1 + law.friction.mu_static);
    if (s.gap > force) broken(slot, "in contact, but pulling");
    const bool undamped_slip = mode == Mode::slip && law.damping == 0;
    if (s.friction > (undamped_slip ? length : force)) broken(slot, "outside its friction cone, or slipping backwards");
    const Response& r = s.response;
    if (undamped_slip && std::abs(r.lag.norm() - law.friction.mu_dynamic * r.depth) > length)
      broken(slot, "slipping off its cone");
  }
  return e.touch > 0 || e.release > 0 || e.friction > 0 || e.edge > 0;
}

}  // namespace handhold::reference
