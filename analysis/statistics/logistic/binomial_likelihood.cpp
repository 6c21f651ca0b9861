#include <statistics/logistic/binomial_likelihood.hpp>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

namespace tcert::statistics {
namespace {

double x_log_x(double x) { return x > 0.0 ? x * std::log(x) : 0.0; }

}  // namespace

BinomialLikelihood binomial_likelihood(const Eigen::MatrixXd& design,
                                       const BinomialRows& rows,
                                       const Eigen::VectorXd& coefficients) {
  const Eigen::Index columns = design.cols();
  BinomialLikelihood result;
  result.gradient = Eigen::VectorXd::Zero(columns);
  result.information = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd eta(kRowsAtOnce);
  Eigen::VectorXd residual(kRowsAtOnce);
  Eigen::VectorXd weight(kRowsAtOnce);
  Eigen::MatrixXd weighted(kRowsAtOnce, columns);
  for (Eigen::Index first = 0; first < design.rows(); first += kRowsAtOnce) {
    const Eigen::Index size = std::min(kRowsAtOnce, design.rows() - first);
    const auto block = design.middleRows(first, size);
    eta.head(size).noalias() = block * coefficients;
    if (rows.offset.size() > 0) {
      eta.head(size) += rows.offset.segment(first, size);
    }
    double loss = 0.0;
    for (Eigen::Index i = 0; i < size; ++i) {
      const double trials = rows.trials[first + i];
      const double successes = rows.successes[first + i];
      const double failures = trials - successes;
      const double distance = std::abs(eta[i]);
      const double e = std::exp(-distance);
      const double near = 1.0 / (1.0 + e);
      const double far = e * near;
      const bool up = eta[i] >= 0.0;
      // Written so that nothing cancels when a probability is near 0 or 1.
      loss += trials * std::log1p(e) + (up ? failures : successes) * distance;
      residual[i] = up ? successes * far - failures * near : successes * near - failures * far;
      weight[i] = trials * near * far;
      if (trials > 0.0) {
        result.largest_eta = std::max(result.largest_eta, distance);
      }
    }
    result.log_likelihood -= loss;
    result.gradient.noalias() += block.transpose() * residual.head(size);
    weighted.topRows(size) = weight.head(size).asDiagonal() * block;
    result.information.noalias() += block.transpose() * weighted.topRows(size);
  }
  return result;
}

double inverse_logit(double eta) noexcept {
  const double e = std::exp(-std::abs(eta));
  return eta >= 0.0 ? 1.0 / (1.0 + e) : e / (1.0 + e);
}

double log_binomial_coefficients(const Eigen::VectorXd& successes,
                                 const Eigen::VectorXd& trials,
                                 const Eigen::VectorXd& weights) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < trials.size(); ++i) {
    if (successes[i] <= 0.0 || successes[i] >= trials[i]) {
      continue;
    }
    // boost's lgamma, not the C library's, which writes the sign to a global.
    const double coefficient = boost::math::lgamma(trials[i] + 1.0) -
                               boost::math::lgamma(successes[i] + 1.0) -
                               boost::math::lgamma(trials[i] - successes[i] + 1.0);
    sum += (weights.size() > 0 ? weights[i] : 1.0) * coefficient;
  }
  return sum;
}

double saturated_log_likelihood(const BinomialRows& rows) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < rows.trials.size(); ++i) {
    sum += x_log_x(rows.successes[i]) + x_log_x(rows.trials[i] - rows.successes[i]) -
           x_log_x(rows.trials[i]);
  }
  return sum;
}

}  // namespace tcert::statistics
