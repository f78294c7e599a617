// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/baseline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace handhold::compare {
namespace {

// With the processor's fused multiply-add switched off, all but a few residuals of energy moved by less than 1e-9 of
// themselves; those are rounding and nothing else, and moved by 2e-6 of their limits.
constexpr double rounding = 1e-9, of_limit = 1e-5;

/// The limit in the unit of the value.
double width(const Measured& m) { return m.relative ? m.limit * std::abs(m.truth) : m.limit; }

/// More than rounding, and than `noise`.
bool differs(double a, double b, double scale, double noise = 0) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
  return std::abs(a - b) > std::max(rounding * scale, noise);
}

std::optional<Movement> movement(const Measured& before, const Measured& now) {
  if (differs(before.limit, now.limit, before.limit) || before.relative != now.relative)
    return width(now) > width(before) ? Movement::looser : Movement::tighter;
  if (differs(before.truth, now.truth, std::max(std::abs(before.truth), width(before)))) return Movement::other_truth;
  const double scale = std::max(std::abs(before.truth), std::abs(before.value));
  if (!differs(before.value, now.value, scale, std::max(of_limit * width(before), before.uncertainty))) return {};
  return distance(now) < distance(before) ? Movement::towards : Movement::away;
}

/// "10 times as far from the truth"
std::string how_far(const Change& change) {
  const double ratio = distance(change.now) / distance(change.before);
  if (std::isnan(ratio) || std::isinf(ratio)) return fmt::format("{} the truth", to_string(change.movement));
  return fmt::format("{:.3g} times as far from the truth", ratio);
}

bool has_orders(const Baseline& baseline) {
  return std::any_of(baseline.begin(), baseline.end(), [](const auto& gate) { return gate.first.order; });
}

}  // namespace

std::string to_string(Movement movement) {
  switch (movement) {
    case Movement::gone:
      return "gone";
    case Movement::added:
      return "added";
    case Movement::looser:
      return "looser limit";
    case Movement::tighter:
      return "tighter limit";
    case Movement::other_truth:
      return "another truth";
    case Movement::away:
      return "away from";
    case Movement::towards:
      return "towards";
  }
  return "";
}

double distance(const Measured& measured) {
  const double error = std::abs(measured.value - measured.truth);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

std::vector<Change> changes(const Baseline& before, const Baseline& now) {
  std::vector<Change> out;
  const bool orders = has_orders(now);
  for (const auto& [name, known] : before) {
    if (name.order && !orders) continue;
    const auto found = now.find(name);
    if (found == now.end()) {
      out.push_back({name, Movement::gone, known, {}});
    } else if (const auto moved = movement(known, found->second)) {
      out.push_back({name, *moved, known, found->second});
    }
  }
  for (const auto& [name, measured] : now)
    if (!before.contains(name)) out.push_back({name, Movement::added, {}, measured});
  return out;
}

std::string sentence(const Change& change) {
  const GateName& gate = change.gate;
  const std::string where = fmt::format("{}/{}, {}, {}{}", gate.of_case, gate.run, gate.claim, gate.engine,
                                        gate.order ? " (order of accuracy)" : "");
  const Measured &before = change.before, &now = change.now;
  switch (change.movement) {
    case Movement::gone:
    case Movement::added:
      return fmt::format("{}: {}", where, to_string(change.movement));
    case Movement::looser:
    case Movement::tighter:
      return fmt::format("{}: limit {:.4g} -> {:.4g}, {}", where, before.limit, now.limit,
                         change.movement == Movement::looser ? "looser" : "tighter");
    case Movement::other_truth:
      return fmt::format("{}: truth {:.12g} -> {:.12g}", where, before.truth, now.truth);
    default:
      break;
  }
  return fmt::format("{}: {:.12g} -> {:.12g}, {} {:.12g} ({:.2g} -> {:.2g} of the limit)", where, before.value,
                     now.value, how_far(change), now.truth, distance(before) / width(now), distance(now) / width(now));
}

std::string summary(const std::vector<Change>& changes) {
  std::map<Movement, int> counts;
  for (const Change& change : changes) ++counts[change.movement];
  std::vector<std::string> parts;
  for (const auto& [movement, words] : {std::pair{Movement::away, "moved away from the truth"},
                                        {Movement::towards, "moved towards the truth"},
                                        {Movement::other_truth, "have another truth"},
                                        {Movement::looser, "have a looser limit"},
                                        {Movement::tighter, "have a tighter limit"},
                                        {Movement::gone, "are gone"},
                                        {Movement::added, "are new"}})
    if (counts[movement] > 0) parts.push_back(fmt::format("{} {}", counts[movement], words));
  return parts.empty() ? "nothing moved" : fmt::format("gates: {}", fmt::join(parts, ", "));
}

}  // namespace handhold::compare
