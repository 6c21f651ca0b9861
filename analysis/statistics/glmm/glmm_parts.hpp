#pragma once
/// \file
/// What a mixed model says, each part from the maximum. Internal to the mixed
/// models.

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_maximum.hpp>
#include <statistics/glmm/glmm_problem.hpp>

namespace tcert::statistics {

void add_fixed_effects(const GlmmInput& input,
                       const GlmmProblem& problem,
                       const GlmmMaximum& maximum,
                       GlmmFit& fit);

/// The term's deviations and correlations by the elements of its factor; without modes.
[[nodiscard]] GlmmRandomTerm random_term(const TermRows& rows,
                                         const Eigen::Ref<const Eigen::VectorXd>& thetas);

/// Mean over rows of z' Sigma z.
[[nodiscard]] double mean_variance(const TermRows& rows, const GlmmRandomTerm& term);

void add_random_effects(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit);

/// The shares of variance. \pre add_random_effects() was there.
void add_explained(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit);

/// Fits the model anew without the last effect of each term. \pre as above, and the log-likelihood.
void add_boundary_tests(const GlmmInput& input, GlmmFit& fit);

/// Of the term's last effect, whose absence costs `drop` of twice the log-likelihood.
[[nodiscard]] BoundaryTest boundary_test(const GlmmRandomTerm& term,
                                         double drop,
                                         double log_likelihood);

/// singular_fit, a note a term that is. \pre the tests were there.
void add_singular_conditions(const std::vector<GlmmRandomTerm>& random, Conditions& conditions);

}  // namespace tcert::statistics
