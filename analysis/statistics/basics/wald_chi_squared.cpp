#include <statistics/basics/wald_chi_squared.hpp>

#include <boost/math/distributions/fisher_f.hpp>
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

std::optional<ChiSquareTest> hotelling_test(const Eigen::VectorXd& estimates,
                                            const Eigen::MatrixXd& covariance,
                                            std::size_t clusters) {
  std::optional<ChiSquareTest> test = wald_test(estimates, covariance);
  if (!test || clusters <= test->df) {
    return std::nullopt;
  }
  const auto k = static_cast<double>(test->df);
  const auto groups = static_cast<double>(clusters);
  test->p_value = boost::math::cdf(boost::math::complement(
      boost::math::fisher_f(k, groups - k), test->statistic * (groups - k) / (k * (groups - 1.0))));
  return test;
}

}  // namespace tcert::statistics
