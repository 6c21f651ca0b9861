#pragma once
/// \file
/// Likelihood-ratio tests of the terms of a logistic regression, each against the model without it.

#include <cstddef>
#include <optional>
#include <statistics/logistic/logistic.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// One term that is left out.
struct DroppedTerm {
  std::string term;
  std::size_t df = 0;                 ///< By how much the rank falls; 0 if the others replace it.
  std::optional<double> deviance;     ///< Without the term; under separation its infimum.
  std::optional<double> aic;          ///< Without the term. Empty under separation.
  std::optional<double> chi_squared;  ///< Twice the drop of the log-likelihood.
  std::optional<double> p_value;      ///< Empty if df is 0.
};

/// Terms that no other term contains, in the order of the formula, as `drop1(test = "Chisq")`.
/// Empty if the whole model has no estimate. Under separation the likelihoods are suprema, which
/// exist; the test is then as good as its chi-squared distribution. \throws std::invalid_argument
/// as `fit_logistic`. One fit a term.
[[nodiscard]] std::vector<DroppedTerm> drop_terms(const LogisticInput& input,
                                                  const NewtonOptions& options = {});

/// The input without the columns of a term (an index into `terms`, which stay as they are).
[[nodiscard]] LogisticInput without_term(const LogisticInput& input, std::size_t term);

}  // namespace tcert::statistics
