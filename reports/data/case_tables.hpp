// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "cases/catalogue/case.hpp"

namespace handhold::reports {

/// One row of a table of cases in a document.
struct CaseRow {
  std::string id{}, title{}, formula{};
  std::string level{};                    ///< "L1"
  std::size_t runs{}, claims{};           ///< variants (mirrored, turned, ...) are not counted
  std::map<std::string, double> worst{};  ///< by gated engine: greatest error over its limit, of all claims it judged
};

/// From the catalogue: no figures.
[[nodiscard]] std::vector<CaseRow> case_rows(const std::vector<catalogue::Case>& cases);

/// From the text of a results.json. Throws InputError if it is none; `name` is for the message.
[[nodiscard]] std::vector<CaseRow> case_rows(const std::string& results, const std::string& name);

/// The document with every block `<!-- table: cases L1 -->` ... `<!-- end -->` filled anew: a row a case of that level,
/// a column an engine that judged one. Figures are rounded to one digit. Throws InputError, naming the line, for a
/// marker that is unknown or has no end, and for a document without any.
[[nodiscard]] std::string with_tables(const std::string& document, const std::vector<CaseRow>& rows,
                                      const std::string& name);

/// What of the document's tables is out of date, a sentence a row; the figures, which depend on compiler and machine,
/// are not compared. Empty: nothing. Throws as with_tables does.
[[nodiscard]] std::vector<std::string> stale_rows(const std::string& document, const std::vector<CaseRow>& rows,
                                                  const std::string& name);

}  // namespace handhold::reports
