// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace handhold::mutants {

/// A defect that a DEFECT in the sources plants, and who should see it.
struct Defect {
  std::string name{};
  std::string what{};                ///< what is wrong, in words
  std::vector<std::string> cases{};  ///< whose gates are asked first; empty: no gate can see it
  std::string tests{};               ///< gtest filter, asked if no gate sees it
};

/// All of them, in the order of the document.
[[nodiscard]] const std::vector<Defect>& all_defects();

}  // namespace handhold::mutants
