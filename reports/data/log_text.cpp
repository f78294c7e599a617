// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/log_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using compare::LogFinding;
using compare::LogGrip;
using compare::LogReplay;
using Json = nlohmann::ordered_json;

constexpr double same = 0.1;  // [s]: ends of a grip that are nearer agree, as tracking and springs allow

std::string finding_text(const LogFinding& f) {
  return summary_line(fmt::format("{:.3f} s", f.begin),
                      fmt::format("{}: {} (to {:.3f} s; limit {}). {}", one_line(f.object), f.text, f.end,
                                  readable(f.limit, f.unit), f.reason));
}

/// What the law of friction says of a grip, beside the log.
std::string replay_text(const LogGrip& grip, const LogReplay& replay, double mu, const std::string& engine) {
  const std::string who = fmt::format("{} with mu {}", engine, number(mu, 3));
  if (replay.outcome != Outcome::complete) return fmt::format("{}: ended early ({})", who, to_string(replay.outcome));
  const std::string from = fmt::format("taken up at {:.3f} s", replay.begin);
  if (replay.replayed_end && *replay.replayed_end < grip.end - same)
    return fmt::format("{}: {}, slips out at {:.3f} s; the log holds it to {:.3f} s", who, from, *replay.replayed_end,
                       grip.end);
  if (!replay.replayed_end && replay.played_until > grip.end + same)
    return fmt::format("{}: {}, holds beyond {:.3f} s, where the log lost it", who, from, grip.end);
  if (replay.replayed_end && *replay.replayed_end > grip.end + same)
    return fmt::format("{}: {}, holds to {:.3f} s; the log lost it at {:.3f} s", who, from, *replay.replayed_end,
                       grip.end);
  return fmt::format("{}: {}, as the log has it; {} apart at most while both hold", who, from,
                     readable(replay.apart, "m"));
}

Json finding_json(const LogFinding& f) {
  return {{"fault", std::string(to_string(f.fault))},
          {"object", f.object},
          {"begin", f.begin},
          {"end", f.end},
          {"value", f.value},
          {"limit", f.limit},
          {"unit", f.unit},
          {"text", f.text},
          {"reason", f.reason}};
}

Json grip_json(const LogGrip& grip, const std::optional<LogReplay>* replay) {
  Json out{{"object", grip.object}, {"hand", grip.hand},
           {"begin", grip.begin},   {"end", grip.end},
           {"depth", grip.depth},   {"jitter", std::isnan(grip.jitter) ? Json() : Json(grip.jitter)}};
  if (replay == nullptr || !*replay) return out;
  const LogReplay& r = **replay;
  out["replay"] = {{"begin", r.begin},
                   {"played_until", r.played_until},
                   {"end", r.replayed_end ? Json(*r.replayed_end) : Json()},
                   {"apart", r.apart},
                   {"outcome", std::string(to_string(r.outcome))}};
  return out;
}

}  // namespace

std::string log_text(const JudgedLog& log) {
  std::string out = one_line(log.name) + "\n";
  for (const std::string& warning : log.warnings) out += summary_line("warning", one_line(warning));
  const compare::FrameTimes& f = log.report.frames;
  out += summary_line("frames", fmt::format("{} steps: p50 {}, p99 {}, longest {}", f.frames, readable(f.p50, "s"),
                                            readable(f.p99, "s"), readable(f.max, "s")));
  for (std::size_t i = 0; i < log.report.grips.size(); ++i) {
    const LogGrip& grip = log.report.grips[i];
    out += summary_line(
        "grip", fmt::format("{}: {:.3f} to {:.3f} s, the hand at most {} deep{}", one_line(grip.object), grip.begin,
                            grip.end, readable(grip.depth, "m"),
                            std::isnan(grip.jitter) ? "" : ", jitter " + readable(grip.jitter, "m") + " rms"));
    if (i >= log.replays.size()) continue;
    out += summary_line("", log.replays[i] ? replay_text(grip, *log.replays[i], log.mu_static[i], log.engine)
                                           : "never at rest in the hand: not replayed");
  }
  for (const LogFinding& finding : log.report.findings) out += finding_text(finding);
  const std::size_t count = log.report.findings.size();
  return out + (count == 0 ? "nothing that a rigid body with Coulomb friction could not do\n"
                           : fmt::format("{} thing{} that no rigid body with Coulomb friction does\n", count,
                                         count == 1 ? "" : "s"));
}

std::string log_json(const JudgedLog& log) {
  Json out{{"format", "handhold log verdict"}, {"version", 1},          {"log", log.name}, {"warnings", log.warnings},
           {"findings", Json::array()},        {"grips", Json::array()}};
  for (const LogFinding& finding : log.report.findings) out["findings"].push_back(finding_json(finding));
  for (std::size_t i = 0; i < log.report.grips.size(); ++i)
    out["grips"].push_back(grip_json(log.report.grips[i], i < log.replays.size() ? &log.replays[i] : nullptr));
  const compare::FrameTimes& f = log.report.frames;
  out["frames"] = {{"steps", f.frames}, {"p50", f.p50}, {"p99", f.p99}, {"max", f.max}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handhold::reports
