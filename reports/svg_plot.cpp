#include "reports/svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "reports/data/text.hpp"
#include "reports/ticks.hpp"

namespace handhold::reports {
namespace {

// The view box; the page scales it to its column and enlarges its text on small screens.
constexpr double view_width = 560, left_margin = 74, right_margin = 18, label_height = 40, axis_height = 52;
constexpr std::size_t most_points = 800;

/// One axis: data to pixels.
struct Axis {
  double low{}, high{};    // data
  double first{}, last{};  // pixels
  bool logarithmic{};

  [[nodiscard]] double operator()(double value) const {
    const double share = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return first + share * (last - first);
  }
  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
};

struct Range {
  double low{INFINITY}, high{-INFINITY};
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

bool usable(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

Range range_of(const std::vector<Panel>& panels, bool logarithmic, bool of_x) {
  Range out;
  for (const Panel& panel : panels) {
    for (const Series& series : panel.series) {
      const std::size_t count = std::min(series.x.size(), series.y.size());
      for (std::size_t i = 0; i < count; ++i) {
        if (usable(series.x[i], logarithmic) && usable(series.y[i], logarithmic))
          out.add(of_x ? series.x[i] : series.y[i]);
      }
    }
  }
  return out;
}

/// A range with room around the data; never empty, never of zero width.
Range padded(Range range, bool logarithmic, double share) {
  if (range.empty()) return logarithmic ? Range{0.1, 1} : Range{0, 1};
  if (logarithmic) {
    const double room = std::max(std::pow(range.high / range.low, share), range.high > range.low ? 1.0 : 2.0);
    return {range.low / room, range.high * room};
  }
  const double span = range.high - range.low;
  const double least = std::max(std::abs(range.low), std::abs(range.high)) * 1e-12;  // constant but for rounding
  if (span <= least) {
    const double room = range.high == 0 ? 1 : std::abs(range.high) * 0.1;
    return {range.low - room, range.high + room};
  }
  return {range.low - share * span, range.high + share * span};
}

std::vector<double> ticks(const Axis& axis, int most) {
  return axis.logarithmic ? log_ticks(axis.low, axis.high, most) : linear_ticks(axis.low, axis.high, most);
}

std::string_view css(Role role) {
  switch (role) {
    case Role::truth:
      return "truth";
    case Role::reference:
      return "reference";
    case Role::realtime:
      return "realtime";
    case Role::guide:
      return "guide";
  }
  return "";
}

/// A mark of its own shape a role, so that curves differ without colour.
std::string mark(Role role, double x, double y) {
  switch (role) {
    case Role::reference:
      return fmt::format("M{:.1f} {:.1f}h7v7h-7z", x - 3.5, y - 3.5);
    case Role::realtime:
      return fmt::format("M{0:.1f} {1:.1f}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", x - 4, y);
    default:
      return fmt::format("M{:.1f} {:.1f}l4 7h-8z", x, y - 4.5);
  }
}

struct Pixel {
  double x{}, y{};
};

/// Lines of pixels; a new one after every gap.
std::vector<std::vector<Pixel>> strokes(const Series& series, const Axis& x, const Axis& y) {
  std::vector<std::vector<Pixel>> out(1);
  const std::size_t count = std::min(series.x.size(), series.y.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (x.shows(series.x[i]) && y.shows(series.y[i])) {
      out.back().push_back({x(series.x[i]), y(series.y[i])});
    } else if (!out.back().empty()) {
      out.emplace_back();
    }
  }
  return out;
}

/// Keeps the lowest and highest point of every bucket, so that no spike is lost.
std::vector<Pixel> thinned(const std::vector<Pixel>& points) {
  if (points.size() <= most_points) return points;
  std::vector<Pixel> out;
  const std::size_t bucket = 2 * ((points.size() + most_points - 1) / most_points);
  const auto lower = [](const Pixel& a, const Pixel& b) { return a.y < b.y; };
  for (std::size_t i = 0; i < points.size(); i += bucket) {
    const auto begin = points.begin() + static_cast<long>(i);
    const auto end = points.begin() + static_cast<long>(std::min(i + bucket, points.size()));
    auto [low, high] = std::minmax_element(begin, end, lower);
    if (high < low) std::swap(low, high);
    out.push_back(*low);
    if (high != low) out.push_back(*high);
  }
  return out;
}

std::string curve(const Series& series, const Axis& x, const Axis& y) {
  std::string line, marks;
  for (const std::vector<Pixel>& stroke : strokes(series, x, y)) {
    char command = 'M';
    for (const Pixel& p : thinned(stroke)) {
      line += fmt::format("{}{:.1f} {:.1f}", command, p.x, p.y);
      if (series.markers || stroke.size() == 1) marks += mark(series.role, p.x, p.y);  // a lone point has no line
      command = 'L';
    }
  }
  std::string out;
  if (!line.empty()) out += fmt::format("<path class=\"line {}\" d=\"{}\"/>", css(series.role), line);
  if (!marks.empty()) out += fmt::format("<path class=\"mark {}\" d=\"{}\"/>", css(series.role), marks);
  return out;
}

std::string text(double x, double y, std::string_view anchor, std::string_view style, std::string_view words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>", x, y, anchor, style,
                     escape(words));
}

std::string grid(const Axis& x, const Axis& y, bool with_x_labels) {
  std::string lines, labels;
  const std::vector<double> x_ticks = ticks(x, 6), y_ticks = ticks(y, y.first - y.last > 120 ? 6 : 4);
  const std::vector<std::string> x_text = tick_labels(x_ticks, x.logarithmic),
                                 y_text = tick_labels(y_ticks, y.logarithmic);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    lines += fmt::format("M{:.1f} {:.1f}V{:.1f}", x(x_ticks[i]), y.last, y.first);
    if (with_x_labels) labels += text(x(x_ticks[i]), y.first + 19, "middle", "tick", x_text[i]);
  }
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    lines += fmt::format("M{:.1f} {:.1f}H{:.1f}", x.first, y(y_ticks[i]), x.last);
    labels += text(x.first - 8, y(y_ticks[i]) + 4.5, "end", "tick", y_text[i]);
  }
  const std::string frame =
      fmt::format("<path class=\"axis\" d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\"/>", x.first, y.last, y.first, x.last);
  return fmt::format("<path class=\"grid\" d=\"{}\"/>{}{}", lines, frame, labels);
}

std::string panel_svg(const Panel& panel, const Axis& x, double top, bool logarithmic, bool last) {
  const Range data = range_of({panel}, logarithmic, false);
  const Range range = padded(data, logarithmic, 0.08);
  const Axis y{range.low, range.high, top + label_height + panel.height, top + label_height, logarithmic};
  std::string out = text(4, top + 27, "start", "label", panel.y_label);
  if (!panel.remark.empty()) out += text(view_width - right_margin, top + 27, "end", "tick", panel.remark);
  out += grid(x, y, last);
  for (const Series& series : panel.series) out += curve(series, x, y);
  if (data.empty()) out += text((x.first + x.last) / 2, (y.first + y.last) / 2, "middle", "label", "no data");
  return out;
}

}  // namespace

