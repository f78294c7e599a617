// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_reader.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cases/hand/moved_trace.hpp"
#include "cases/hand/trace_doubts.hpp"
#include "cases/hand/trace_glitches.hpp"
#include "cases/input/json_input.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/json_readers.hpp"
#include "cases/input/trace/lz_string.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/input/trace/wide_csv.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// A packed recording is nothing but base64, thousands of characters of it.
bool is_base64(std::string_view text) {
  constexpr std::size_t least = 64;
  return text.size() >= least && text.find_first_not_of(
                                     "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                     "0123456789+/= \t\r\n") == std::string_view::npos;
}

Trace read_json(std::string_view text, const std::string& path) {
  nlohmann::json recording = from_leap_c(as_recording(parse_json(text, path)));
  return is_leap(recording) ? leap_trace(recording, path) : joints_trace(std::move(recording), path);
}

Trace read_any(const std::string& path) {
  const std::string text = read_text_file(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw InputError(fmt::format("{}: the file is empty (record a hand)", path));
  const std::string_view content = std::string_view(text).substr(first);
  if (content[0] == '{' || content[0] == '[') return read_json(content, path);
  if (content[0] == '#') return read_trace_csv(content, path);
  if (is_base64(text) || ends_with(path, ".lz")) return read_json(decompress_lz_string(text, path), path);
  if (is_wide_csv(content)) return read_wide_csv(content, path);
  throw InputError(fmt::format(
      "{}: this format is unknown (use handhold's trace CSV, LeapJS .json or .json.lz, or joints of OpenXR, "
      "WebXR, MANO or MediaPipe as JSON, or as CSV with a column a coordinate)",
      path));
}

/// Puts what is doubtful among the warnings; bridges glitches if asked.
void examine(Trace& trace, const std::string& path, const TraceReadOptions& options) {
  constexpr std::size_t most = 5;  // sentences about glitches
  const std::vector<Glitch> glitches = find_glitches(trace);
  Trace bridged = trace;
  bridge(bridged, glitches);
  const char* end = options.repair ? ": bridged" : " (bridge it with --repair)";
  for (std::size_t i = 0; i < std::min(most, glitches.size()); ++i)
    bridged.warnings.push_back(to_text(trace, glitches[i]) + end);
  if (glitches.size() > most)
    bridged.warnings.push_back(fmt::format("{} more such glitches{}", glitches.size() - most, end));
  for (const Doubt& doubt : doubts(bridged)) {
    if (doubt.meaningless && !options.trust)
      throw InputError(fmt::format("{}: {} ({}; or believe it: --trust)", path, doubt.evidence, doubt.cure));
    bridged.warnings.push_back(to_text(doubt));
  }
  if (options.repair)
    trace = std::move(bridged);
  else
    trace.warnings = std::move(bridged.warnings);
}

}  // namespace

Trace read_trace(const std::string& path, const TraceReadOptions& options) {
  Trace trace = read_any(path);
  if (options.scale != 1 || options.time_scale != 1)
    trace = scaled(std::move(trace), options.scale, options.time_scale);
  examine(trace, path, options);
  return trace;
}

}  // namespace handhold
