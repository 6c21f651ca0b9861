#include <statistics/model/pairwise.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/holm.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>

namespace tcert::statistics {
namespace {

/// Half as wide an interval, in standard errors.
double width_factor(const CoefficientSum& sum, double level) {
  return sum.df ? t_factor(level, *sum.df) : normal_factor(level);
}

void add_test(double level, PairContrast& pair) {
  if (!pair.estimate || !pair.standard_error || !(*pair.standard_error > 0.0)) {
    return;
  }
  const double half = width_factor(pair, level) * *pair.standard_error;
  pair.statistic = *pair.estimate / *pair.standard_error;
  pair.p_value = pair.df ? t_p_value(*pair.statistic, *pair.df, Alternative::two_sided)
                         : normal_p_value(*pair.statistic, Alternative::two_sided);
  pair.interval = Interval{*pair.estimate - half, *pair.estimate + half, level};
}

void add_family(double level, std::vector<PairContrast>& pairs) {
  std::vector<std::optional<double>> p;
  for (const PairContrast& pair : pairs) {
    p.push_back(pair.p_value);
  }
  const std::vector<std::optional<double>> adjusted = holm(p);
  const auto family = static_cast<double>(
      std::count_if(p.begin(), p.end(), [](const auto& one) { return one.has_value(); }));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    PairContrast& pair = pairs[k];
    pair.holm = adjusted[k];
    if (pair.interval) {
      const double half = width_factor(pair, 1.0 - (1.0 - level) / family) * *pair.standard_error;
      pair.simultaneous = Interval{*pair.estimate - half, *pair.estimate + half, level};
    }
  }
}

}  // namespace

std::vector<CoefficientSum> sums_by_covariance(std::span<const std::optional<double>> coefficients,
                                               const Eigen::MatrixXd& covariance,
                                               std::optional<double> df,
                                               const Eigen::MatrixXd& weights) {
  std::vector<CoefficientSum> sums;
  for (Eigen::Index row = 0; row < weights.rows(); ++row) {
    std::vector<Eigen::Index> places;
    CoefficientSum sum;
    sum.estimate = 0.0;
    for (Eigen::Index j = 0; j < weights.cols(); ++j) {
      if (weights(row, j) == 0.0) {
        continue;
      }
      const std::optional<double>& one = coefficients[static_cast<std::size_t>(j)];
      sum.estimate = sum.estimate && one ? std::optional(*sum.estimate + weights(row, j) * *one)
                                         : std::nullopt;
      places.push_back(j);
    }
    if (sum.estimate && covariance.size() > 0) {
      const Eigen::VectorXd own = weights.row(row)(places).transpose();
      const double variance = own.dot(covariance(places, places) * own);
      if (std::isfinite(variance)) {
        sum.standard_error = std::sqrt(std::max(0.0, variance));
        sum.df = df;
      }
    }
    sums.push_back(sum);
  }
  return sums;
}

std::vector<PairContrast> pairwise_contrasts(const LevelMeans& means,
                                             const CoefficientSums& sums,
                                             double level) {
  std::vector<PairContrast> pairs;
  const auto count = static_cast<Eigen::Index>(means.levels.size());
  Eigen::MatrixXd weights(count * (count - 1) / 2, means.design.cols());
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) {
      weights.row(static_cast<Eigen::Index>(pairs.size())) =
          means.design.row(a) - means.design.row(b);
      PairContrast pair;
      pair.first = means.levels[static_cast<std::size_t>(a)];
      pair.second = means.levels[static_cast<std::size_t>(b)];
      pairs.push_back(std::move(pair));
    }
  }
  const std::vector<CoefficientSum> found = sums(weights);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    static_cast<CoefficientSum&>(pairs[k]) = found[k];
    add_test(level, pairs[k]);
  }
  add_family(level, pairs);
  return pairs;
}

}  // namespace tcert::statistics
