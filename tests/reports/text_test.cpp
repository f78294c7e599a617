// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/text.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "cases/input/text_encoding.hpp"

namespace handhold::reports {
namespace {

TEST(Text, CleanKeepsValidUtf8AndReplacesTheRest) {  // boundaries from RFC 3629, section 4
  for (const std::string good : {"a", "µ", "−", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF", "\t\n"})
    EXPECT_EQ(clean_text(good), good);
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text("\xC0\x80"), mark + mark);                // overlong
  EXPECT_EQ(clean_text("\xED\xA0\x80"), mark + mark + mark);     // surrogate
  EXPECT_EQ(clean_text("\xF4\x90\x80\x80").substr(0, 3), mark);  // beyond U+10FFFF
  EXPECT_EQ(clean_text("\xE2\x88"), mark + mark);                // cut short
  EXPECT_EQ(clean_text(std::string("\0\x1b", 2)), mark + mark);  // controls
}

// Escape sequences, C1 controls and marks of direction command terminals and reorder what people read.
TEST(Text, CleanReplacesWhatCommandsOrReorders) {
  const std::string mark = "\xEF\xBF\xBD";
  for (const std::string bad : {"\x1b", "\x07", "\x7F", "\xC2\x9B", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x80\x8F",
                                "\xD8\x9C", "\xE2\x80\xA8"}) {
    EXPECT_EQ(clean_text("a" + bad + "b"), "a" + mark + "b");
    EXPECT_EQ(one_line(bad), mark);  // terminal
    EXPECT_EQ(escape(bad), mark);    // HTML and JUnit
  }
  EXPECT_EQ(escape_hidden("\"a\xE2\x80\xAE\xC2\x9B\x7F\xC2\xB5\""), "\"a\\u202e\\u009b\\u007f\xC2\xB5\"");  // JSON
}

TEST(Text, PadsByWidthNotBytes) {
  EXPECT_EQ(left("µm", 4), "µm  ");
  EXPECT_EQ(right("µm", 4), "  µm");
  EXPECT_EQ(left("abcdef", 4), "abc…");
  EXPECT_EQ(right("12345", 4), "12345");
}

TEST(Text, LongSummariesGoOnBelow) {
  EXPECT_EQ(summary_line("size", "1\n2"), "  size              1 2\n");
  const std::string word(60, 'x');
  EXPECT_EQ(summary_line("size", word + " " + word),
            "  size              " + word + "\n" + std::string(20, ' ') + word + "\n");
}

TEST(Text, AnOrderShowsAsManyDecimalsAsItsError) {
  EXPECT_EQ(with_error(1.0149, 0.0213), "1.01 ± 0.02");
  EXPECT_EQ(with_error(0.98312, 0.0041), "0.983 ± 0.004");
  EXPECT_EQ(with_error(1, 1e-11), "1.000 ± <0.001");
  EXPECT_EQ(with_error(std::nan(""), std::nan("")), "none ± none");
}

TEST(Text, ReadableChoosesThePrefix) {
  EXPECT_EQ(readable(3.2e-6, "m"), "3.2 µm");
  EXPECT_EQ(readable(0.0111, "s"), "11.1 ms");
  EXPECT_EQ(readable(1e-3, "s"), "1 ms");  // log10 of 1e-3 is not exact
  EXPECT_EQ(readable(2, "m"), "2 m");
  EXPECT_EQ(readable(0, "m"), "0 m");
  EXPECT_EQ(readable(2e-9, "kg m²"), "2×10⁻⁹ kg m²");
}

}  // namespace
}  // namespace handhold::reports
