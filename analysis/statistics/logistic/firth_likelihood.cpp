#include <statistics/logistic/firth_likelihood.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {
namespace {

/// Derivatives of a row's weight by its linear predictor.
struct Weight {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
  double half_less_mean = 0.0;  ///< 1/2 - mu, without cancellation near 1/2.
};

Weight weight_of(double eta, double trials) {
  const double e = std::exp(-std::abs(eta));
  const double spread = e / ((1.0 + e) * (1.0 + e));                                 // mu (1 - mu)
  const double tilt = std::copysign(-std::expm1(-std::abs(eta)) / (1.0 + e), -eta);  // 1 - 2 mu
  const double value = trials * spread;
  return {value, value * tilt, value * (1.0 - 6.0 * spread), 0.5 * tilt};
}

/// Adds the penalty's part of gradient and curvature.
void add_penalty(const Eigen::MatrixXd& design,
                 const BinomialRows& rows,
                 const Eigen::VectorXd& coefficients,
                 const Cholesky& cholesky,
                 FirthLikelihood& result) {
  const Eigen::Index columns = design.cols();
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(columns * columns, columns);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd eta = Eigen::VectorXd::Zero(kRowsAtOnce);
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(kRowsAtOnce);
  Eigen::VectorXd by_second = Eigen::VectorXd::Zero(kRowsAtOnce);
  Eigen::VectorXd by_first = Eigen::VectorXd::Zero(kRowsAtOnce);
  for (Eigen::Index first = 0; first < design.rows(); first += kRowsAtOnce) {
    const Eigen::Index size = std::min(kRowsAtOnce, design.rows() - first);
    const auto block = design.middleRows(first, size);
    eta.head(size).noalias() = block * coefficients;
    if (rows.offset.size() > 0) {
      eta.head(size) += rows.offset.segment(first, size);
    }
    // Rows z_i = L^-1 x_i, so that q_i = |z_i|^2.
    const Eigen::MatrixXd whitened =
        cholesky.whiten(Eigen::MatrixXd(block.transpose())).transpose();
    for (Eigen::Index i = 0; i < size; ++i) {
      const Weight weight = weight_of(eta[i], rows.trials[first + i]);
      const double q = whitened.row(i).squaredNorm();
      correction[i] = weight.value * q * weight.half_less_mean;
      by_second[i] = weight.second * q;
      by_first[i] = weight.first;
    }
    second.noalias() += block.transpose() * by_second.head(size).asDiagonal() * block;
    for (Eigen::Index r = 0; r < columns; ++r) {
      result.gradient[r] += block.col(r).dot(correction.head(size));
      const Eigen::VectorXd scale = by_first.head(size).cwiseProduct(block.col(r));
      const Eigen::MatrixXd part = whitened.transpose() * scale.asDiagonal() * whitened;
      products.col(r) += part.reshaped();
    }
  }
  result.curvature = result.information - 0.5 * second + 0.5 * products.transpose() * products;
}

}  // namespace

FirthLikelihood firth_likelihood(const Eigen::MatrixXd& design,
                                 const BinomialRows& rows,
                                 const Eigen::VectorXd& coefficients) {
  const BinomialLikelihood plain = binomial_likelihood(design, rows, coefficients);
  FirthLikelihood result;
  result.log_likelihood = plain.log_likelihood;
  result.gradient = plain.gradient;
  result.information = plain.information;
  result.curvature = plain.information;
  const Cholesky cholesky(plain.information);
  const Eigen::VectorXd pivots = cholesky.pivots();
  const bool invertible = cholesky.succeeded() && (pivots.array() > 0.0).all();
  if (!invertible || !std::isfinite(plain.log_likelihood)) {
    result.value = -std::numeric_limits<double>::infinity();
    return result;
  }
  result.value = plain.log_likelihood + pivots.array().log().sum();
  add_penalty(design, rows, coefficients, cholesky, result);
  return result;
}

}  // namespace tcert::statistics
