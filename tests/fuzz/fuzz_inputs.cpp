// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_inputs [SECONDS [SEED [KIND [MUTANTS]]]]: spoiled files of every kind through the readers of the program, for
// SECONDS (default: HANDHOLD_FUZZ_SECONDS, or 5), or MUTANTS of one kind, however long that takes. Each is read, or
// refused with an InputError of one line; a signal, another exception, more than 10 s or more memory than 1 GB and 20
// times the file is a fault: the mutant is kept, its place printed, and the program exits with 1.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/cases/input/mesh_files.hpp"
#include "tests/fuzz/input_kinds.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/watched.hpp"

namespace handhold::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t batch = 20;  // trials of a child, which takes a millisecond to begin

struct Settings {
  double seconds{5};
  std::uint64_t seed{1};
  std::string kind{};  // empty: all
  std::size_t mutants{std::numeric_limits<std::size_t>::max()};
};

class Fuzzer {
 public:
  explicit Fuzzer(const Settings& settings) : settings_(settings), kinds_(input_kinds()), tallies_(kinds_.size()) {}

  int run() {
    const auto start = std::chrono::steady_clock::now();
    const auto left = [&] {
      return settings_.seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (std::size_t done = 0; done < settings_.mutants && left() > 0; done += batch) {
      for (std::size_t k = 0; k < kinds_.size() && left() > 0; ++k) {
        if (settings_.kind.empty() || settings_.kind == kinds_[k].name)
          play(k, done, std::min(done + batch, settings_.mutants));
      }
    }
    return summary();
  }

 private:
  // Writes what lies beside, then the mutant of this number.
  fs::path write(std::size_t k, std::size_t number) const {
    const InputKind& kind = kinds_[k];
    Mutator mutator(settings_.seed * 1'000'003 + k * 100'000'007 + number * 10'000'000'019);
    std::vector<std::string> all;
    for (const SeedFile& seed : kind.seeds) all.push_back(seed.bytes);
    const std::size_t chosen = mutator.below(all.size());
    for (const SeedFile& file : kind.beside) (void)folder_.write(file.name, file.bytes);
    return folder_.write(kind.seeds[chosen].name, mutator.mutant(all[chosen], all));
  }

  void play(std::size_t k, std::size_t first, std::size_t end) {
    const Trial trial{[&](std::size_t number) { return write(k, number); }, kinds_[k].read};
    play_watched(trial, first, end, tallies_[k], [&](std::size_t number, const std::string& what) {
      const fs::path kept = fs::temp_directory_path() / ("handhold_fuzz_" + kinds_[k].name + "_" +
                                                         std::to_string(settings_.seed) + "_" + std::to_string(number));
      fs::create_directories(kept);
      (void)write(k, number);
      fs::copy(folder_.path(), kept, fs::copy_options::overwrite_existing);
      std::printf("%s %zu: %s (kept in %s)\n", kinds_[k].name.c_str(), number, what.c_str(), kept.c_str());
      std::fflush(stdout);
    });
  }

  int summary() const {
    std::printf("%-10s %8s %8s %8s %8s %6s %7s %7s %10s %8s\n", "kind", "mutants", "read", "refused", "signals",
                "hangs", "errors", "memory", "slowest s", "peak MB");
    std::size_t faults = 0;
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      const Tally& t = tallies_[k];
      if (t.trials == 0) continue;
      faults += t.faults();
      std::printf("%-10s %8zu %8zu %8zu %8zu %6zu %7zu %7zu %10.2f %8.0f\n", kinds_[k].name.c_str(), t.trials, t.read,
                  t.refused, t.signals, t.hangs, t.other_errors, t.too_much_memory, t.slowest, t.most_memory);
    }
    return faults > 0 ? 1 : 0;
  }

  Settings settings_;
  std::vector<InputKind> kinds_;
  std::vector<Tally> tallies_;
  files::Folder folder_;
};

Settings settings_of(int argc, char** argv) {
  Settings settings;
  if (const char* seconds = std::getenv("HANDHOLD_FUZZ_SECONDS")) settings.seconds = std::atof(seconds);
  if (argc > 1) settings.seconds = std::atof(argv[1]);
  if (argc > 2) settings.seed = std::strtoull(argv[2], nullptr, 10);
  if (argc > 3) settings.kind = argv[3];
  if (argc > 4) settings.mutants = std::strtoull(argv[4], nullptr, 10), settings.seconds = 1e9;
  return settings;
}

}  // namespace
}  // namespace handhold::fuzz

int main(int argc, char** argv) {
  ::unsetenv("HANDHOLD_CACHE");  // entries of a cache are among what is read; nothing else here asks for one
  try {
    return handhold::fuzz::Fuzzer(handhold::fuzz::settings_of(argc, argv)).run();
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 2;
  }
}
