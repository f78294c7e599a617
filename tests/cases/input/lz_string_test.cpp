// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/lz_string.hpp"

#include <string>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

// Made with compressToBase64 of the original library (npm lz-string 1.5.0), not with ours.
TEST(LzString, DecodesWhatTheOriginalEncoded) {
  EXPECT_EQ(decompress_lz_string("BYUwNmD2Q==="), "hello");
  EXPECT_EQ(decompress_lz_string("BYUwNmD2AEDukCcwBMA01QRvJaPiiA=="), "hello world, hello world, hello");
  EXPECT_EQ(decompress_lz_string("IZA="), "a");
  EXPECT_EQ(decompress_lz_string("Q==="), "");
  EXPECT_EQ(decompress_lz_string("N4IgLiBcDaAMB0BGANAWgEzwKwFNUGYBdAXyA==="), "{\"t\":[0.1,-2.5e-3]}");
}

// A phrase that the very code completes (the first "aa" of "aaaa").
TEST(LzString, DecodesRuns) { EXPECT_EQ(decompress_lz_string("IY1/kA=="), std::string(20, 'a')); }

TEST(LzString, WritesUtf8) {
  EXPECT_EQ(decompress_lz_string("K0WwBAP2hE9o6tpA"), "\xC2\xB5m \xC3\xBC \xE6\xBC\xA2\xE5\xAD\x97");
}

TEST(LzString, IgnoresWhiteSpaceAround) { EXPECT_EQ(decompress_lz_string("\n BYUwNmD2Q===\r\n"), "hello"); }

TEST(LzString, SaysWhereTheTextIsBroken) {
  const auto message = [](const char* text) -> std::string {
    try {
      return "accepted " + decompress_lz_string(text, "grab.json.lz");
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("BYUw!mD2Q===").rfind("grab.json.lz, byte 4: this character is not base64", 0), 0u);
  EXPECT_EQ(message("BYUwNm").rfind("grab.json.lz, byte 6: the LZString text ends", 0), 0u);
  EXPECT_EQ(message("").rfind("grab.json.lz, byte 0: the LZString text ends", 0), 0u);
  EXPECT_NE(message("7777777777777777").find("unknown phrase"), std::string::npos);
}

// Every cut leaves out the end mark: none may be accepted, none may crash.
TEST(LzString, RejectsEveryTruncation) {
  const std::string whole = "BYUwNmD2AEDukCcwBMA01QRvJaPiiA==";
  for (std::size_t n = 0; n < 30; ++n) EXPECT_THROW((void)decompress_lz_string(whole.substr(0, n)), InputError) << n;
}

}  // namespace
}  // namespace handhold
