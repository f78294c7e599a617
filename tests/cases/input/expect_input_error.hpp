// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"

namespace handhold {

/// Expects `run` to throw an InputError of one line that contains every one of `parts`.
template <typename Run>
void expect_input_error(const Run& run, const std::vector<std::string>& parts) {
  try {
    run();
    ADD_FAILURE() << "accepted; expected an error with '" << (parts.empty() ? "" : parts.front()) << "'";
  } catch (const InputError& error) {
    const std::string what = error.what();
    for (const std::string& part : parts)
      EXPECT_NE(what.find(part), std::string::npos) << "'" << part << "' in: " << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_NE(what.find('('), std::string::npos) << "no advice in: " << what;
  }
}

}  // namespace handhold
