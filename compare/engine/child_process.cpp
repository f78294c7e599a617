// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/child_process.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

using Clock = std::chrono::steady_clock;

constexpr rlim_t largest_file = rlim_t(1) << 30;
constexpr int cannot_execute = 127;  // as of a shell

/// In the child: only calls that are safe between fork and exec, as other threads may have held locks.
[[noreturn]] void become(const char* command, const char* output) {
  setpgid(0, 0);
  const rlimit limit{largest_file, largest_file};
  setrlimit(RLIMIT_FSIZE, &limit);
  const int in = open("/dev/null", O_RDONLY), out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (in >= 0 && out >= 0 && dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(out, 2) >= 0)
    execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  _exit(cannot_execute);
}

/// Waits for the child until the deadline; true if it ended.
bool wait_until(pid_t child, Clock::time_point deadline, int& status) {
  auto pause = std::chrono::microseconds(500);
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(20000));
  }
  return true;
}

}  // namespace

ChildEnd run_command(const std::string& command, double time_limit, const std::filesystem::path& output) {
  const std::string file = output.string();
  const pid_t child = fork();
  if (child < 0)
    throw InputError(
        fmt::format("{}: cannot be started: {} (free memory or processes)", command, std::strerror(errno)));
  if (child == 0) become(command.c_str(), file.c_str());
  setpgid(child, child);  // whichever of the two comes first
  const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_limit));
  int status = 0;
  ChildEnd end;
  end.timed_out = !wait_until(child, Clock::now() + limit, status);
  kill(-child, SIGKILL);
  if (end.timed_out) {
    waitpid(child, &status, 0);
    return end;
  }
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

}  // namespace handhold::compare
