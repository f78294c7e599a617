#pragma once

#include <string>
#include <string_view>

#include "compare/judge/suite.hpp"
#include "reports/data/placed_gate.hpp"

/// The pieces that `page` is put together from. Every function returns HTML with its texts escaped.
namespace handhold::reports {

/// The one style sheet: light and dark by the reader's setting, readable on a phone and in print.
[[nodiscard]] std::string_view page_style();

/// A verdict as a sign and a word.
[[nodiscard]] std::string verdict_tag(Verdict verdict);

/// "1.2×10⁻⁵" from a double, and the same for errors and limits.
[[nodiscard]] std::string html_number(double value, int digits = 6);
[[nodiscard]] std::string html_error(double value, bool relative);

/// All gates: failed and vacuous ones first and open, the rest folded away when there are many.
[[nodiscard]] std::string gates_section(const compare::SuiteResult& result);

/// Percentiles of the real-time path's frames against the 90 Hz frame, a row a run.
[[nodiscard]] std::string frames_section(const compare::SuiteResult& result);

/// Statement, formula, note, and every run's quantities and figures.
[[nodiscard]] std::string case_section(const compare::CaseResult& of_case, std::size_t index);

/// Slip against truth with the residual of each engine below, each in a scale of its own; empty without data.
[[nodiscard]] std::string curve_figure(const compare::RunResult& run, const std::string& id);

/// Error against sub-step, log-log, with the observed order; empty without a study.
[[nodiscard]] std::string order_figure(const compare::Finding& finding, const std::string& id);

}  // namespace handhold::reports
