// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/input_error.hpp"

#include <gtest/gtest.h>

namespace handhold {
namespace {

TEST(InputError, IsOfOneLineWhateverAFileHeld) {
  EXPECT_STREQ(InputError("a.csv:3: \"1\n\r\t\x1b\x7f 2 µm\"").what(), "a.csv:3: \"1      2 µm\"");
}

}  // namespace
}  // namespace handhold
