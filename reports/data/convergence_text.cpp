// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/convergence_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using compare::ConvergenceRun;
using compare::Gap;
using compare::Order;

constexpr double relative_floor = 1e-6;  // of a rigid limit: what the runs themselves err

std::string sci(double value) { return std::isnan(value) ? "none" : fmt::format("{:.1e}", value); }

std::string columns(const std::string& name, const std::string& position, const std::string& rotation,
                    const std::string& time, const std::string& events, const std::string& steps,
                    const std::string& cost, const std::string& truth) {
  return "  " + left(name, 18) + right(position, 11) + right(rotation, 12) + right(time, 12) + right(events, 12) +
         right(steps, 9) + right(cost, 10) + right(truth, 13);
}

std::string events_of(const ConvergenceRun& run) {
  const std::string count = fmt::format("{}", run.recording.events.size());
  return run.error.unlike_samples == 0 ? count : fmt::format("{} ({})!", count, run.error.unlike_samples);
}

std::string verdict(const ConvergenceRun& run) {
  if (run.recording.outcome != Outcome::complete)
    return fmt::format("  {}: {}", to_string(run.recording.outcome), one_line(run.recording.note));
  if (!run.setting.promise) return "";
  return run.kept ? "  kept" : "  BROKEN";
}

std::string order_text(const Order& order) {
  return std::isnan(order.slope) ? "none" : with_error(order.slope, order.standard_error);
}

std::string gap_text(const Gap& gap) {
  const std::string events =
      gap.unlike_samples == 0 ? "the same events" : fmt::format("{} samples with other events", gap.unlike_samples);
  return fmt::format("{} m, {} rad, {} s, {}", sci(gap.position), sci(gap.rotation), sci(gap.event_time), events);
}

}  // namespace

std::string convergence_heading() {
  return columns("setting", "position", "rotation", "event time", "events", "steps", "CPU s/s", "closed form") + "\n" +
         columns("", "m", "rad", "s", "", "", "", "of its limit") + "\n";
}

std::string convergence_rows(const NamedConvergence& named) {
  std::string out = fmt::format("{}: {}\n", one_line(named.name), one_line(named.what));
  for (std::size_t i = 0; i < named.study.runs.size(); ++i) {
    const ConvergenceRun& run = named.study.runs[i];
    const bool last = i + 1 == named.study.runs.size();
    const auto about = [&](double error) { return (last ? "~" : "") + sci(error); };  // an estimate by the slope
    const std::string truth = i < named.closed_form.size() ? sci(named.closed_form[i]) : "";
    out += columns(run.setting.name, about(run.error.position), about(run.error.rotation), about(run.error.event_time),
                   events_of(run), fmt::format("{}", run.steps), fmt::format("{:.3g}", run.cost), truth) +
           verdict(run) + "\n";
  }
  const compare::SelfConvergence& study = named.study;
  out += fmt::format("  order             position {}, rotation {}, event times {}\n", order_text(study.position),
                     order_text(study.rotation), order_text(study.event_time));
  for (const std::string& line : named.closed_form_lines) out += "  closed form       " + line + "\n";
  for (std::size_t i = 0; i < named.independent.size(); ++i)
    out += fmt::format("  independent       {}: {}\n", study.runs[i].setting.name, gap_text(named.independent[i]));
  return out;
}

bool reaches_truth(const catalogue::LimitScene& scene, const compare::Extrapolation& result) {
  const double allowed = std::max(result.error, relative_floor * std::abs(scene.truth));
  return result.regular && std::abs(result.limit - scene.truth) <= allowed;
}

std::string stiffness_rows(const catalogue::LimitScene& scene, const compare::Extrapolation& result) {
  std::string out = fmt::format("{}: {}\n", scene.name, scene.what);
  for (std::size_t i = 0; i < result.value.size(); ++i)
    out += fmt::format("  {:>8g} N/m a sample   {} {:.6e} {}   off L1 by {:9.1e}\n", result.stiffness[i],
                       scene.quantity, result.value[i], scene.unit, result.value[i] - scene.truth);
  out += fmt::format("  rigid limit             {} {:.6e} +- {:.1e} {}, observed exponent {}{}\n", scene.quantity,
                     result.limit, result.error, scene.unit,
                     std::isnan(result.exponent) ? "none" : fmt::format("{:.3f}", result.exponent),
                     result.regular ? "" : " (not continued: no 1/K is seen)");
  out += fmt::format("  closed form             {} {:.6e} {} ({}), off by {:.1e}: {}\n", scene.quantity, scene.truth,
                     scene.unit, scene.source, result.limit - scene.truth,
                     reaches_truth(scene, result) ? "within the estimate" : "OUTSIDE the estimate");
  return out;
}

}  // namespace handhold::reports
