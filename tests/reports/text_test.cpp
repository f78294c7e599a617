#include "reports/data/text.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/ticks.hpp"

namespace handhold::reports {
namespace {

TEST(Text, CleanKeepsValidUtf8AndReplacesTheRest) {  // boundaries from RFC 3629, section 4
  for (const std::string good : {"a", "µ", "−", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF", "\t\n"})
    EXPECT_EQ(clean_utf8(good), good);
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_utf8("\xC0\x80"), mark + mark);                // overlong
  EXPECT_EQ(clean_utf8("\xED\xA0\x80"), mark + mark + mark);     // surrogate
  EXPECT_EQ(clean_utf8("\xF4\x90\x80\x80").substr(0, 3), mark);  // beyond U+10FFFF
  EXPECT_EQ(clean_utf8("\xE2\x88"), mark + mark);                // cut short
  EXPECT_EQ(clean_utf8(std::string("\0\x1b", 2)), mark + mark);  // controls
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

TEST(Text, Numbers) {
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "none");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(error_number(0.0083, true), "0.83 %");
  EXPECT_EQ(typographic("-1.2e-05"), "−1.2×10⁻⁵");
  EXPECT_EQ(typographic("1e+10 %"), "1×10¹⁰ %");
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

TEST(Ticks, AreRoundAndInside) {
  EXPECT_EQ(linear_ticks(0, 1, 6), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  EXPECT_EQ(tick_labels(linear_ticks(0, 1, 6), false),
            (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(tick_labels(linear_ticks(-35, 35, 4), false), (std::vector<std::string>{"−20", "0", "20"}));
  EXPECT_EQ(tick_labels(log_ticks(0.3, 3.3, 6), true), (std::vector<std::string>{"0.5", "1", "2"}));
  EXPECT_EQ(tick_labels(log_ticks(1e-9, 1e-3, 8), true).front(), "1×10⁻⁹");
}

TEST(Ticks, NeverTooManyWhateverTheRange) {
  for (const double span : {1e-300, 1e-9, 0.37, 1.0, 999.0, 1e300}) {
    for (const int most : {2, 4, 6}) {
      EXPECT_LE(linear_ticks(-span, span, most).size(), std::size_t(most));
      EXPECT_GE(linear_ticks(-span, span, most).size(), 1u);
      EXPECT_LE(log_ticks(1e-12 * span, span, most).size(), std::size_t(most));
    }
  }
  EXPECT_TRUE(linear_ticks(1, 1, 5).empty());
  EXPECT_TRUE(linear_ticks(1, std::nextafter(1, 2), 5).empty());
  EXPECT_TRUE(log_ticks(0, 1, 5).empty());
}

}  // namespace
}  // namespace handhold::reports
