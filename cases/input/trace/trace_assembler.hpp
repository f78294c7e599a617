// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/input/trace/joint_frames.hpp"

namespace handhold {

/// Collects frames of tracked joints and makes a Trace of them: what the readers of joint formats share.
///
/// Time starts at 0 with the first frame. A frame with the stamp of the one before is dropped with a warning; a stamp
/// that goes back is an InputError. Hands are told apart by their side: one that comes back under another id is the
/// same hand, with a warning. A second hand of one side in a frame is dropped, with a warning, unless its id is the one
/// that was followed.
class TraceAssembler {
 public:
  /// `name` starts every error.
  TraceAssembler(std::string name, std::string source_frame, TipPlace tip);

  /// Starts frame number `frame` of the file at `t` [s]. False: its stamp is a repeated one, skip it.
  [[nodiscard]] bool add_frame(double t, std::size_t frame);
  void add_hand(Side side, const HandJoints& joints, long id = -1);
  void warn(std::string sentence) { trace_.warnings.push_back(std::move(sentence)); }

  /// Throws InputError if there is no frame, or none with a whole hand.
  [[nodiscard]] Trace finish();

 private:
  struct Track {
    std::vector<std::optional<HandJoints>> frames{};
    std::vector<long> ids{};  ///< one a frame with this hand, of the one taken
    std::size_t doubles{};
    long followed{-1};  ///< the id of the last frame before this one
  };
  Track& track(Side side) { return tracks_[side == Side::left ? 0 : 1]; }
  void report(Side side);

  Trace trace_;
  TipPlace tip_;
  std::array<Track, 2> tracks_{};
  std::optional<double> first_{};
  double last_{};
  std::size_t repeated_{};
};

}  // namespace handhold
