#include <statistics/basics/wald_chi_squared.hpp>

#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {

std::optional<ChiSquareTest> wald_test(const Eigen::VectorXd& estimates,
                                       const Eigen::MatrixXd& covariance) {
  if (estimates.size() == 0 || !estimates.allFinite() || !covariance.allFinite()) {
    return std::nullopt;
  }
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0.0)) {
    return std::nullopt;
  }
  const Eigen::VectorXd inverse = scale.cwiseInverse();
  const Cholesky cholesky(inverse.asDiagonal() * covariance * inverse.asDiagonal());
  // A pivot of a correlation matrix this small is rounding.
  constexpr double kSmallestPivot = 1e-6;
  if (!cholesky.succeeded() || cholesky.pivots().minCoeff() < kSmallestPivot) {
    return std::nullopt;
  }
  const Eigen::VectorXd z = cholesky.whiten(inverse.cwiseProduct(estimates).eval());
  return chi_square_test(z.squaredNorm(), static_cast<std::size_t>(estimates.size()));
}

}  // namespace tcert::statistics
