// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cases/catalogue/claim.hpp"
#include "compare/engine/engine.hpp"
#include "compare/judge/gate.hpp"

namespace handhold::compare {

/// How right a foreign engine is: within that share of the claim's scale, or not. Yes/no claims are right or wrong.
enum class Grade { right, within_0_1_percent, within_1_percent, within_5_percent, wrong };

/// "right", "0.1 %", "1 %", "5 %", "wrong"
[[nodiscard]] std::string_view to_string(Grade grade);

/// One engine's answer to one claim. Exactly one of `why_not`, `gate` and `grade` is there.
struct Judgement {
  std::string engine{};
  std::string why_not{};         ///< not asked, and why
  double value{};                ///< measured; NaN when the recording does not show it, or nobody asked
  double error{};                ///< |value − truth|, or |value / truth − 1| where the limit is relative
  bool relative{false};          ///< which of the two
  std::optional<Gate> gate{};    ///< of an engine whose limit is derived
  std::optional<Grade> grade{};  ///< of a foreign engine
};

/// Why the engine is not asked about a claim: a recording of its kind cannot show it. Empty: it is asked.
[[nodiscard]] std::string why_not_asked(const catalogue::Claim& claim, const EngineInfo& engine);

[[nodiscard]] Judgement judge(const catalogue::Claim& claim, const EngineInfo& engine, double value);
[[nodiscard]] Judgement not_asked(const EngineInfo& engine, const std::string& why);

}  // namespace handhold::compare
