// SPDX-License-Identifier: Apache-2.0
#include "cases/model/printed_law.hpp"

#include <cmath>
#include <string>

#include "cases/model/input_error.hpp"
#include "cases/model/text.hpp"

namespace handhold::printed {
namespace {

void require(bool holds, const std::string& what, double given, const std::string& rule) {
  if (!holds) throw InputError(sentence("paper law: ", what, "=", given, ": ", rule));
}

}  // namespace

void validate(const Options& o) {
  const auto finite = [](double x) { return std::isfinite(x); };
  require(finite(o.stiffness) && o.stiffness > 0, "stiffness", o.stiffness, "must be above 0 (the paper has 100 N/m)");
  require(finite(o.damping) && o.damping >= 0, "damping", o.damping, "must not be negative (the paper has 0)");
  require(finite(o.ray_offset) && o.ray_offset > 0, "ray_offset", o.ray_offset, "must be above 0 (try 0.001 m)");
  require(std::abs(o.turned_away) <= 1, "turned_away", o.turned_away, "must be a cosine (0 is a right angle)");
  require(finite(o.contact_offset) && o.contact_offset >= 0, "contact_offset", o.contact_offset,
          "must not be negative (try 0.002 m)");
}

Options as_printed() {
  Options o;
  o.sign = Sign::as_printed;
  o.point = Point::centroid;
  o.gate = Gate::none;
  o.apart_anchor = ApartAnchor::stays;
  return o;
}

Options coulomb() {
  Options o;
  o.slip_force = SlipForce::capped;
  o.slip_state = SlipState::stateful;
  o.anchor_update = AnchorUpdate::cone;
  return o;
}

}  // namespace handhold::printed
