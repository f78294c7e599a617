#include "reports/page.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/reports/markup.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

TEST(Page, IsWellFormed) { EXPECT_EQ(markup_fault(page(sample_result())), ""); }

TEST(Page, TitleAndFirstLineAreTheVerdict) {
  const std::string html = page(sample_result());
  EXPECT_NE(html.find("<title>Failed: 2 of 7 gates"), std::string::npos);
  EXPECT_NE(html.find("<h1>✗ Failed: 2 of 7 gates</h1>"), std::string::npos);
}

TEST(Page, NeedsNoScriptAndNoNetwork) {
  const std::string html = page(sample_result());
  for (const char* forbidden : {"<script", "<link", "<img", "src=", "http:", "https:", "url(", "@import", "onclick"}) {
    EXPECT_EQ(html.find(forbidden), std::string::npos) << forbidden;
  }
}

TEST(Page, EscapesEveryText) {
  compare::SuiteResult result = sample_result();
  const std::string evil = "<b>\"'&";
  for (compare::CaseResult& c : result.cases) {
    c.id = c.title = c.level = c.statement = c.formula = c.note = evil;
    for (compare::RunResult& run : c.runs) {
      run.name = run.curve.label = run.reference_note = run.realtime_note = evil;
      for (compare::Finding& f : run.findings) {
        f.expectation.quantity = f.expectation.unit = f.expectation.source = evil;
        for (compare::Gate* g : {&f.reference.gate, &f.realtime.gate}) g->quantity = g->unit = g->reason = evil;
        if (f.study) f.study->gate.quantity = f.study->gate.unit = f.study->gate.reason = evil;
      }
    }
  }
  result.provenance = {{evil, evil}, {"command", evil}};
  const std::string html = page(result);
  EXPECT_EQ(markup_fault(html), "");
  EXPECT_EQ(html.find("<b>\""), std::string::npos);
  EXPECT_EQ(html.find("\"'&"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;&quot;&#39;&amp;"), std::string::npos);
}

TEST(Page, FailedGatesStandFirst) {
  const std::string html = page(sample_result());
  const std::size_t failed = html.find("✗ failed</span></td>"), holds = html.find("✓ holds</span></td>");
  ASSERT_NE(failed, std::string::npos);
  ASSERT_NE(holds, std::string::npos);
  EXPECT_LT(failed, holds);
}

TEST(Page, HasThePlotsWithTitlesAndResiduals) {
  const std::string html = page(sample_result());
  EXPECT_EQ(occurrences(html, "class=\"plot\""), 2u);  // one curve, one order study
  EXPECT_EQ(occurrences(html, "</title>"), 3u);        // theirs and the page's
  // The reference is off by 1.4e-9 sin(9 t): its largest sample is 1.4 nm. Real time: 0.01 * 0.5 * 0.49 * 0.64 m + 20
  // µm = 1.588 mm.
  EXPECT_NE(html.find("reference − truth [nm]"), std::string::npos);
  EXPECT_NE(html.find("largest 1.4 nm"), std::string::npos);
  EXPECT_NE(html.find("real time − truth [mm]"), std::string::npos);
  EXPECT_NE(html.find("largest 1.59 mm"), std::string::npos);
  EXPECT_NE(html.find("order 1.01 ± 0.02"), std::string::npos);
}

TEST(Page, SameBytesForTheSameResult) { EXPECT_EQ(page(sample_result()), page(sample_result())); }

TEST(Page, SurvivesNumbersThatCannotBeDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  compare::SuiteResult result = sample_result();
  compare::RunResult& run = result.cases[0].runs[0];
  run.curve.realtime.assign(run.curve.t.size(), nan);
  run.curve.reference[5] = inf;
  run.curve.truth.assign(run.curve.t.size(), 1e300);
  run.findings[1].study->error = {0, nan, -1, inf};
  run.findings[1].study->order = {nan, nan};
  run.reference_seconds = nan;
  const std::string html = page(result);
  EXPECT_EQ(markup_fault(html), "");
  for (const char* bad : {"=\"nan", "=\"inf", "Mnan", "Lnan", "Minf", " nan", "-nan", " inf"})
    EXPECT_EQ(html.find(bad), std::string::npos) << bad;
}

TEST(Page, AnEmptyResultIsAPageThatSaysSo) {
  const std::string html = page({});
  EXPECT_EQ(markup_fault(html), "");
  EXPECT_NE(html.find("Failed: no gate was judged"), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
