// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/self_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace handhold::compare {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

using Lists = std::map<SampleId, std::vector<const Event*>>;

Lists by_sample(const Recording& recording) {
  Lists lists;
  for (const Event& e : recording.events) lists[e.id].push_back(&e);
  return lists;
}

bool same_kinds(const std::vector<const Event*>& a, const std::vector<const Event*>& b) {
  return std::ranges::equal(a, b, [](const Event* x, const Event* y) { return x->kind == y->kind; });
}

void compare_events(Lists a, Lists b, Gap& out) {
  for (const auto& entry : b) a.try_emplace(entry.first);
  for (const auto& [id, ours] : a) {
    const std::vector<const Event*>& theirs = b[id];
    if (!same_kinds(ours, theirs)) {
      ++out.unlike_samples;
      continue;
    }
    for (std::size_t i = 0; i < ours.size(); ++i)
      out.event_time = std::max(out.event_time, std::abs(ours[i]->t - theirs[i]->t));
  }
}

/// What of a Gap is a measure, to treat the three alike.
using Measure = double Gap::*;
constexpr Measure measures[] = {&Gap::position, &Gap::rotation, &Gap::event_time};

Order slope(const std::vector<ConvergenceRun>& runs, Measure what) {
  std::vector<double> size, difference;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    size.push_back(runs[i].setting.size);
    difference.push_back(runs[i].to_tightest.*what);
  }
  return observed_order(size, difference);
}

/// Continues the slope from the last but one to the last; without a slope, as much as the two differ.
double error_of_last(const std::vector<ConvergenceRun>& runs, Measure what, const Order& order) {
  if (runs.size() < 2) return nan;
  const ConvergenceRun &before = runs[runs.size() - 2], &last = runs.back();
  const double difference = before.to_tightest.*what;
  if (!(order.slope > 0)) return difference;
  return difference * std::pow(last.setting.size / before.setting.size, order.slope);
}

bool keeps(const ConvergenceRun& run) {
  if (!run.setting.promise) return true;
  const Gap& promise = *run.setting.promise;
  return run.recording.outcome == Outcome::complete && run.error.unlike_samples <= promise.unlike_samples &&
         std::ranges::all_of(measures, [&](Measure m) { return run.error.*m <= promise.*m; });
}

void judge(SelfConvergence& study) {
  std::vector<ConvergenceRun>& runs = study.runs;
  if (runs.empty()) return;
  for (ConvergenceRun& run : runs) run.to_tightest = gap(run.recording, runs.back().recording);
  study.position = slope(runs, &Gap::position);
  study.rotation = slope(runs, &Gap::rotation);
  study.event_time = slope(runs, &Gap::event_time);
  const Order* orders[] = {&study.position, &study.rotation, &study.event_time};
  for (std::size_t m = 0; m < std::size(measures); ++m) {
    const double last = error_of_last(runs, measures[m], *orders[m]);
    for (ConvergenceRun& run : runs) run.error.*measures[m] = run.to_tightest.*measures[m] + last;
  }
  for (ConvergenceRun& run : runs) {
    run.error.unlike_samples = run.to_tightest.unlike_samples;
    run.kept = keeps(run);
  }
}

long steps_of(const Recording& recording, const Setting& setting, const Scene& scene) {
  const auto counted = recording.provenance.find("steps");
  if (counted != recording.provenance.end()) return std::stol(counted->second);
  return std::lround(scene.duration * setting.options.frame_rate * setting.options.substeps);
}

}  // namespace

Gap gap(const Recording& a, const Recording& b) {
  Gap out{nan, nan, nan, 0};
  if (a.frames.empty() || b.frames.empty()) return out;
  const std::vector<BodyState>&x = a.frames.back().bodies, &y = b.frames.back().bodies;
  if (x.size() != y.size()) return out;
  out = {};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double position = (x[i].X_WO.p - y[i].X_WO.p).norm();
    const double half_sine = std::min(1.0, (x[i].X_WO.R.conjugate() * y[i].X_WO.R).vec().norm());
    // Not max(): it would drop the NaN of a run that diverged.
    if (!(position <= out.position)) out.position = position;
    if (!(2 * std::asin(half_sine) <= out.rotation)) out.rotation = 2 * std::asin(half_sine);
  }
  compare_events(by_sample(a), by_sample(b), out);
  return out;
}

std::vector<Setting> reference_settings() {
  const auto setting = [](const std::string& name, double accuracy, double max_step) {
    Setting s{.name = name, .size = accuracy};
    s.options.accuracy = accuracy;
    s.options.max_step = max_step;
    return s;
  };
  // Loose ones may step far, so that the accuracy is what governs; the last is there to judge "gold" by.
  std::vector<Setting> settings{setting("1e-6", 1e-6, 5e-3), setting("1e-8", 1e-8, 5e-3),
                                setting("reference, 1e-10", 1e-10, 1e-3), setting("gold, 1e-12", 1e-12, 5e-4),
                                setting("1e-13", 1e-13, 2.5e-4)};
  settings[2].promise = Gap{1e-7, 1e-6, 1e-6, 0};
  settings[3].promise = Gap{4e-10, 1e-8, 1e-8, 0};
  return settings;
}

std::vector<Setting> realtime_settings() {
  std::vector<Setting> settings;
  for (const int finer : {1, 2, 4, 8, 16, 32}) {
    Setting s;
    s.options.frame_rate *= finer;
    s.name = fmt::format("{:g} Hz x {}", s.options.frame_rate, s.options.substeps);
    s.size = 1 / (s.options.frame_rate * s.options.substeps);
    settings.push_back(s);
  }
  return settings;
}

SelfConvergence self_convergence(const Engine& engine, const Scene& scene, const std::vector<Setting>& settings,
                                 const ConvergenceProgress& progress) {
  SelfConvergence study;
  for (const Setting& setting : settings) {
    const auto watch = [&](double t) { return !progress || progress(setting, t); };
    if (!watch(0)) break;
    const double begin = thread_seconds();
    ConvergenceRun run{.setting = setting};
    run.recording = engine.play(scene, setting.options, watch);
    run.cost = (thread_seconds() - begin) / scene.duration;
    run.steps = steps_of(run.recording, setting, scene);
    study.runs.push_back(std::move(run));
  }
  judge(study);
  return study;
}

}  // namespace handhold::compare
