#pragma once
/// \file
/// All pairs of a factor's levels compared, as a table.

#include <optional>
#include <statistics/model/pairwise.hpp>
#include <string>
#include <vector>

#include "reports/fit/interval_columns.hpp"

namespace tcert {

/// Table `contrasts`. With a ratio its columns are exp of the estimates and of both intervals.
/// `by` says what the intervals are by.
[[nodiscard]] Table contrast_table(const std::vector<statistics::PairContrast>& pairs,
                                   const std::string& column,
                                   const std::optional<RatioName>& ratio,
                                   const std::string& by);

}  // namespace tcert
