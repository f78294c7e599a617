#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handhold::bench {

struct Options {
  std::vector<std::string> scenes{};  ///< ids; empty: those that are timed, or all in quality
  bool peers{false};                  ///< MuJoCo, ODE and DART as well, where built in
  bool timing{true}, quality{true};
  bool phases{false};  ///< where the time of a frame goes as well
  int rounds{5};
  int substeps{4};  ///< of the real-time path
  int order{0};     ///< of the real-time path, 1 or 2; 0: see order_of
  double frame_rate{90};
  std::string json{};   ///< file to write; empty: none
  std::string trace{};  ///< a recorded hand for the table of the paper's Fig. 10
  bool help{false};
};

/// The order that a scene is played with. Where none was asked for, blocks that slide (S3) are played with the second:
/// the first is ahead by half a step, which is more than the 0.1 % that is asked for (docs/benchmarks.md).
[[nodiscard]] int order_of(const Options& options, std::string_view scene);

/// Throws InputError for what it does not know.
[[nodiscard]] Options parse(const std::vector<std::string>& arguments);

[[nodiscard]] std::string usage();

}  // namespace handhold::bench
