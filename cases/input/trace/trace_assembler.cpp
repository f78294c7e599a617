// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_assembler.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"

namespace handhold {
TraceAssembler::TraceAssembler(std::string name, std::string source_frame, TipPlace tip)
    : trace_{std::move(name), std::move(source_frame), {}, {}, {}}, tip_(tip) {}

bool TraceAssembler::add_frame(double t, std::size_t frame) {
  if (!std::isfinite(t)) {
    throw InputError(fmt::format("{}, frame {}: the time stamp is not a number (drop the frame)", trace_.name, frame));
  }
  if (first_ && t < last_) {
    throw InputError(
        fmt::format("{}, frame {}: the time stamp {:.6f} s lies before {:.6f} s of the frame before it (sort "
                    "the frames by time)",
                    trace_.name, frame, t, last_));
  }
  if (first_ && t == last_) {
    ++repeated_;
    return false;
  }
  if (!first_) first_ = t;
  last_ = t;
  trace_.t.push_back(t - *first_);
  for (Track& track : tracks_) {
    track.frames.emplace_back();
    if (!track.ids.empty()) track.followed = track.ids.back();
  }
  return true;
}

void TraceAssembler::add_hand(Side side, const HandJoints& joints, long id) {
  Track& seen = track(side);
  std::optional<HandJoints>& slot = seen.frames.back();
  if (slot) {
    ++seen.doubles;
    if (id != seen.followed) return;
    seen.ids.pop_back();
  }
  slot = joints;
  seen.ids.push_back(id);
}

void TraceAssembler::report(Side side) {
  const Track& seen = track(side);
  std::vector<long> ids = seen.ids;
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (ids.size() > 1) {
    warn(fmt::format("{} hand: the tracker's id changed ({}); taken as one hand", to_string(side),
                     fmt::join(ids, ", ")));
  }
  if (seen.doubles > 0) {
    warn(fmt::format("{} hand: seen twice in {} frames; the one already followed was kept", to_string(side),
                     seen.doubles));
  }
}

Trace TraceAssembler::finish() {
  if (repeated_ > 0) warn(fmt::format("{} frames repeat the time stamp of the one before and were dropped", repeated_));
  for (const Side side : {Side::left, Side::right}) {
    const std::vector<std::optional<HandJoints>>& frames = track(side).frames;
    if (std::none_of(frames.begin(), frames.end(), [](const auto& f) { return f.has_value(); })) continue;
    report(side);
    TraceHand hand = hand_from_joints(side, frames, tip_, trace_.warnings);
    const bool any = std::any_of(hand.samples.begin(), hand.samples.end(), [](const auto& s) { return s.tracked; });
    if (any) trace_.hands.push_back(std::move(hand));
  }
  if (trace_.hands.empty()) {
    throw InputError(
        fmt::format("{}: there is no frame with a whole hand among {} (record a hand, or check the joints)",
                    trace_.name, trace_.t.size()));
  }
  validate(trace_);
  return std::move(trace_);
}

}  // namespace handhold
