// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/case_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/model/input_error.hpp"

namespace handhold::reports {
namespace {

constexpr std::string_view begin_mark = "<!-- table: cases ", mark_end = " -->\n", end_mark = "<!-- end -->";

/// A table in a document: what its marker asks for, and the place of its text.
struct Block {
  std::string level{};
  std::size_t begin{}, end{};
};

std::size_t line_of(const std::string& document, std::size_t place) {
  return 1 + std::size_t(std::count(document.begin(), document.begin() + std::ptrdiff_t(place), '\n'));
}

std::vector<Block> blocks_of(const std::string& document, const std::string& name) {
  std::vector<Block> out;
  for (std::size_t at = document.find(begin_mark); at != std::string::npos; at = document.find(begin_mark, at)) {
    const std::size_t line = line_of(document, at), word = at + begin_mark.size();
    const std::size_t begin = document.find(mark_end, word), end = document.find(end_mark, word);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
      throw InputError(fmt::format("{}:{}: a table has no end (write {} on a line below it)", name, line, end_mark));
    const std::string level = document.substr(word, begin - word);
    if (level != "L1" && level != "L2" && level != "L3")
      throw InputError(
          fmt::format("{}:{}: 'cases {}': no such table (there are cases L1, L2 and L3)", name, line, level));
    out.push_back({level, begin + mark_end.size(), end});
    at = end;
  }
  if (out.empty())
    throw InputError(
        fmt::format("{}: has no table (mark its place with two lines, {}L1 --> and {})", name, begin_mark, end_mark));
  return out;
}

std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return out;
}

std::string figure(double ratio) {
  if (std::isnan(ratio)) return "?";
  return ratio < 0.001 ? "< 0.001" : fmt::format("{:.1g}", ratio);
}

/// All of a row but its figures.
std::string fixed_part(const CaseRow& row) {
  return fmt::format("| {} | {} | {} | {} | {} |", row.id, cell(row.title), cell(row.formula), row.runs, row.claims);
}

std::vector<CaseRow> of_level(const std::vector<CaseRow>& rows, const std::string& level) {
  std::vector<CaseRow> out;
  for (const CaseRow& row : rows)
    if (row.level == level) out.push_back(row);
  return out;
}

std::string table(const std::vector<CaseRow>& rows) {
  std::set<std::string> engines;
  for (const CaseRow& row : rows)
    for (const auto& [engine, ratio] : row.worst) engines.insert(engine);
  std::string out = "| case | title | truth | runs | claims |", rule = "|---|---|---|---|---|";
  for (const std::string& engine : engines) {
    out += fmt::format(" {}: error / limit |", engine);
    rule += "---|";
  }
  out += "\n" + rule + "\n";
  for (const CaseRow& row : rows) {
    out += fixed_part(row);
    for (const std::string& engine : engines) {
      const auto found = row.worst.find(engine);
      out += fmt::format(" {} |", found == row.worst.end() ? "not asked" : figure(found->second));
    }
    out += "\n";
  }
  return out;
}

using Json = nlohmann::json;

double number_at(const Json& object, const char* key) {
  return object.at(key).is_null() ? std::numeric_limits<double>::quiet_NaN() : object.at(key).get<double>();
}

double error_over_limit(const Json& judgement) {
  const double error = number_at(judgement, "error"), limit = number_at(judgement, "limit");
  return error == 0 ? 0 : error / limit;
}

void add_judgements(const Json& claim, CaseRow& row) {
  for (const Json& judgement : claim.at("judgements")) {
    if (!judgement.contains("limit")) continue;
    const double ratio = error_over_limit(judgement);
    double& worst = row.worst[judgement.at("engine").get<std::string>()];
    if (!(ratio <= worst)) worst = ratio;  // NaN stays
  }
}

CaseRow row_of(const Json& of_case) {
  const auto text = [&](const char* key) { return of_case.at(key).get<std::string>(); };
  CaseRow row{text("id"), text("title"), text("formula"), text("level"), 0, 0, {}};
  for (const Json& run : of_case.at("runs")) {
    for (const Json& claim : run.at("claims")) add_judgements(claim, row);
    if (!run.at("variant").get<std::string>().empty()) continue;
    ++row.runs;
    row.claims += run.at("claims").size();
  }
  return row;
}

}  // namespace

std::vector<CaseRow> case_rows(const std::vector<catalogue::Case>& cases) {
  std::vector<CaseRow> rows;
  for (const catalogue::Case& c : cases) {
    CaseRow row{c.id, c.title, c.formula, std::string(to_string(c.level)), 0, 0, {}};
    for (const catalogue::Run& run : c.runs) {
      if (!run.variant.empty()) continue;
      ++row.runs;
      row.claims += run.claims.size();
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<CaseRow> case_rows(const std::string& results, const std::string& name) {
  try {
    const Json json = Json::parse(results);
    if (json.at("format") != "handhold results")
      throw InputError(name + ": no results of a suite (give a results.json)");
    std::vector<CaseRow> rows;
    for (const Json& of_case : json.at("cases")) rows.push_back(row_of(of_case));
    return rows;
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: no results of a suite: {} (give a results.json of this version)", name, error.what()));
  }
}

std::string with_tables(const std::string& document, const std::vector<CaseRow>& rows, const std::string& name) {
  std::string out;
  std::size_t done = 0;
  for (const Block& block : blocks_of(document, name)) {
    out += document.substr(done, block.begin - done) + table(of_level(rows, block.level));
    done = block.end;
  }
  return out + document.substr(done);
}

std::vector<std::string> stale_rows(const std::string& document, const std::vector<CaseRow>& rows,
                                    const std::string& name) {
  std::vector<std::string> out;
  for (const Block& block : blocks_of(document, name)) {
    const std::vector<CaseRow> wanted = of_level(rows, block.level);
    const std::string text = document.substr(block.begin, block.end - block.begin);
    const std::size_t line = line_of(document, block.begin);
    for (const CaseRow& row : wanted)
      if (text.find(fixed_part(row)) == std::string::npos)
        out.push_back(fmt::format("{}:{}: the row of {} is missing or out of date", name, line, row.id));
    const std::size_t lines = std::size_t(std::count(text.begin(), text.end(), '\n'));
    if (lines != wanted.size() + 2 && out.empty())
      out.push_back(fmt::format("{}:{}: has {} lines where there are {} cases", name, line, lines, wanted.size()));
  }
  return out;
}

}  // namespace handhold::reports
