// SPDX-License-Identifier: GPL-3.0-or-later
// Suites rot in silence: a case that is gone, a run that is not asked, a limit that grew. What there is stands in
// ratchet.txt, a line a case; who changes it rewrites that file (HANDHOLD_RATCHET=write compare_test
// --gtest_filter='Ratchet*:*EveryGateHolds*') and shows the difference.
#include "tests/compare/ratchet.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/judgement.hpp"

namespace handhold::compare {
namespace testing {

std::map<std::string, RatchetRow> read_ratchet() {
  std::map<std::string, RatchetRow> rows;
  std::ifstream file(HANDHOLD_RATCHET_FILE);
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream in(line);
    std::string id;
    RatchetRow row;
    in >> id >> row.runs >> row.claims >> row.asked >> row.studies >> row.limits >> row.vacuous;
    EXPECT_FALSE(in.fail()) << line;
    rows[id] = row;
  }
  return rows;
}

void write_ratchet(const std::map<std::string, RatchetRow>& rows) {
  std::ofstream file(HANDHOLD_RATCHET_FILE);
  file << "# case, runs, claims, claims times engines that are asked, order studies, digest of limits, vacuous gates\n";
  for (const auto& [id, r] : rows)
    file << fmt::format("{} {} {} {} {} {} {}\n", id, r.runs, r.claims, r.asked, r.studies, r.limits, r.vacuous);
}

bool ratchet_is_written() {
  const char* wish = std::getenv("HANDHOLD_RATCHET");
  return wish && std::string(wish) == "write";
}

}  // namespace testing

namespace {

using testing::RatchetRow;

/// FNV-1a.
class Digest {
 public:
  void put(const std::string& text) {
    for (const char c : text) value_ = (value_ ^ std::uint8_t(c)) * 0x100000001b3;
  }
  void put(const catalogue::Limit& l) {
    for (const double x : {l.value, l.per_accuracy, l.per_noise, l.per_rounding, l.per_step, l.per_delay})
      put(fmt::format("{:.6g} ", x));
    put(fmt::format("{} {}\n", l.recoveries, l.relative));
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_{0xcbf29ce484222325};
};

std::vector<EngineInfo> gated_engines() {
  std::vector<EngineInfo> out;
  for (const std::string& name : engine_names()) {
    const EngineInfo info = make_engine(name)->info({});
    if (info.errs.kind != ErrorModel::Kind::foreign) out.push_back(info);
  }
  return out;
}

RatchetRow row_of(const catalogue::Case& c) {
  RatchetRow row;
  Digest digest;
  for (const catalogue::Run& run : c.runs) {
    ++row.runs;
    for (const catalogue::Claim& claim : run.claims) {
      ++row.claims;
      digest.put(run.name + run.variant + claim.quantity);
      digest.put(claim.controlled);
      digest.put(claim.stepped);
      for (const EngineInfo& engine : gated_engines()) {
        if (std::ranges::find(engine.levels, c.level) == engine.levels.end()) continue;
        const bool steps = engine.errs.kind == ErrorModel::Kind::stepped;
        if ((steps && !run.not_stepped.empty()) || !why_not_asked(claim, engine).empty()) continue;
        ++row.asked;
        row.studies += steps && claim.converges;
      }
    }
  }
  row.limits = digest.text();
  return row;
}

TEST(Ratchet, NothingGoesAndNoLimitGrowsUnseen) {
  std::map<std::string, RatchetRow> known = testing::read_ratchet(), now;
  for (const catalogue::Case& c : catalogue::all_cases()) {
    now[c.id] = row_of(c);
    if (known.contains(c.id)) now[c.id].vacuous = known[c.id].vacuous;
  }
  if (testing::ratchet_is_written()) return testing::write_ratchet(now);
  for (const auto& [id, row] : now) EXPECT_TRUE(known.contains(id)) << id << " is not in ratchet.txt (write it anew)";
  for (const auto& [id, row] : known) {
    ASSERT_TRUE(now.contains(id)) << id << " is gone";
    const RatchetRow& found = now[id];
    EXPECT_TRUE(row == found) << id << ": was " << row.runs << " " << row.claims << " " << row.asked << " "
                              << row.studies << " " << row.limits << ", is " << found.runs << " " << found.claims << " "
                              << found.asked << " " << found.studies << " " << found.limits
                              << " (write ratchet.txt anew if that is meant)";
  }
}

}  // namespace
}  // namespace handhold::compare