std::string svg(const Figure& figure) {
  const Range range =
      padded(range_of(figure.panels, figure.logarithmic, true), figure.logarithmic, figure.logarithmic ? 0.08 : 0);
  const Axis x{range.low, range.high, left_margin, view_width - right_margin, figure.logarithmic};
  std::string body;
  double top = 0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    body += panel_svg(figure.panels[i], x, top, figure.logarithmic, i + 1 == figure.panels.size());
    top += label_height + figure.panels[i].height;
  }
  body += text((x.first + x.last) / 2, top + 44, "middle", "label", figure.x_label);
  const std::string id = escape(figure.id);
  return fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-labelledby=\"{}-title {}-desc\">"
      "<title id=\"{}-title\">{}</title><desc id=\"{}-desc\">{}</desc>{}</svg>",
      view_width, top + axis_height, id, id, id, escape(figure.title), id, escape(figure.description), body);
}

std::string svg_swatch(Role role, bool marker) {
  const std::string marked =
      marker ? fmt::format("<path class=\"mark {}\" d=\"{}\"/>", css(role), mark(role, 18, 7)) : "";
  return fmt::format(
      "<svg class=\"swatch\" viewBox=\"0 0 36 14\" width=\"36\" height=\"14\" aria-hidden=\"true\"><path class=\"line "
      "{}\" d=\"M1 7H35\"/>{}</svg>",
      css(role), marked);
}

}  // namespace handhold::reports
