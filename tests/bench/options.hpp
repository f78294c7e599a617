#pragma once

#include <string>
#include <vector>

namespace handhold::bench {

struct Options {
  std::vector<std::string> scenes{};  ///< ids; empty: those that are timed, or all in quality
  bool peers{false};                  ///< MuJoCo, ODE and DART as well, where built in
  bool timing{true}, quality{true};
  bool phases{false};  ///< where the time of a frame goes as well
  int rounds{5};
  int substeps{4};  ///< of the real-time path
  int order{1};     ///< of the real-time path
  double frame_rate{90};
  std::string json{};   ///< file to write; empty: none
  std::string trace{};  ///< a recorded hand for the table of the paper's Fig. 10
  bool help{false};
};

/// Throws InputError for what it does not know.
[[nodiscard]] Options parse(const std::vector<std::string>& arguments);

[[nodiscard]] std::string usage();

}  // namespace handhold::bench
