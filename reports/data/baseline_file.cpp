// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/baseline_file.hpp"

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cases/input/text_file.hpp"
#include "cases/model/input_error.hpp"
#include "reports/data/stored_json.hpp"

namespace handhold::reports {
namespace {

using compare::GateName;
using compare::Measured;
using Json = nlohmann::ordered_json;

constexpr const char* format_name = "handhold baseline";
constexpr const char* order_mark = " order";  // after an engine's name: the study of its order

double number_or_nan(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string run_name(const Json& run) {
  const std::string name = run["name"].get<std::string>(), variant = run["variant"].get<std::string>();
  return variant.empty() ? name : name + ", " + variant;
}

void add_claim(const GateName& of_run, const Json& claim, compare::Baseline& out) {
  GateName name = of_run;
  name.claim = claim["quantity"];
  for (const Json& judgement : claim["judgements"]) {
    if (!judgement.contains("limit")) continue;  // not asked, or graded
    name.engine = judgement["engine"];
    out[name] = {.truth = number_or_nan(claim["truth"]),
                 .value = number_or_nan(judgement["value"]),
                 .limit = number_or_nan(judgement["limit"]),
                 .relative = judgement["relative"].get<bool>()};
  }
  name.order = true;
  for (const Json& study : claim["studies"]) {
    name.engine = study["engine"];
    const double limit = number_or_nan(study["limit"]), slack = number_or_nan(study["slack"]);
    const bool exact = study.value("slack_text", "") == "inf";
    out[name] = {
        .value = exact ? 0 : limit / slack, .limit = limit, .uncertainty = number_or_nan(study["standard_error"])};
  }
}

/// [value, limit], and a third number that is the standard error of an order, or true if the limit is relative.
Json row(const GateName& name, const Measured& m) {
  Json out = Json::array({finite_or_null(m.value), m.limit});
  if (name.order) out.push_back(finite_or_null(m.uncertainty));
  if (m.relative) out.push_back(true);
  return out;
}

Measured measured(const Json& row, double truth, bool order) {
  Measured out{.truth = order ? 0 : truth, .value = number_or_nan(row.at(0)), .limit = row.at(1).get<double>()};
  out.relative = !order && row.size() > 2;
  if (order) out.uncertainty = number_or_nan(row.at(2));
  return out;
}

void read_claim(const GateName& of_claim, const Json& claim, compare::Baseline& out) {
  for (const auto& [key, value] : claim.items()) {
    if (key == "truth") continue;
    GateName name = of_claim;
    name.order = key.size() > 6 && key.substr(key.size() - 6) == order_mark;
    name.engine = name.order ? key.substr(0, key.size() - 6) : key;
    out[name] = measured(value, number_or_nan(claim.value("truth", Json())), name.order);
  }
}

compare::Baseline gates_of(const Json& cases) {
  compare::Baseline out;
  for (const auto& [of_case, runs] : cases.items())
    for (const auto& [run, claims] : runs.items())
      for (const auto& [claim, engines] : claims.items())
        read_claim({.of_case = of_case, .run = run, .claim = claim}, engines, out);
  return out;
}

}  // namespace

compare::Baseline baseline_of(const std::string& results, const std::string& name) {
  compare::Baseline out;
  const Json parsed = parsed_results({name, {.results = results}});
  for (const Json& of_case : parsed["cases"])
    for (const Json& run : of_case["runs"])
      for (const Json& claim : run["claims"])
        add_claim({.of_case = of_case["id"].get<std::string>(), .run = run_name(run)}, claim, out);
  return out;
}

BaselineFile read_baseline(const std::filesystem::path& path) {
  const std::string where = path.string();
  try {
    const Json json = Json::parse(read_text_file(path));
    if (json.at("format") != format_name || json.at("version") != 1)
      throw InputError(
          fmt::format("{}: is no '{}' of version 1 (write it anew with handhold baseline update)", where, format_name));
    return {.gates = gates_of(json.at("cases")), .reasons = json.at("reasons").get<std::vector<std::string>>()};
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: is no baseline, {} (write it with handhold baseline update)", where, error.what()));
  }
}

std::string to_json(const BaselineFile& file) {
  std::map<std::tuple<std::string, std::string, std::string>, Json> claims;
  for (const auto& [name, m] : file.gates) {
    Json& claim = claims[{name.of_case, name.run, name.claim}];
    if (!name.order) claim["truth"] = finite_or_null(m.truth);
    claim[name.engine + (name.order ? order_mark : "")] = row(name, m);
  }
  std::string out = fmt::format("{{\"format\": \"{}\", \"version\": 1,\n\"reasons\": {},\n\"cases\": {{", format_name,
                                Json(file.reasons).dump());
  std::string of_case, run;
  for (const auto& [place, claim] : claims) {
    const auto& [case_now, run_now, quantity] = place;
    const bool first_case = of_case.empty(), new_case = case_now != of_case, new_run = new_case || run_now != run;
    if (!first_case) out += new_case ? "}}," : new_run ? "}," : ",";
    if (new_case) out += fmt::format("\n{}: {{", Json(case_now).dump());
    if (new_run) out += fmt::format("\n {}: {{", Json(run_now).dump());
    out += fmt::format("\n  {}: {}", Json(quantity).dump(), claim.dump());
    std::tie(of_case, run) = std::tie(case_now, run_now);
  }
  return out + (claims.empty() ? "}}\n" : "}}}}\n");
}

}  // namespace handhold::reports
