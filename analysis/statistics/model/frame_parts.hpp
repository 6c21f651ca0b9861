#pragma once
/// \file
/// The parts of a model frame, each from the evaluated formula: first the rows, then the others on
/// these. Internal to model_frame.cpp.

#include <cstddef>
#include <statistics/model/evaluated_formula.hpp>
#include <vector>

namespace tcert::statistics {

/// The complete rows, and what the others lack.
void take_rows(const EvaluatedFormula& all, ModelFrame& frame);

[[nodiscard]] std::vector<double> on_rows(const std::vector<double>& numbers,
                                          const std::vector<std::size_t>& rows);

/// \throws FormulaError if Surv() or cbind() has too few or too many arguments, or a text has not
/// two levels.
void take_outcome(const EvaluatedFormula& all, ModelFrame& frame);

/// The predictors as design or groups, and the random effects: `all` loses its other rows.
/// \throws FormulaError for groups that cannot be compared.
void take_right_side(EvaluatedFormula& all, ModelFrame& frame);
void take_random_effects(EvaluatedFormula& all, ModelFrame& frame);

void take_strata(const EvaluatedFormula& all, ModelFrame& frame);

}  // namespace tcert::statistics
