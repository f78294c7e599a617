// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/process.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "cases/input/recording/recording_csv.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/child_process.hpp"
#include "compare/engine/problem_json.hpp"

namespace handhold::compare {
namespace {

namespace fs = std::filesystem;

constexpr int not_asked_code = 4;
constexpr std::size_t output_kept = 4000;  // characters
constexpr double unit_tolerance = 1e-3;    // of a quaternion's length: single precision that drifted is let through

/// A folder that goes away with its contents, unless it was given.
class Workplace {
 public:
  explicit Workplace(const fs::path& given) : path_(given), keep_(!given.empty()) {
    std::error_code failed;
    if (keep_) {
      fs::create_directories(path_, failed);
      if (failed)
        throw InputError(fmt::format("{}: cannot be made: {} (give another folder)", path_.string(), failed.message()));
      return;
    }
    std::string name = (fs::temp_directory_path() / "handhold-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError(fmt::format("{}: cannot be made: {} (set TMPDIR)", name, std::strerror(errno)));
    path_ = name;
  }
  ~Workplace() {
    std::error_code ignored;
    if (!keep_) fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  bool keep_;
};

/// In quotes for a shell.
std::string quoted(const fs::path& path) {
  std::string out = "'";
  for (const char c : path.string()) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string command_line(std::string command, const fs::path& problem, const fs::path& out) {
  replace_all(command, "{problem}", quoted(problem));
  replace_all(command, "{out}", quoted(out));
  return command;
}

std::string end_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  const std::size_t size = std::size_t(in.tellg()), kept = std::min(size, output_kept);
  std::string text(kept, '\0');
  in.seekg(std::streamoff(size - kept));
  in.read(text.data(), std::streamsize(kept));
  return text;
}

std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

/// The why of a last line {"not_asked": "why"}; empty: it is none.
std::string not_asked_in(const std::string& output) {
  const nlohmann::json j = nlohmann::json::parse(last_line(output), nullptr, false);
  if (!j.is_object() || !j.contains("not_asked") || !j["not_asked"].is_string()) return "";
  return j["not_asked"];
}

std::string fault_of_end(const ChildEnd& end, double time_limit, const std::string& output) {
  if (end.timed_out)
    return fmt::format("was still running after {:g} s and was killed (a longer time limit, or fewer steps)",
                       time_limit);
  if (end.signal) return fmt::format("was ended by signal {} ({})", end.signal, strsignal(end.signal));
  if (end.exit_code == not_asked_code)
    return R"(ended with exit code 4, "not asked", without {"not_asked": "why"} as its last line)";
  if (end.exit_code == 0) return "";
  const std::string said = last_line(output);
  return fmt::format("ended with exit code {}{}{}", end.exit_code, said.empty() ? "" : ": ", said);
}

bool is_finite(const BodyState& b) {
  return b.X_WO.p.allFinite() && b.X_WO.R.coeffs().allFinite() && b.V_WO.v.allFinite() && b.V_WO.w.allFinite();
}

std::string frame_fault(const Frame& frame, std::size_t number, double expected_time, const SampledProblem& problem) {
  if (!(std::abs(frame.t - expected_time) <= 1e-3 * problem.step))  // rounding of a sum of steps
    return fmt::format("frame {} is at t = {:g} s, not {:g} s", number, frame.t, expected_time);
  for (std::size_t b = 0; b < frame.bodies.size(); ++b) {
    const BodyState& body = frame.bodies[b];
    const std::string where = fmt::format("frame {} (t = {:g} s), body '{}'", number, frame.t, problem.bodies[b].name);
    if (!is_finite(body)) return where + ": a number that is not finite";
    if (std::abs(body.X_WO.R.norm() - 1) > unit_tolerance) return where + ": its quaternion is not of length 1";
  }
  return "";
}

}  // namespace

void validate(const ProcessOptions& options) {
  for (const char* part : {"{problem}", "{out}"})
    if (options.command.find(part) == std::string::npos)
      throw InputError(fmt::format("command '{}': must contain {} (as in python3 mine.py {{problem}} {{out}})",
                                   options.command, part));
  if (!(options.time_limit > 0))
    throw InputError(fmt::format("time_limit={} s: must be > 0 (60 is usual)", options.time_limit));
}

std::string answer_fault(const Recording& answer, const SampledProblem& problem) {
  if (!answer.scene.empty() && answer.scene != problem.name)
    return fmt::format("answers the problem '{}', not '{}'", answer.scene, problem.name);
  std::vector<std::string> names;
  for (const SampledProblem::Body& b : problem.bodies) names.push_back(b.name);
  if (answer.body_names != names)
    return fmt::format("has the bodies [{}], the problem has [{}]", fmt::join(answer.body_names, ", "),
                       fmt::join(names, ", "));
  const std::size_t wanted = 1 + std::size_t(problem.steps / problem.frame_every);
  for (std::size_t i = 0; i < std::min(wanted, answer.frames.size()); ++i) {
    const double time = double(i) * problem.frame_every * problem.step;
    if (std::string fault = frame_fault(answer.frames[i], i, time, problem); !fault.empty()) return fault;
  }
  if (answer.frames.size() == wanted) return "";
  return fmt::format("has {} frames, the problem asks for {}: t = 0 and every {} steps of {:g} s up to {} steps",
                     answer.frames.size(), wanted, problem.frame_every, problem.step, problem.steps);
}

ProcessAnswer play_in_process(const SampledProblem& problem, const ProcessOptions& options) {
  validate(options);
  const Workplace place(options.folder);
  const fs::path file = place.path() / "problem.json", out = place.path() / "out", log = place.path() / "output.txt";
  const std::string command = command_line(options.command, file, out);
  fs::create_directories(out);
  std::ofstream(file) << problem_json(problem);

  ProcessAnswer answer;
  const ChildEnd end = run_command(command, options.time_limit, log);
  answer.output = end_of(log);
  if (end.exit_code == not_asked_code) answer.not_asked = not_asked_in(answer.output);
  if (!answer.not_asked.empty()) return answer;
  std::string fault = fault_of_end(end, options.time_limit, answer.output);
  if (fault.empty() && !fs::exists(out / "frames.csv")) fault = "wrote no frames.csv into {out}";
  if (fault.empty()) {
    try {
      Recording recording = read_recording(out);
      fault = answer_fault(recording, problem);
      if (fault.empty())
        answer.recording = std::move(recording);
      else
        fault = "wrote frames.csv, which " + fault;
    } catch (const InputError& error) {
      fault = fmt::format("wrote what cannot be read: {}", error.what());
    }
  }
  if (!fault.empty()) answer.fault = fmt::format("'{}' {}", options.command, fault);
  return answer;
}

}  // namespace handhold::compare
