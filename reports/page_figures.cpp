#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"
#include "reports/page_parts.hpp"
#include "reports/svg_plot.hpp"

namespace handhold::reports {
namespace {

struct Label {
  std::string name{}, unit{};
};

/// "slip [m]" is "slip" in "m".
Label split(const std::string& label) {
  const std::size_t open = label.rfind(" ["), close = label.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {label, ""};
  return {label.substr(0, open), label.substr(open + 2, close - open - 2)};
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

double largest(const std::vector<double>& values) {
  double out = 0;
  for (const double v : values) out = std::isfinite(v) ? std::max(out, std::abs(v)) : out;
  return out;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

std::vector<double> residual(const std::vector<double>& values, const std::vector<double>& truth) {
  std::vector<double> out(std::min(values.size(), truth.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[i] - truth[i];
  return out;
}

Panel curve_panel(const compare::CurveData& curve, const Label& label) {
  const Scale scale = readable_scale(largest(curve.truth), label.unit);
  Panel panel{with_unit(label.name, scale.unit), "", 210, {}};
  panel.series.push_back({"truth", Role::truth, curve.t, scaled(curve.truth, scale.factor)});
  panel.series.push_back({"reference", Role::reference, curve.t, scaled(curve.reference, scale.factor)});
  panel.series.push_back({"real time", Role::realtime, curve.t, scaled(curve.realtime, scale.factor)});
  return panel;
}

/// One engine's distance from the truth in a scale of its own: beside the curve itself 1 % is invisible.
Panel residual_panel(const std::string& engine, Role role, const compare::CurveData& curve,
                     const std::vector<double>& values, const Label& label) {
  const std::vector<double> difference = residual(values, curve.truth);
  const double most = largest(difference);
  const Scale scale = readable_scale(most, label.unit);
  Panel panel{with_unit(engine + " − truth", scale.unit), "largest " + readable(most, label.unit), 74, {}};
  if (!curve.t.empty()) panel.series.push_back({"zero", Role::guide, {curve.t.front(), curve.t.back()}, {0, 0}});
  panel.series.push_back({engine, role, curve.t, scaled(difference, scale.factor)});
  return panel;
}

std::string legend(const std::vector<std::pair<Role, std::string>>& entries, bool markers) {
  std::string out = "<ul class=\"legend\">";
  for (const auto& [role, words] : entries)
    out += fmt::format("<li>{}{}</li>", svg_swatch(role, markers && role != Role::guide), escape(words));
  return out + "</ul>";
}

/// The fitted line, through the centre of the points, as two points.
Series fitted_line(const compare::OrderStudy& study, double slope, const std::string& label, Role role, double x_factor,
                   double y_factor) {
  double x = 0, y = 0;
  int count = 0;
  Series line{label, role, {}, {}};
  for (std::size_t i = 0; i < std::min(study.substep.size(), study.error.size()); ++i) {
    if (!(study.substep[i] > 0 && study.error[i] > 0) || !std::isfinite(study.error[i])) continue;
    x += std::log(study.substep[i]);
    y += std::log(study.error[i]);
    ++count;
  }
  if (count < 2 || !std::isfinite(slope)) return line;
  const auto [low, high] = std::minmax_element(study.substep.begin(), study.substep.end());
  for (const double dt : {*low, *high}) {
    line.x.push_back(dt * x_factor);
    line.y.push_back(std::exp(y / count + slope * (std::log(dt) - x / count)) * y_factor);
  }
  return line;
}

}  // namespace

std::string curve_figure(const compare::RunResult& run, const std::string& id) {
  const compare::CurveData& curve = run.curve;
  if (curve.t.empty()) return "";
  const Label label = split(curve.label);
  Figure figure{id, fmt::format("{} against time, {}", label.name, run.name), "", "time [s]", false, {}};
  figure.description = fmt::format(
      "Truth, reference and real-time path. Below, each engine's difference from the truth: reference at most {}, real "
      "time at most {}.",
      readable(largest(residual(curve.reference, curve.truth)), label.unit),
      readable(largest(residual(curve.realtime, curve.truth)), label.unit));
  figure.panels.push_back(curve_panel(curve, label));
  if (!curve.reference.empty())
    figure.panels.push_back(residual_panel("reference", Role::reference, curve, curve.reference, label));
  if (!curve.realtime.empty())
    figure.panels.push_back(residual_panel("real time", Role::realtime, curve, curve.realtime, label));
  return fmt::format(
      "<figure><figcaption><h4>{} against time</h4>{}</figcaption>{}</figure>", escape(label.name),
      legend({{Role::truth, "truth"}, {Role::reference, "reference"}, {Role::realtime, "real time"}}, false),
      svg(figure));
}

std::string order_figure(const compare::Finding& finding, const std::string& id) {
  if (!finding.study || finding.study->substep.empty()) return "";
  const compare::OrderStudy& study = *finding.study;
  const catalogue::Expectation& e = finding.expectation;
  const double x_factor = 1e3;  // s to ms
  const Scale scale = readable_scale(largest(study.error), e.unit);
  const std::string slope = typographic(with_error(study.order.slope, study.order.standard_error));

  Panel panel{with_unit("error of " + e.quantity, scale.unit), "", 300, {}};
  const double guide_slope = 1;  // what a first-order method shows
  panel.series.push_back(fitted_line(study, guide_slope, "order 1", Role::guide, x_factor, scale.factor));
  panel.series.push_back(fitted_line(study, study.order.slope, "fit", Role::realtime, x_factor, scale.factor));
  Series points{"real time", Role::realtime, {}, {}, true};
  for (std::size_t i = 0; i < std::min(study.substep.size(), study.error.size()); ++i) {
    points.x.insert(points.x.end(), {study.substep[i] * x_factor, NAN});  // gaps: marks only, the line is the fit
    points.y.insert(points.y.end(), {study.error[i] * scale.factor, NAN});
  }
  panel.series.push_back(points);

  const Figure figure{id,
                      fmt::format("Error of {} against sub-step", e.quantity),
                      fmt::format("Both axes logarithmic. Observed order {}.", slope),
                      "sub-step [ms]",
                      true,
                      {panel}};
  return fmt::format("<figure><figcaption><h4>Error of {} against sub-step: order {}</h4>{}</figcaption>{}</figure>",
                     escape(e.quantity), escape(slope),
                     legend({{Role::realtime, "real time and fit"}, {Role::guide, "order 1"}}, true), svg(figure));
}

}  // namespace handhold::reports
