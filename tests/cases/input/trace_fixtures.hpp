// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "cases/hand/keyframed_hand.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::test {

/// What `call` throws as InputError, or "accepted".
template <class Call>
std::string message_of(const Call& call) {
  try {
    (void)call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A hand that closes while it moves 0.3 m along x, in one second, sampled for two.
inline Trace closing_hand(double rate, Side side = Side::right) {
  const HandModel model = anatomical_hand();
  const HandKeyframe open = HandKeyframe::of_curl(0.5, Pose{Eigen::Quaterniond::Identity(), {0, 0, 1}}, 0, 0);
  const HandKeyframe fist = HandKeyframe::of_curl(1.5, Pose{Eigen::Quaterniond(0.6, 0, 0.8, 0), {0.3, 0, 1}}, 1, 0.7);
  return sample_trace("closing", side, model, keyframed_hand(model, side, {open, fist}), 0, 2, rate);
}

/// A file in the temporary folder that goes with the object.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_((std::filesystem::temp_directory_path() / ("handhold_" + std::to_string(::getpid()) + "_" + name))
                  .string()) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace handhold::test
