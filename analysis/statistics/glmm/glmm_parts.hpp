#pragma once
/// \file
/// What a mixed model says, each part from the maximum. Internal to glmm.cpp.

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_maximum.hpp>
#include <statistics/glmm/glmm_problem.hpp>

namespace tcert::statistics {

void add_fixed_effects(const GlmmInput& input,
                       const GlmmProblem& problem,
                       const GlmmMaximum& maximum,
                       GlmmFit& fit);

void add_random_effects(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit);

/// The shares of variance. \pre add_random_effects() was there.
void add_explained(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit);

/// Fits the model anew without the last effect of each term. \pre as above, and the log-likelihood.
void add_boundary_tests(const GlmmInput& input, GlmmFit& fit);

/// \pre as above.
void add_singular_conditions(GlmmFit& fit);

}  // namespace tcert::statistics
