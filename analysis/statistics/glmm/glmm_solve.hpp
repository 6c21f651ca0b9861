#pragma once
/// \file
/// From a problem to its maximum: where to start, and estimates on the boundary. Internal to the
/// estimator.

#include <statistics/glmm/glmm_maximum.hpp>
#include <statistics/glmm/glmm_problem.hpp>
#include <vector>

namespace tcert::statistics {

/// The maximum by `quadrature` points. Diagonals of the factors are at least 0, and exactly 0 where
/// the likelihood is highest there. The search goes by Laplace's approximation, which costs least,
/// and Newton's method ends it.
[[nodiscard]] GlmmMaximum solve(const GlmmProblem& problem,
                                int quadrature,
                                const GlmmOptions& options);

/// Places of the diagonals of all factors among the parameters.
[[nodiscard]] std::vector<Eigen::Index> diagonal_places(const GlmmProblem& problem);

}  // namespace tcert::statistics
