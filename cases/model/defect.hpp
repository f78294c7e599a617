// SPDX-License-Identifier: Apache-2.0
#pragma once

/// DEFECT(name, right, wrong) is `right`: a place where the kill matrix (docs/kill-matrix.md) plants a defect to see
/// which claim or test notices. Its program alone is compiled with HANDHOLD_DEFECTS; there the place is `wrong` while
/// HANDHOLD_DEFECT in the environment is `name`. Both are of one type; commas stand in brackets.
#ifdef HANDHOLD_DEFECTS

#include <cstdlib>
#include <string_view>

namespace handhold {

inline bool is_planted(std::string_view name) {
  const char* const planted = std::getenv("HANDHOLD_DEFECT");
  return planted && name == planted;
}

}  // namespace handhold

#define DEFECT(name, right, wrong)                           \
  ([] {                                                      \
    static const bool planted = handhold::is_planted(#name); \
    return planted;                                          \
  }()                                                        \
       ? (wrong)                                             \
       : (right))

#else
#define DEFECT(name, right, wrong) (right)
#endif
