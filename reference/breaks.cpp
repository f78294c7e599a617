// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/breaks.hpp"

#include <algorithm>

#include "cases/model/defect.hpp"

namespace handhold::reference {

std::vector<double> breaks_of(const Scene& scene) {
  std::vector<double> breaks;
  const auto add = [&](double t) {
    if (t > 0 && t < scene.duration) breaks.push_back(t);
  };
  for (const Body& body : scene.bodies) add(DEFECT(release_is_no_break, body.held_until, -1.0));
  for (const Hand& hand : scene.hands)
    for (const Interval& i : hand.motion->presence()) {
      add(i.begin);
      add(i.end);
    }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

}  // namespace handhold::reference
