#pragma once
/// \file
/// Likelihood-ratio tests between mixed models.

#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/glmm/glmm.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <vector>

namespace tcert::statistics {

/// The larger model against the smaller one, which must be nested in it and on the same rows: twice
/// the difference of the log-likelihoods, on as many degrees of freedom as it has parameters more
/// (`anova`). For fixed effects; random ones have `GlmmRandomTerm::test`. Empty without both
/// estimates. \throws std::invalid_argument if rows or quadrature differ, or `large` does not have
/// more parameters.
[[nodiscard]] std::optional<ChiSquareTest> compare_models(const GlmmFit& small,
                                                          const GlmmFit& large);

/// Each fixed term that no other contains against the model without it, as `drop1`, by the
/// quadrature of the whole model; `deviance` is -2 log-likelihood. A term whose model has no
/// estimate has no numbers. One fit a term, in parallel.
[[nodiscard]] std::vector<DroppedTerm> drop_terms(const GlmmInput& input,
                                                  const GlmmOptions& options = {});

}  // namespace tcert::statistics
