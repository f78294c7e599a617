// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/watched.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <stdexcept>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cases/model/input_error.hpp"

namespace handhold::fuzz {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
constexpr double longest = sanitized ? 60 : 10;    // [s]
constexpr rlim_t address_space = rlim_t{6} << 30;  // what stops a bomb before the machine does

enum Ending : int { done = 0, wrong_error = 10, memory = 11 };

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// What a child tells while it plays; lies in memory that both see.
struct Shared {
  std::atomic<std::size_t> number{};
  std::atomic<double> started{};
  std::atomic<std::size_t> read{}, refused{};
  std::atomic<double> slowest{}, most_memory{};
  char what[300]{};
};

// The peak of resident memory since `forget_peak` [MB]: proc(5), clear_refs and VmHWM.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

double peak() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::strtod(line.c_str() + 6, nullptr) / 1024;
  }
  return 0;
}

void tell(Shared& shared, const std::string& what) {
  std::snprintf(shared.what, sizeof shared.what, "%s", what.c_str());
}

// True if a line of a terminal stays one whatever the file held.
bool is_one_line(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; });
}

Ending play(const Trial& trial, std::size_t number, Shared& shared) {
  const std::filesystem::path file = trial.write(number);
  const double size = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  forget_peak();
  const double start = now();
  shared.number = number;
  shared.started = start;
  try {
    trial.read(file);
    ++shared.read;
  } catch (const InputError& error) {
    ++shared.refused;
    if (!is_one_line(error.what())) return tell(shared, std::string("not of one line: ") + error.what()), wrong_error;
  } catch (const std::exception& error) {
    return tell(shared, std::string("threw ") + error.what()), wrong_error;
  }
  shared.slowest = std::max(shared.slowest.load(), now() - start);
  const double used = peak();
  shared.most_memory = std::max(shared.most_memory.load(), used);
  if (!sanitized && used > 1000 + 20 * size)
    return tell(shared, std::to_string(used) + " MB for a file of " + std::to_string(size) + " MB"), memory;
  return done;
}

[[noreturn]] void be_child(const Trial& trial, std::size_t first, std::size_t end, Shared& shared) {
  const rlimit no_core{0, 0}, space{address_space, address_space};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (!sanitized) ::setrlimit(RLIMIT_AS, &space);
  if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(wrong_error);  // what aborts says so there
  Ending ending = done;
  for (std::size_t number = first; number < end && ending == done; ++number) ending = play(trial, number, shared);
  ::_exit(ending);
}

// Waits for the child; -1 if it had to be ended.
int wait_for(pid_t child, const Shared& shared) {
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (now() - shared.started < longest) {
      ::usleep(5000);
      continue;
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    return -1;
  }
  return status;
}

// Counts how a child ended; false if it came to its end.
bool count(int status, Tally& tally, Shared& shared) {
  if (status == -1) return ++tally.hangs, tell(shared, "hangs"), true;
  if (WIFSIGNALED(status)) return ++tally.signals, tell(shared, ::strsignal(WTERMSIG(status))), true;
  if (WEXITSTATUS(status) == done) return false;
  if (WEXITSTATUS(status) == memory) return ++tally.too_much_memory, true;
  return ++tally.other_errors, true;
}

}  // namespace

void play_watched(const Trial& trial, std::size_t first, std::size_t end, Tally& tally,
                  const std::function<void(std::size_t number, const std::string& what)>& fault) {
  void* const place = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::bad_alloc();
  Shared& shared = *new (place) Shared;
  for (std::size_t next = first; next < end;) {
    shared.number = next;
    shared.started = now();
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process can be made");
    if (child == 0) be_child(trial, next, end, shared);
    if (count(wait_for(child, shared), tally, shared)) {
      fault(shared.number, shared.what);
      next = shared.number + 1;
    } else {
      next = end;
    }
  }
  tally.trials += end - first;
  tally.read += shared.read;
  tally.refused += shared.refused;
  tally.slowest = std::max(tally.slowest, shared.slowest.load());
  tally.most_memory = std::max(tally.most_memory, shared.most_memory.load());
  ::munmap(place, sizeof(Shared));
}

}  // namespace handhold::fuzz
