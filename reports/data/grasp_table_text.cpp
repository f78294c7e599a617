// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/grasp_table_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/data/placing_text.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using compare::EngineGrasp;
using compare::GraspRow;

Body body_of(const GraspRow& row) {
  Body body;
  body.inertia.mass = row.mass;
  body.friction.mu_static = row.mu;
  return body;
}

std::string held_text(const EngineGrasp& grasp) {
  return fmt::format("{} {:.2f}/{:.2f}", grasp.trial.held ? "held" : "lost", grasp.trial.carried, grasp.trial.asked);
}

std::string length_text(const std::optional<double>& value) { return value ? readable(*value, "m") : "-"; }

nlohmann::json json_of(const EngineGrasp& grasp) {
  nlohmann::json out{
      {"engine", grasp.engine},         {"outcome", to_string(grasp.outcome)}, {"held", grasp.trial.held},
      {"carried", grasp.trial.carried}, {"asked", grasp.trial.asked},          {"drift", grasp.trial.drift},
      {"turned", grasp.trial.turned},   {"strength", grasp.trial.strength},    {"frame_cost", grasp.frame_cost}};
  if (grasp.dropped_at) out["dropped_at"] = *grasp.dropped_at;
  return out;
}

nlohmann::json json_of(const GraspRow& row) {
  nlohmann::json out{{"recording", row.recording}, {"object", row.object}, {"mass", row.mass}, {"mu_static", row.mu}};
  if (!row.placing) {
    out["refused"] = row.refused;
    return out;
  }
  const compare::TriedPlacement& best = row.placing->tried.front();
  out["placed"] = best.placement.report();
  out["thickness"] = best.placement.thickness;
  out["stiffness"] = best.contact.stiffness;
  out["poses"] = row.placing->poses;
  out["tried"] = row.placing->tried.size();
  out["steps"] = row.placing->steps;
  out["placing_seconds"] = row.placing_seconds;
  out["why"] = why_lost(*row.placing, body_of(row));
  for (const EngineGrasp& grasp : row.engines) out["engines"].push_back(json_of(grasp));
  if (row.horizon) out["horizon"] = *row.horizon;
  if (row.difference) out["difference"] = *row.difference;
  return out;
}

}  // namespace

std::string grasp_table_head(const std::vector<std::string>& engines) {
  std::string out = left("recording", 24) + left("object", 16) + left("taken at", 20);
  for (const std::string& engine : engines) out += left(engine + " [s]", 18);
  return out + left("apart", 10) + left("horizon", 9) + left("frame", 10) + "placing\n";
}

std::string grasp_row_text(const GraspRow& row) {
  std::string out = left(row.recording, 24) + left(row.object, 16);
  if (!row.placing) return out + "not placed\n" + summary_line("why", row.refused);
  const compare::TriedPlacement& best = row.placing->tried.front();
  out += left(fmt::format("{:.2f} s on {:.1f} mm", best.placement.closure, 1e3 * best.placement.thickness), 20);
  for (const EngineGrasp& grasp : row.engines) out += left(held_text(grasp), 18);
  out += left(length_text(row.difference), 10);
  out += left(row.horizon ? fmt::format("{:.2f} s", *row.horizon) : "-", 9);
  out += left(row.engines.empty() ? "-" : readable(row.engines.back().frame_cost, "s"), 10);
  out += fmt::format("{} of {}, {:.1f} s CPU\n", row.placing->tried.size(), row.placing->poses, row.placing_seconds);
  const std::string why = why_lost(*row.placing, body_of(row));
  return why.empty() ? out : out + summary_line("why", why);
}

std::string grasp_totals(const std::vector<GraspRow>& rows) {
  long placed = 0, held = 0, steps = 0, poses = 0;
  double worst = 0;
  for (const GraspRow& row : rows) {
    if (!row.placing) continue;
    ++placed;
    held += row.placing->tried.front().trial.held;
    steps += row.placing->steps;
    poses += row.placing->poses;
    worst = std::max(worst, row.placing_seconds);
  }
  return fmt::format(
      "{} pairs: {} placed, of which {} hold to the end of the grasp in the real-time path; {} poses and "
      "{} steps in all, at most {:.2f} s CPU a placing\n",
      rows.size(), placed, held, poses, steps, worst);
}

std::string grasp_table_json(const std::vector<GraspRow>& rows) {
  nlohmann::json out{{"grasps", nlohmann::json::array()}};
  for (const GraspRow& row : rows) out["grasps"].push_back(json_of(row));
  return out.dump(1) + "\n";
}

}  // namespace handhold::reports
