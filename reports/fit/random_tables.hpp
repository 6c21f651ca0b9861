#pragma once
/// \file
/// Random effects of mixed models as tables.

#include <optional>
#include <statistics/glmm/glmm.hpp>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// A standard deviation, sd__COLUMN, or a correlation, cor__COLUMN.COLUMN.
struct RandomParameter {
  std::string name;
  std::optional<double> value;
};

/// The deviations of a term, then its correlations.
[[nodiscard]] std::vector<RandomParameter> random_parameters(
    const statistics::GlmmRandomTerm& term);

/// Table random: each term's test on the boundary, half chi-squared with df - 1, half with df.
[[nodiscard]] Table boundary_table(const std::vector<statistics::GlmmRandomTerm>& random);

/// Table ran_vals: the conditional modes.
[[nodiscard]] Table mode_table(const std::vector<statistics::GlmmRandomTerm>& random);

}  // namespace tcert
