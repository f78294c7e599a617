// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/options.hpp"

#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::bench {
namespace {

template <typename Number>
Number number(const std::string& name, const std::string& text, Number least, Number most) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= least && value <= most))
    throw InputError(fmt::format("{} {}: must be {} to {}", name, text, least, most));
  return value;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

}  // namespace

realtime::Options setting_of(const Options& options, std::string_view scene) {
  const bool slides = scene.substr(0, 2) == "S3";
  return {.substeps = options.substeps > 0 ? options.substeps : (slides ? 4 : 1),
          .order = options.order > 0 ? options.order : (slides ? 2 : 1)};
}

std::string text_of(const realtime::Options& setting) {
  return fmt::format("substeps {}, order {}", setting.substeps, setting.order);
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) throw InputError(fmt::format("{}: needs a value (see --help)", name));
      return arguments[++i];
    };
    if (name == "--help" || name == "-h")
      options.help = true;
    else if (name == "--peers")
      options.peers = true;
    else if (name == "--no-timing")
      options.timing = false;
    else if (name == "--no-quality")
      options.quality = false;
    else if (name == "--phases")
      options.phases = true;
    else if (name == "--engines")
      options.engines = split(value());
    else if (name == "--scenes")
      options.scenes = split(value());
    else if (name == "--rounds")
      options.rounds = number(name, value(), 1, 1000);
    else if (name == "--substeps")
      options.substeps = number(name, value(), 1, 1000);
    else if (name == "--order")
      options.order = number(name, value(), 1, 2);
    else if (name == "--frame-rate")
      options.frame_rate = number(name, value(), 1.0, 10000.0);
    else if (name == "--json")
      options.json = value();
    else if (name == "--trace")
      options.trace = value();
    else
      throw InputError(fmt::format("{}: no such option (see --help)", name));
  }
  return options;
}

std::string usage() {
  return R"(usage: handhold_bench [OPTIONS]

Plays the benchmark scenes S1 to S6 (docs/benchmarks.md), tells what a frame costs and how well it was simulated.

  --peers          MuJoCo, ODE and DART as well, those that were built in, in the same rounds
  --engines ode    of the peers only these (ode, mujoco, dart)
  --scenes S1,S2   only these
  --rounds N       plays of every scene and engine, interleaved; 5
  --substeps N     of the real-time path, a frame; 4 for S3, else 1
  --order N        of the real-time path: 1 implicit Euler, 2 implicit midpoint; 2 for S3, else 1
  --frame-rate HZ  90
  --no-timing, --no-quality
  --phases         where the time of a frame of the real-time path goes
  --trace FILE     a recorded hand, with a mug in its first grasp, in the table of the paper's Fig. 10
  --json FILE      everything as JSON

Exit code: 0 the program ran, whether or not a goal is reached; 2 wrong input.
)";
}

}  // namespace handhold::bench
