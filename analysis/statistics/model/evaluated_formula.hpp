#pragma once
/// \file
/// Everything that a formula and its options name, on all rows of a table. Internal to
/// model_frame.cpp.

#include <statistics/model/design_matrix.hpp>
#include <statistics/model/model_frame.hpp>
#include <vector>

namespace tcert::statistics {

struct EvaluatedFormula {
  const Formula& formula;
  const table::DataTable& table;
  const FrameOptions& options;
  std::vector<NamedVariable> outcome;  ///< One, or the arguments of Surv() and cbind().
  std::vector<NamedVariable> right;    ///< Of the terms, each once.
  std::vector<NamedVariable> slopes;   ///< Of the random terms, each once.
  std::vector<NamedVariable> groups;   ///< One a random term.
  std::vector<NamedVariable> offsets, strata, clusters, weights;
  bool strata_are_text = true;  ///< All that the formula names.
};

/// \throws FormulaError as model_frame() does, except for an outcome without two levels.
[[nodiscard]] EvaluatedFormula evaluate_formula(const Formula& formula,
                                                const table::DataTable& table,
                                                const FrameOptions& options);

[[nodiscard]] bool has_variable(const std::vector<NamedVariable>& variables,
                                const Expression& expression);

/// The text column that x, (x) or I(x) names; null for anything else.
[[nodiscard]] const table::DataColumn* text_column(const Expression& expression,
                                                   const table::DataTable& table);

}  // namespace tcert::statistics
