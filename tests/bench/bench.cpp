// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark program: docs/benchmarks.md says what it measures and how to read it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/measure/quality.hpp"
#include "compare/peers/peer.hpp"
#include "reports/cli/scene_source.hpp"
#include "tests/bench/goals.hpp"
#include "tests/bench/options.hpp"
#include "tests/bench/phases.hpp"
#include "tests/bench/play.hpp"
#include "tests/bench/series.hpp"

namespace handhold::bench {
namespace {

using catalogue::BenchmarkScene;
using compare::Gate;
using compare::peers::PeerSetting;

const std::vector<std::string> timed{"S1", "S2", "S4a", "S4b", "S6a", "S6b"};

struct Entry {
  BenchmarkScene benchmark{};
  HandFrames hands{};
};

struct Judged {
  std::string scene{}, engine{};
  std::vector<Gate> gates{};
  std::string failure{};
};

bool wanted(const Options& options, const std::string& id) {
  return options.scenes.empty() || std::find(options.scenes.begin(), options.scenes.end(), id) != options.scenes.end();
}

void tell(const std::string& what) { std::cerr << what << '\n'; }

/// What decides whether a setting may be compared at all: held, or stands.
std::string verdict(const std::vector<Gate>& gates) {
  if (gates.empty()) return "";
  return compare::passes(gates.front()) ? "yes" : "NO";
}

// --- timing
// --------------------------------------------------------------------------------------------------------------

std::vector<std::string> wanted_peers(const Options& options) {
  const std::vector<std::string>& built = compare::peers::peer_names();
  for (const std::string& name : options.engines)
    if (std::find(built.begin(), built.end(), name) == built.end())
      throw InputError(fmt::format("--engines {}: not built in (there are: {})", name, fmt::join(built, ", ")));
  if (!options.peers) return {};
  return options.engines.empty() ? built : options.engines;
}

void play_once(Series& series, const Entry& entry, const Options& options) {
  if (!series.failure.empty()) return;
  try {
    if (series.engine == "realtime") {
      series.add(
          play_realtime(entry.benchmark.scene, entry.hands, options.frame_rate, setting_of(options, series.scene)));
    } else {
      const PeerSetting setting = compare::peers::grip_setting(series.engine, series.scene);
      series.add(compare::peers::play(series.engine, entry.benchmark, setting, options.frame_rate, false).frame_time);
    }
  } catch (const InputError& error) {
    series.failure = error.what();
  }
}

std::vector<Series> time_all(const std::map<std::string, Entry>& entries, const Options& options) {
  std::vector<Series> all;
  for (const std::string& id : timed) {
    if (!wanted(options, id)) continue;
    all.emplace_back(id, "realtime", text_of(setting_of(options, id)));
    for (const std::string& peer : wanted_peers(options))
      all.emplace_back(id, peer, compare::peers::grip_setting(peer, id).text());
  }
  for (int round = 0; round < options.rounds; ++round)
    for (Series& series : all) {
      tell(fmt::format("round {} of {}: {} {}", round + 1, options.rounds, series.scene, series.engine));
      play_once(series, entries.at(series.scene), options);
    }
  return all;
}

// --- quality
// -------------------------------------------------------------------------------------------------------------

Judged judge(const Entry& entry, const std::string& engine, const Options& options) {
  Judged judged{.scene = entry.benchmark.id, .engine = engine};
  try {
    Recording recording;
    if (engine == "realtime") {
      compare::EngineOptions of_engine;
      of_engine.frame_rate = options.frame_rate;
      const realtime::Options setting = setting_of(options, entry.benchmark.id);
      of_engine.substeps = setting.substeps;
      of_engine.order = setting.order;
      recording = compare::make_engine(engine)->play(entry.benchmark.scene, of_engine);
    } else {
      const PeerSetting setting = compare::peers::grip_setting(engine, judged.scene);
      recording = compare::peers::play(engine, entry.benchmark, setting, options.frame_rate, true);
    }
    judged.gates = compare::quality_gates(entry.benchmark, recording);
  } catch (const InputError& error) {
    judged.failure = error.what();
  }
  return judged;
}

std::vector<Judged> judge_all(const std::map<std::string, Entry>& entries, const Options& options) {
  std::vector<Judged> all;
  for (const std::string& id : catalogue::benchmark_ids()) {
    if (!wanted(options, id)) continue;
    std::vector<std::string> engines{"realtime"};
    const bool for_all = !entries.at(id).benchmark.phalanges.empty() || entries.at(id).benchmark.scene.hands.empty();
    if (for_all)
      for (const std::string& peer : wanted_peers(options)) engines.push_back(peer);
    for (const std::string& engine : engines) {
      tell(fmt::format("quality: {} {}", id, engine));
      all.push_back(judge(entries.at(id), engine, options));
    }
  }
  return all;
}

// --- tables
// --------------------------------------------------------------------------------------------------------------

void print_timing(const std::vector<Series>& all) {
  fmt::print("\nTime of a frame [us]: least median of a play; percentiles of the frames' least times\n");
  fmt::print("{:<6}{:<10}{:>10}{:>10}{:>10}{:>10}{:>9}  {:<6}{}\n", "scene", "engine", "median", "p90", "p99", "max",
             "/ ode", "holds", "setting");
  for (const Series& series : all) {
    if (!series.failure.empty()) {
      fmt::print("{:<6}{:<10}{}\n", series.scene, series.engine, series.failure);
      continue;
    }
    const compare::FrameTimes times = series.times();
    double ode = NAN;
    for (const Series& other : all)
      if (other.scene == series.scene && other.engine == "ode") ode = other.median();
    fmt::print("{:<6}{:<10}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>9}  {:<6}{}\n", series.scene, series.engine,
               1e6 * series.median(), 1e6 * times.p90, 1e6 * times.p99, 1e6 * times.max,
               std::isnan(ode) ? "" : fmt::format("{:.3f}", series.median() / ode), series.verdict, series.setting);
  }
}

/// The sum is a little off the median of whole frames: no frame is the median one in every phase.
void print_phases(const std::map<std::string, Entry>& entries, const Options& options) {
  fmt::print("\nWhere the time of a frame goes [us], and how much of it\n{:<12}", "");
  std::vector<realtime::PhaseClock::Seconds> columns;
  std::vector<double> sums;
  for (const auto& [id, entry] : entries) {
    columns.push_back(
        time_phases(entry.benchmark.scene, entry.hands, options.frame_rate, setting_of(options, id), options.rounds));
    sums.push_back(std::accumulate(columns.back().begin(), columns.back().end(), 0.0));
    fmt::print("{:>16}", id);
  }
  fmt::print("\n");
  for (std::size_t phase = 0; phase < realtime::phase_names.size(); ++phase) {
    fmt::print("{:<12}", realtime::phase_names[phase]);
    for (std::size_t i = 0; i < columns.size(); ++i)
      fmt::print("{:>10.2f}{:>4.0f} %", 1e6 * columns[i][phase], 100 * columns[i][phase] / sums[i]);
    fmt::print("\n");
  }
  fmt::print("{:<12}", "sum");
  for (const double sum : sums) fmt::print("{:>10.2f}{:>6}", 1e6 * sum, "");
  fmt::print("\n");
}

void print_gate(const std::string& who, const Gate& gate) {
  fmt::print("{:<22}{:<38}{:>13.3e} {} {:<9.3g} {:<5}{}\n", who, gate.quantity, gate.measured,
             gate.bound == compare::Bound::at_most ? "<=" : ">=", gate.limit, gate.unit,
             compare::passes(gate) ? "reached" : "NOT REACHED");
}

void print_goals(const std::vector<Gate>& goals) {
  if (goals.empty()) return;
  fmt::print("\nGoals\n");
  for (const Gate& goal : goals) print_gate("", goal);
}

void print_quality(const std::vector<Judged>& all) {
  fmt::print("\nQuality, from poses\n");
  for (const Judged& judged : all) {
    const std::string who = fmt::format("{} {}", judged.scene, judged.engine);
    if (!judged.failure.empty()) fmt::print("{:<22}{}\n", who, judged.failure);
    for (const Gate& gate : judged.gates) print_gate(who, gate);
  }
}

/// The paper's figure: 600 µs for 6 phalanges and 1500 µs for 32, on the machine of 2018.
void print_fig10(const std::vector<Series>& all) {
  fmt::print(
      "\nFig. 10 of the paper: time of a frame [us]; there 600 with 6 phalanges and 1500 with 32, 8 samples each\n");
  fmt::print("{:<26}{:>10}{:>10}{:>10}{:>10}\n", "", "median", "p99", "p99.9", "max");
  for (const Series& series : all) {
    if (series.engine != "realtime" || series.medians().empty()) continue;
    const std::string what = series.scene == "S1"      ? "6 phalanges (S1)"
                             : series.scene == "S2"    ? "32 phalanges (S2)"
                             : series.scene == "trace" ? "recorded hand with a mug"
                                                       : "";
    if (what.empty()) continue;
    const compare::FrameTimes times = series.times();
    fmt::print("{:<26}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}\n", what, 1e6 * series.median(), 1e6 * times.p99,
               1e6 * times.p999, 1e6 * times.max);
  }
}

Scene recorded_scene(const std::string& trace) {
  reports::SceneRequest request;
  request.trace_file = trace;
  request.object = "shape:mug";
  return reports::load_scenes(request).front().scene;
}

Series time_recorded(const Scene& scene, const Options& options) {
  const HandFrames hands = hand_frames(scene, options.frame_rate);
  const realtime::Options setting = setting_of(options, "trace");
  Series series("trace", "realtime", text_of(setting));
  for (int round = 0; round < options.rounds; ++round) {
    tell(fmt::format("round {} of {}: the recorded hand", round + 1, options.rounds));
    series.add(play_realtime(scene, hands, options.frame_rate, setting));
  }
  return series;
}

// --- JSON
// ----------------------------------------------------------------------------------------------------------------

nlohmann::json json_of(const Gate& gate) {
  return {{"quantity", gate.quantity},
          {"measured", std::isfinite(gate.measured) ? nlohmann::json(gate.measured) : nullptr},
          {"bound", gate.bound == compare::Bound::at_most ? "<=" : ">="},
          {"limit", gate.limit},
          {"unit", gate.unit},
          {"reached", compare::passes(gate)},
          {"reason", gate.reason}};
}

nlohmann::json json_of(const Series& series) {
  const compare::FrameTimes times = series.times();
  nlohmann::json out{{"scene", series.scene}, {"engine", series.engine}, {"setting", series.setting}};
  if (!series.failure.empty()) out["failure"] = series.failure;
  if (series.medians().empty()) return out;
  out.update({{"median_s", series.median()},
              {"medians_s", series.medians()},
              {"p50_s", times.p50},
              {"p90_s", times.p90},
              {"p99_s", times.p99},
              {"p999_s", times.p999},
              {"max_s", times.max},
              {"frames", times.frames},
              {"holds", series.verdict}});
  return out;
}

void write_json(const Options& options, const std::vector<Series>& times, const std::vector<Gate>& goals,
                const std::vector<Judged>& judged) {
  nlohmann::json out{{"rounds", options.rounds},
                     {"frame_rate_hz", options.frame_rate},
                     {"timing", nlohmann::json::array()},
                     {"goals", nlohmann::json::array()},
                     {"quality", nlohmann::json::array()}};
  for (const Series& series : times) out["timing"].push_back(json_of(series));
  for (const Gate& goal : goals) out["goals"].push_back(json_of(goal));
  for (const Judged& one : judged) {
    nlohmann::json entry{{"scene", one.scene}, {"engine", one.engine}, {"gates", nlohmann::json::array()}};
    if (!one.failure.empty()) entry["failure"] = one.failure;
    for (const Gate& gate : one.gates) entry["gates"].push_back(json_of(gate));
    out["quality"].push_back(entry);
  }
  std::ofstream file(options.json);
  file << out.dump(1) << '\n';
  if (!file) throw InputError(fmt::format("--json {}: cannot be written (does the folder exist?)", options.json));
}

// -------------------------------------------------------------------------------------------------------------------------

void run(const Options& options) {
  for (const std::string& id : options.scenes) static_cast<void>(catalogue::benchmark_scene(id));  // unknown ids throw
  std::map<std::string, Entry> entries;
  for (const std::string& id : catalogue::benchmark_ids()) {
    const bool is_timed = std::find(timed.begin(), timed.end(), id) != timed.end();
    if (!wanted(options, id) || (!options.quality && !is_timed)) continue;
    Entry& entry = entries[id];
    entry.benchmark = catalogue::benchmark_scene(id);
    entry.hands = hand_frames(entry.benchmark.scene, options.frame_rate);
  }
  std::optional<Scene> recorded;  // read first: a wrong name is told at once, not after the rounds
  if (!options.trace.empty()) recorded = recorded_scene(options.trace);
  std::vector<Series> times;
  std::vector<Judged> judged;
  if (options.timing) times = time_all(entries, options);
  if (options.quality) judged = judge_all(entries, options);
  for (Series& series : times)
    for (const Judged& one : judged)
      if (one.scene == series.scene && one.engine == series.engine) series.verdict = verdict(one.gates);
  const std::vector<Gate> reached = goals(times);
  if (options.timing) print_timing(times);
  if (options.phases) print_phases(entries, options);
  print_goals(reached);
  if (options.quality) print_quality(judged);
  if (recorded) times.push_back(time_recorded(*recorded, options));
  if (options.timing) print_fig10(times);
  if (!options.json.empty()) write_json(options, times, reached, judged);
}

}  // namespace
}  // namespace handhold::bench

int main(int argc, char** argv) {
  using namespace handhold;
  try {
    const bench::Options options = bench::parse({argv + 1, argv + argc});
    if (options.help) {
      std::cout << bench::usage();
      return 0;
    }
    bench::run(options);
    return 0;
  } catch (const InputError& error) {
    std::cerr << "handhold_bench: " << error.what() << '\n';
    return 2;
  }
}
