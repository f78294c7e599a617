// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace_spline.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <gsl/gsl_interp.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::size_t components = 7;  // p and the raw quaternion (w, x, y, z)

using Values = std::array<double, components>;

/// The cubic y = a + b s + c s² + d s³ of every component between two knots, s = t - knot.
struct Segment {
  std::array<Values, 4> coefficient;

  [[nodiscard]] Values value(double s) const {
    Values y;
    for (std::size_t k = 0; k < components; ++k) {
      y[k] = coefficient[0][k] + s * (coefficient[1][k] + s * (coefficient[2][k] + s * coefficient[3][k]));
    }
    return y;
  }
  [[nodiscard]] Values derivative(double s) const {
    Values y;
    for (std::size_t k = 0; k < components; ++k) {
      y[k] = coefficient[1][k] + s * (2 * coefficient[2][k] + s * 3 * coefficient[3][k]);
    }
    return y;
  }
};

Values to_values(const Pose& X, double sign) {
  return {X.p.x(), X.p.y(), X.p.z(), sign * X.R.w(), sign * X.R.x(), sign * X.R.y(), sign * X.R.z()};
}

Eigen::Quaterniond raw_quaternion(const Values& y) { return {y[3], y[4], y[5], y[6]}; }

/// Second derivatives at the knots of the natural cubic spline through (t, y).
std::vector<double> knot_curvatures(const std::vector<double>& t, const std::vector<double>& y) {
  std::vector<double> m(t.size(), 0.0);
  if (t.size() < 3) return m;  // a straight line
  const std::unique_ptr<gsl_interp, decltype(&gsl_interp_free)> spline(gsl_interp_alloc(gsl_interp_cspline, t.size()),
                                                                       gsl_interp_free);
  gsl_interp_init(spline.get(), t.data(), y.data(), t.size());
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    m[i] = gsl_interp_eval_deriv2(spline.get(), t.data(), y.data(), t[i], nullptr);
  }
  return m;
}

void fit_component(const std::vector<double>& t, const std::vector<Values>& values, std::size_t k,
                   std::vector<Segment>& segments) {
  std::vector<double> y(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) y[i] = values[i][k];
  const std::vector<double> m = knot_curvatures(t, y);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double h = t[i + 1] - t[i];
    std::array<Values, 4>& c = segments[i].coefficient;
    c[0][k] = y[i];
    c[1][k] = (y[i + 1] - y[i]) / h - h * (2 * m[i] + m[i + 1]) / 6;
    c[2][k] = m[i] / 2;
    c[3][k] = (m[i + 1] - m[i]) / (6 * h);
  }
}

/// Where to evaluate: a knot interval of a stretch, and how far into it.
struct Place {
  std::size_t stretch{}, knot{};
  double s{};
  bool inside{};
};

double median_tick(const std::vector<double>& t) {
  std::vector<double> ticks;
  for (std::size_t i = 1; i < t.size(); ++i) ticks.push_back(t[i] - t[i - 1]);
  if (ticks.empty()) return 0;
  std::nth_element(ticks.begin(), ticks.begin() + static_cast<std::ptrdiff_t>(ticks.size() / 2), ticks.end());
  return ticks[ticks.size() / 2];
}

}  // namespace

struct TraceSpline::Splines {
  struct Stretch {
    std::vector<double> knots;
    std::vector<Segment> segments;  // 16 of one knot interval side by side: all phalanges are asked for at one time
  };

  Side side{};
  std::vector<Interval> presence;
  std::vector<Interval> bridged;
  std::vector<Stretch> stretches;

  void add_stretch(const Trace& trace, const std::vector<HandSample>& samples, const std::vector<std::size_t>& frames);

  [[nodiscard]] Place place(double t) const;
  [[nodiscard]] const Segment& segment(const Place& at, int phalanx) const {
    return stretches[at.stretch].segments[at.knot * phalanx_count + static_cast<std::size_t>(phalanx)];
  }
};

