#include "reports/ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

/// Smallest of 1, 2, 5 times a power of ten that is not below `least`.
double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= least * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

std::vector<double> mantissas_in(double low, double high, const std::vector<double>& mantissas) {
  std::vector<double> out;
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  for (int decade = first; decade <= last; ++decade) {
    for (const double m : mantissas) {
      const double tick = m * std::pow(10, decade);
      if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) out.push_back(tick);
    }
  }
  return out;
}

/// How many decimals show the number, at most 6.
int decimals_of(double tick) {
  for (int d = 0; d < 6; ++d) {
    const double scaled = std::abs(tick) * std::pow(10, d);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * std::max(1.0, scaled)) return d;
  }
  return 6;
}

}  // namespace

std::vector<double> linear_ticks(double low, double high, int most) {
  if (!(low < high) || !std::isfinite(high - low)) return {};
  double step = round_step((high - low) / (most + 1));
  const auto first = [&] { return std::ceil(low / step - 1e-9); };
  const auto last = [&] { return std::floor(high / step + 1e-9); };
  while (last() - first() + 1 > most) step = round_step(step * 1.5);
  if (!(std::abs(first()) < 1e12)) return {};  // a range too narrow for labels
  std::vector<double> out;
  for (double i = first(); i <= last(); ++i) out.push_back(i == 0 ? 0 : i * step);
  return out;
}

std::vector<double> log_ticks(double low, double high, int most) {
  if (!(0 < low && low < high) || !std::isfinite(high)) return {};
  const auto limit = static_cast<std::size_t>(most);
  for (const std::vector<double>& mantissas : {std::vector<double>{1, 2, 5}, {1, 3}, {1}}) {
    const std::vector<double> out = mantissas_in(low, high, mantissas);
    if (out.size() <= limit) return out;
  }
  const std::vector<double> decades = mantissas_in(low, high, {1});
  const std::size_t every = (decades.size() + limit - 1) / limit;
  std::vector<double> out;
  for (std::size_t i = 0; i < decades.size(); i += every) out.push_back(decades[i]);
  return out;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks, bool logarithmic) {
  double largest = 0, smallest = INFINITY;
  int decimals = 0;
  for (const double tick : ticks) {
    largest = std::max(largest, std::abs(tick));
    if (tick != 0) smallest = std::min(smallest, std::abs(tick));
    decimals = std::max(decimals, decimals_of(tick));
  }
  const bool powers = largest >= 1e5 || smallest < 1e-4;
  std::vector<std::string> out;
  for (const double tick : ticks) {
    out.push_back(typographic(powers || logarithmic ? number(tick, 3) : fmt::format("{:.{}f}", tick, decimals)));
  }
  return out;
}

}  // namespace handhold::reports
