// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/suite.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"
#include "compare/judge/run_judge.hpp"
#include "compare/judge/verdict.hpp"

namespace handhold::compare {
namespace {

using catalogue::Case;
using catalogue::Run;

bool is_chosen(const Case& c, const SuiteOptions& options) {
  return (options.ids.empty() || std::ranges::find(options.ids, c.id) != options.ids.end()) &&
         (options.levels.empty() || std::ranges::find(options.levels, c.level) != options.levels.end());
}

std::vector<const Case*> chosen(const SuiteOptions& options) {
  const auto& all = catalogue::all_cases();
  std::vector<std::string> known;
  for (const Case& c : all) known.push_back(c.id);
  for (const std::string& id : options.ids)
    if (std::ranges::find(known, id) == known.end())
      throw InputError(fmt::format("case '{}': no such case (there are {})", id, fmt::join(known, ", ")));
  std::vector<const Case*> cases;
  for (const Case& c : all)
    if (is_chosen(c, options)) cases.push_back(&c);
  return cases;
}

/// The runs of a suite in their order, worked off by several threads. Each has a place of its own for its result.
class Work {
 public:
  Work(const std::vector<const Case*>& cases, const RunJudge& judge, const SuiteOptions& options,
       const SuiteProgress& progress)
      : judge_(judge), options_(options), progress_(progress) {
    const Shard shard = options.shard.value_or(Shard{});
    for (const Case* c : cases)
      for (const Run& run : c->runs) {
        if (!options.variants && !run.variant.empty()) continue;
        if (runs_++ % shard.of == shard.index - 1) items_.push_back({c, &run, {}});
      }
  }

  void run() {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = options_.threads > 0 ? std::size_t(options_.threads) : cores;
    std::vector<std::thread> pool;
    for (std::size_t i = 1; i < std::min(threads, items_.size()); ++i) pool.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : pool) thread.join();
    if (error_) std::rethrow_exception(error_);
  }

  [[nodiscard]] bool interrupted() const { return stopped_; }
  [[nodiscard]] std::size_t runs() const { return runs_; }  ///< of all shards

  /// The results of the case's runs that were done.
  [[nodiscard]] std::vector<RunResult> take(const Case& c) {
    std::vector<RunResult> out;
    for (Item& item : items_)
      if (item.of_case == &c && item.result) out.push_back(std::move(*item.result));
    return out;
  }

 private:
  struct Item {
    const Case* of_case;
    const Run* run;
    std::optional<RunResult> result;
  };

  void work() {
    for (std::size_t i = next_++; i < items_.size() && !stopped_; i = next_++) {
      try {
        if (!announce(items_[i])) return;
        std::optional<RunResult>& result = items_[i].result;
        result = judge_.judge(*items_[i].run, items_[i].of_case->level);
        ++done_;
        if (!result || (options_.fail_fast && has_failure(*result))) stopped_ = true;
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();
        stopped_ = true;
      }
    }
  }

  bool announce(const Item& item) {
    const std::lock_guard lock(mutex_);
    if (stopped_) return false;
    if (progress_ && !progress_(fmt::format("{} {}", item.of_case->id, item.run->name), done_, items_.size()))
      stopped_ = true;
    return !stopped_;
  }

  static bool has_failure(const RunResult& run) {
    return std::ranges::any_of(run.claims, [](const ClaimResult& claim) {
      return std::ranges::any_of(claim.judgements, [](const Judgement& j) { return j.gate && !passes(*j.gate); });
    });
  }

  const RunJudge& judge_;
  const SuiteOptions& options_;
  const SuiteProgress& progress_;
  std::vector<Item> items_{};
  std::size_t runs_{0};
  std::atomic<std::size_t> next_{0}, done_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_{};
  std::exception_ptr error_{};
};

}  // namespace

SuiteResult run_suite(const std::vector<const Engine*>& engines, const SuiteOptions& options,
                      const SuiteProgress& progress) {
  if (engines.empty()) throw InputError("no engine: a suite needs at least one (see handhold engines)");
  const auto start = std::chrono::steady_clock::now();
  const RunJudge judge(engines, options);
  const std::vector<const Case*> cases = chosen(options);
  Work work(cases, judge, options, progress);
  work.run();
  SuiteResult result{
      .engines = judge.engines(), .interrupted = work.interrupted(), .shard = options.shard, .runs = work.runs()};
  for (const Case* c : cases) {
    CaseResult judged{c->id, c->title, c->statement, c->formula, c->note, c->truth_level, c->level, work.take(*c)};
    if (!judged.runs.empty()) result.cases.push_back(std::move(judged));
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace handhold::compare
