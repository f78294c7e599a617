// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/claim.hpp"

namespace handhold::compare {

/// How an engine errs: which of a claim's derived limits applies to it.
struct ErrorModel {
  enum class Kind {
    controlled,  ///< controls its local error to `accuracy`
    stepped,     ///< goes by fixed steps of length `step`, of first order
    foreign,     ///< nobody derived anything: its errors are graded, not gated
  };
  Kind kind{Kind::foreign};
  double accuracy{};  ///< [m, rad, m/s, ..., absolute]
  double step{};      ///< [s]
  double noise{};     ///< what it clears away of the state at an event [m, m/s]
  double delay{};     ///< by which it may find an event late [s]
  double recovery{};  ///< α: it holds contacts by equations whose errors decay as e^(−αt) [1/s]
  double rounding{};  ///< of a state of size 1, in a second of its steps [1/s]
};

/// The limit that applies, and its value. For a foreign engine there is none: do not ask.
[[nodiscard]] const catalogue::Limit& limit_of(const catalogue::Claim& claim, const ErrorModel& errs);
[[nodiscard]] double limit_value(const catalogue::Limit& limit, const ErrorModel& errs);

}  // namespace handhold::compare
