// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to what works on stored reports: shows nlohmann::json.

#include <string>

#include <nlohmann/json.hpp>

#include "compare/judge/verdict.hpp"
#include "reports/data/stored_report.hpp"

namespace handhold::reports {

/// The member `verdict` of results.json.
[[nodiscard]] nlohmann::ordered_json verdict_json(const compare::Standing& standing);

/// results.json; throws InputError if it is none of version 2.
[[nodiscard]] nlohmann::ordered_json parsed_results(const NamedReport& report);

/// times.json; times are no need of a report: where there are none, an empty list.
[[nodiscard]] nlohmann::ordered_json parsed_times(const StoredReport& report);

/// Adds the plays of `part`; texts that differ stand beside each other, told apart by `label`.
void append_times(nlohmann::ordered_json& into, const nlohmann::ordered_json& part, const std::string& label);

/// Adds members; where one is there with another value, under its name and `label`.
void append_texts(nlohmann::ordered_json& into, const nlohmann::ordered_json& part, const std::string& label);

/// As results.json and times.json are written.
[[nodiscard]] std::string file_text(const nlohmann::ordered_json& json);

}  // namespace handhold::reports
