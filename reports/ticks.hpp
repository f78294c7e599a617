#pragma once

#include <string>
#include <vector>

namespace handhold::reports {

/// Multiples of 1, 2 or 5 times a power of ten that lie in [low, high]; at most `most` of them (>= 2), so that labels
/// stay short. Empty unless low < high, both finite.
[[nodiscard]] std::vector<double> linear_ticks(double low, double high, int most);

/// The same for a logarithmic axis, low > 0: whole decades when there are enough, else 1, 2, 5 in each.
[[nodiscard]] std::vector<double> log_ticks(double low, double high, int most);

/// The ticks as text: on a linear axis all with the same number of decimals; as powers when they are very large or
/// small.
[[nodiscard]] std::vector<std::string> tick_labels(const std::vector<double>& ticks, bool logarithmic);

}  // namespace handhold::reports
