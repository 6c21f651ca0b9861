#pragma once
/// \file
/// Conditional modes of random effects on the scale of the data, and their deviations.

#include <Eigen/Core>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <statistics/glmm/sparse_curvature.hpp>
#include <vector>

namespace tcert::statistics {

/// Of standardised effects `u`, term by term and level by level, with the inverse of their
/// curvature and the terms' factors, times `sigma` the deviations. NaN without a curvature.
[[nodiscard]] std::vector<TermModes> term_modes(const std::vector<TermRows>& terms,
                                                const std::vector<Eigen::MatrixXd>& factors,
                                                const SparseCurvature* inverted,
                                                const Eigen::VectorXd& u,
                                                double sigma);

}  // namespace tcert::statistics
