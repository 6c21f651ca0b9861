#pragma once
/// \file
/// Random effects of mixed models as tables.

#include <optional>
#include <statistics/glmm/glmm.hpp>
#include <string>
#include <vector>

#include "reports/fit/cells.hpp"
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

/// Of a logistic or a linear mixed model: what its random effects explain, and how it was found.
template <class Fit>
void add_mixed_summary(const Fit& fit, Record& summary) {
  summary.number("ICC", "ICC", fit.icc)
      .number("R2_marginal", "marginal R2", fit.r2_marginal)
      .number("R2_conditional", "conditional R2", fit.r2_conditional)
      .text("singular", "singular", fit.singular ? "yes" : "no")
      .text("termination", "termination", std::string(statistics::to_string(fit.termination)))
      .integer("iterations", "iterations", static_cast<std::size_t>(fit.iterations))
      .integer("evaluations", "evaluations", static_cast<std::size_t>(fit.evaluations))
      .number("gradient_norm", "largest gradient", fit.gradient_norm)
      .number("last_step", "last step [SE]", fit.last_step);
}

}  // namespace tcert
