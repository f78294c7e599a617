// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "realtime/world.hpp"

namespace handhold::bench {

struct Options {
  std::vector<std::string> scenes{};   ///< ids; empty: those that are timed, or all in quality
  bool peers{false};                   ///< MuJoCo, ODE and DART as well, where built in
  std::vector<std::string> engines{};  ///< peers: only these; empty: all
  bool timing{true}, quality{true};
  bool phases{false};  ///< where the time of a frame goes as well
  int rounds{5};
  int substeps{0};  ///< of the real-time path; 0: see setting_of
  int order{0};     ///< of the real-time path, 1 or 2; 0: likewise
  double frame_rate{90};
  std::string json{};   ///< file to write; empty: none
  std::string trace{};  ///< a recorded hand for the table of the paper's Fig. 10
  bool help{false};
};

/// What the real-time path plays a scene with. Where nothing else was asked for, what slides (S3) is played with the
/// second order and 4 sub-steps a frame, since the first order's error is more than the 0.1 % that is asked for; all
/// else with the first and one (docs/benchmarks.md).
[[nodiscard]] realtime::Options setting_of(const Options& options, std::string_view scene);
[[nodiscard]] std::string text_of(const realtime::Options& setting);

/// Throws InputError for what it does not know.
[[nodiscard]] Options parse(const std::vector<std::string>& arguments);

[[nodiscard]] std::string usage();

}  // namespace handhold::bench
