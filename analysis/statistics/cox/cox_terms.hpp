#pragma once
/// \file
/// Likelihood-ratio tests of the terms of a Cox model, as R's `anova.coxph` and `drop1` have them.

#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/cox/cox.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// A model on the way from one term to the next, or without one.
struct TermTest {
  std::string term;  ///< "NULL" or "<none>" in the first row.
  double loglik = 0.0;
  double aic = 0.0;
  std::optional<ChiSquareTest>
      test;  ///< Empty in the first row, and if the models are of the same rank.
};

struct TermTests {
  std::vector<TermTest> rows;  ///< Empty if there is an error.
  Conditions conditions;       ///< Those of the full model.
};

/// Both hold where a coefficient runs to infinity: the likelihoods are those of the limit, and such
/// a coefficient counts among the degrees of freedom, as in R.
///
/// Terms added in turn; row 0 is the model without any. The tests take the rows as independent: R
/// refuses them for robust fits, where a Wald test with `CoxFit::vcov` is the right one.
/// \throws std::invalid_argument as `fit_cox` does.
[[nodiscard]] TermTests cox_anova(const CoxData& data, const CoxOptions& options = {});

/// Each term taken out alone, unless it is part of an interaction; row 0 is the full model.
/// \throws std::invalid_argument as `fit_cox` does.
[[nodiscard]] TermTests cox_drop1(const CoxData& data, const CoxOptions& options = {});

}  // namespace tcert::statistics
