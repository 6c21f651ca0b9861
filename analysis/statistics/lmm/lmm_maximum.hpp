#pragma once
/// \file
/// The factors of a linear mixed model at its largest likelihood. Internal to the estimator.

#include <statistics/glmm/glmm_maximum.hpp>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/lmm/lmm_likelihood.hpp>
#include <vector>

namespace tcert::statistics {

/// Diagonals of the factors are at least 0, and exactly 0 where the likelihood is highest there.
[[nodiscard]] GlmmMaximum lmm_maximum(LmmLikelihood& likelihood,
                                      const std::vector<TermRows>& terms);

/// Likewise without the last effect of a term, begun at the maximum of the whole.
[[nodiscard]] GlmmMaximum lmm_maximum_without(LmmLikelihood& likelihood,
                                              const std::vector<TermRows>& terms,
                                              std::size_t term,
                                              const Eigen::VectorXd& whole);

}  // namespace tcert::statistics
