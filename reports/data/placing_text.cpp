// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/placing_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using compare::GraspTrial;

std::string fate(const GraspTrial& trial) {
  const std::string moved =
      fmt::format("drifts {}, turns {:.0f} degrees", readable(trial.drift, "m"), trial.turned * 180 / M_PI);
  if (trial.held) return fmt::format("holds for the {} s of the grasp, {}", number(trial.asked, 3), moved);
  return fmt::format("lost after {} s of {} s", number(trial.carried, 3), number(trial.asked, 3));
}

/// What the numbers of the trial say first.
std::string reason(const GraspTrial& trial, const Body& body) {
  const std::string carries =
      fmt::format("this grip carries {:.2f} N at mu {:.2g}", trial.strength, body.friction.mu_static);
  if (trial.asked <= 0) return "the support outlasts the recorded grasp";
  if (trial.strength < trial.weight) return fmt::format("weight {:.2f} N, {}", trial.weight, carries);
  if (trial.strength < trial.load)
    return fmt::format("weight {:.2f} N and up to {:.2f} N with the hand's acceleration, {}", trial.weight, trial.load,
                       carries);
  if (trial.carried <= 0)
    return fmt::format("weight {:.2f} N, {}, but it is out of the grip as the support ends", trial.weight, carries);
  return fmt::format("weight {:.2f} N, {}, but it moved {} and turned {:.0f} degrees in the hand before it was lost",
                     trial.weight, carries, readable(trial.drift, "m"), trial.turned * 180 / M_PI);
}

std::string cure(const compare::Remedy& remedy) {
  std::string text;
  if (remedy.stiffness) text += fmt::format("at stiffness {:.3g} N/m", *remedy.stiffness);
  if (remedy.mass) text += fmt::format("{}at {:.3g} g", text.empty() ? "" : " or ", 1e3 * *remedy.mass);
  return text.empty() ? "no stiffness up to 64 times this one and no mass down to a 64th would hold in this grip"
                      : "it would hold " + text;
}

}  // namespace

std::string why_lost(const compare::Placing& placing, const Body& body) {
  const compare::TriedPlacement& best = placing.tried.front();
  if (best.trial.held) return "";
  const double excess = best.placement.excess;
  const std::string too_far =
      excess > 0.005 ? fmt::format("; the hand closes {:.0f} mm a side too far for it", 1e3 * excess) : "";
  return reason(best.trial, body) + too_far + (placing.remedy ? "; " + cure(*placing.remedy) : "");
}

std::string placing_text(const compare::Placing& placing, const Body& body) {
  const compare::TriedPlacement& best = placing.tried.front();
  std::string out = summary_line("placed", best.placement.report());
  const auto held =
      std::count_if(placing.tried.begin(), placing.tried.end(), [](const auto& t) { return t.trial.held; });
  out += summary_line("tried", fmt::format("{} poses looked at, the best {} played for the length of the grasp ({} "
                                           "steps): {} hold",
                                           placing.poses, placing.tried.size(), placing.steps, held));
  out += summary_line("", "this one " + fate(best.trial));
  out += summary_line("sub-steps", fmt::format("{} a frame: the object's fastest motion on its grip is {:.0f} rad/s",
                                               best.trial.substeps, best.trial.fastest));
  if (!best.trial.held) out += summary_line("why", why_lost(placing, body));
  if (placing.tried.size() > 1) {
    const compare::TriedPlacement& second = placing.tried[1];
    out += summary_line("second best", fate(second.trial) + "; " + second.placement.report());
  }
  return out;
}

}  // namespace handhold::reports
