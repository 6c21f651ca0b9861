#pragma once
/// \file
/// What estimated variances cost: Satterthwaite's degrees of freedom. Internal to the estimator.

#include <statistics/lmm/lmm.hpp>
#include <statistics/lmm/lmm_likelihood.hpp>

namespace tcert::statistics {

/// Sets the covariance of the kept coefficients (`back` takes those along the basis to them), its
/// slopes and the covariance of the elements of the factors and of the residual's deviation, by the
/// Hessian of the deviance there. \pre `thetas` is the maximum.
void add_spread(LmmLikelihood& likelihood,
                const Eigen::VectorXd& thetas,
                const Eigen::MatrixXd& back,
                const std::vector<std::size_t>& kept,
                LmmFit& fit);

}  // namespace tcert::statistics
