// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <string>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engines.hpp"
#include "tests/bits/digest.hpp"

// Prints a number for all bits of every recording of the suite: one line a case, run and engine. A change that only
// moves or renames code leaves its output as it was (`diff` before and after).

namespace handhold::compare {
namespace {

using handhold::testing::Digest;

std::uint64_t digest_of(const Recording& recording) {
  Digest digest;
  for (const Frame& frame : recording.frames) {
    digest.put(frame.t);
    for (const BodyState& body : frame.bodies) {
      digest.put(body.X_WO);
      digest.put(body.V_WO.v);
      digest.put(body.V_WO.w);
    }
    for (const ContactState& contact : frame.contacts) digest.put(contact);
    digest.put(frame.energy);
  }
  for (const Event& event : recording.events) digest.put(event);
  return digest.value();
}

void print_all() {
  for (const catalogue::Case& of_case : catalogue::all_cases()) {
    for (const catalogue::Run& run : of_case.runs) {
      if (!run.variant.empty()) continue;
      const Problem problem = run.problem();
      for (const std::string& name : engine_names()) {
        const auto engine = make_engine(name);
        const EngineInfo info = engine->info({});
        if (std::ranges::find(info.levels, of_case.level) == info.levels.end() || !engine->why_not(problem).empty() ||
            (info.errs.kind == ErrorModel::Kind::stepped && !run.not_stepped.empty()))
          continue;
        const Recording recording = engine->play(problem, {});
        std::printf("%s/%s %s: %016llx\n", of_case.id.c_str(), run.name.c_str(), name.c_str(),
                    (unsigned long long)(digest_of(recording)));
      }
    }
  }
}

}  // namespace
}  // namespace handhold::compare

int main() {
  handhold::compare::print_all();
  return 0;
}