void TraceSpline::Splines::add_stretch(const Trace& trace, const std::vector<HandSample>& samples,
                                       const std::vector<std::size_t>& frames) {
  if (frames.size() < 2) return;  // one sample alone moves nothing
  Stretch stretch;
  for (const std::size_t i : frames) stretch.knots.push_back(trace.t[i]);
  stretch.segments.resize((frames.size() - 1) * phalanx_count);
  for (std::size_t phalanx = 0; phalanx < phalanx_count; ++phalanx) {
    std::vector<Values> values;
    double sign = 1;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Pose& X_WP = samples[frames[i]].X_WP[phalanx];
      // q and -q are one rotation: take the nearer one, or the spline would swing through zero.
      if (i > 0 && X_WP.R.dot(samples[frames[i - 1]].X_WP[phalanx].R) < 0) sign = -sign;
      values.push_back(to_values(X_WP, sign));
    }
    std::vector<Segment> segments(frames.size() - 1);
    for (std::size_t k = 0; k < components; ++k) fit_component(stretch.knots, values, k, segments);
    for (std::size_t i = 0; i < segments.size(); ++i) stretch.segments[i * phalanx_count + phalanx] = segments[i];
  }
  presence.push_back({stretch.knots.front(), stretch.knots.back()});
  stretches.push_back(std::move(stretch));
}

Place TraceSpline::Splines::place(double t) const {
  std::size_t n = 0;
  while (n + 1 < presence.size() && t > (presence[n].end + presence[n + 1].begin) / 2) ++n;
  const std::vector<double>& knots = stretches[n].knots;
  const double clamped = std::clamp(t, knots.front(), knots.back());
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, clamped);
  const auto knot = static_cast<std::size_t>(above - knots.begin()) - 1;
  return {n, knot, clamped - knots[knot], clamped == t};
}

TraceSpline::TraceSpline(const Trace& trace, std::size_t hand, const TraceSplineOptions& options) {
  validate(trace);
  if (hand >= trace.hands.size()) {
    throw InputError(fmt::format("trace \"{}\": hand {} was asked for, but it has {} (count from 0)", trace.name, hand,
                                 trace.hands.size()));
  }
  if (!(options.longest_bridge >= 0)) {
    throw InputError(
        fmt::format("longest_bridge {} s: must be >= 0 (0 splits at every lost sample)", options.longest_bridge));
  }
  auto splines = std::make_shared<Splines>();
  model_ = trace.hands[hand].model;
  splines->side = trace.hands[hand].side;
  const std::vector<HandSample>& samples = trace.hands[hand].samples;
  const double regular = 1.5 * median_tick(trace.t);  // a slow trace is no lost one

  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].tracked) continue;
    const double gap = frames.empty() ? 0 : trace.t[i] - trace.t[frames.back()];
    const bool whole = frames.empty() || (gap <= regular && i == frames.back() + 1);
    if (!whole && gap > options.longest_bridge) {
      splines->add_stretch(trace, samples, frames);
      frames.clear();
    } else if (!whole) {
      splines->bridged.push_back({trace.t[frames.back()], trace.t[i]});
    }
    frames.push_back(i);
  }
  splines->add_stretch(trace, samples, frames);
  splines_ = std::move(splines);
}

Side TraceSpline::side() const { return splines_->side; }

const std::vector<Interval>& TraceSpline::presence() const { return splines_->presence; }

const std::vector<Interval>& TraceSpline::bridged() const { return splines_->bridged; }

std::vector<double> TraceSpline::seen() const {
  std::vector<double> times;
  for (const Splines::Stretch& stretch : splines_->stretches)
    times.insert(times.end(), stretch.knots.begin(), stretch.knots.end());
  return times;
}

Pose TraceSpline::pose(int phalanx, double t) const {
  if (splines_->stretches.empty()) return {};
  const Place at = splines_->place(t);
  const Values y = splines_->segment(at, phalanx).value(at.s);
  return {raw_quaternion(y).normalized(), {y[0], y[1], y[2]}};
}

Twist TraceSpline::twist(int phalanx, double t) const {
  if (splines_->stretches.empty()) return {};
  const Place at = splines_->place(t);
  if (!at.inside) return {};
  const Segment& segment = splines_->segment(at, phalanx);
  const Eigen::Quaterniond r = raw_quaternion(segment.value(at.s));
  const Values rate = segment.derivative(at.s);
  // q = r / |r| gives q' = r' / |r| - q (q·r') / |r|, and w = 2 vec(q' q*). The second term is along q, and q q* = 1
  // has no vector part: renormalising only divides by |r|².
  const Eigen::Quaterniond rq = raw_quaternion(rate) * r.conjugate();
  return {2 * rq.vec() / r.squaredNorm(), {rate[0], rate[1], rate[2]}};
}

}  // namespace handhold
