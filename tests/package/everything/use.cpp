// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include <handhold/cases/catalogue/case.hpp>
#include <handhold/compare/engine/engines.hpp>

// The installed package has its engines and its catalogue.
int main() {
  for (const auto& name : handhold::compare::engine_names()) {
    const auto engine = handhold::compare::make_engine(name);
    std::printf("engine %s\n", engine->info({}).name.c_str());
    if (engine->info({}).name != name) return 1;
  }
  const auto& cases = handhold::catalogue::all_cases();
  std::printf("%zu cases\n", cases.size());
  return cases.empty() ? 1 : 0;
}
