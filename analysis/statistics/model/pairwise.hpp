#pragma once
/// \file
/// All pairs of a factor's levels compared. Checked against `emmeans` with `adjust = "holm"`.

#include <functional>
#include <optional>
#include <span>
#include <statistics/basics/interval.hpp>
#include <statistics/model/level_means.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// A sum of coefficients. By the normal distribution without df.
struct CoefficientSum {
  std::optional<double> estimate;
  std::optional<double> standard_error;
  std::optional<double> df;
};

/// Each row of the weights (k x coefficients) as a sum.
using CoefficientSums = std::function<std::vector<CoefficientSum>(const Eigen::MatrixXd& weights)>;

/// By a covariance of the coefficients and, if given, Student's t. Empty where a coefficient that
/// counts has no estimate or no variance.
[[nodiscard]] std::vector<CoefficientSum> sums_by_covariance(
    std::span<const std::optional<double>> coefficients,
    const Eigen::MatrixXd& covariance,
    std::optional<double> df,
    const Eigen::MatrixXd& weights);

struct PairContrast : CoefficientSum {
  std::string first, second;  ///< The first level less the second.
  std::optional<double> statistic;
  std::optional<double> p_value;
  std::optional<double> holm;            ///< Of all pairs.
  std::optional<Interval> interval;      ///< Of this pair alone.
  std::optional<Interval> simultaneous;  ///< Bonferroni's, of all pairs that have an estimate.
};

/// In the order of the levels: 1 less 2, 1 less 3, ..., 2 less 3. \pre 0 < level < 1.
[[nodiscard]] std::vector<PairContrast> pairwise_contrasts(const LevelMeans& means,
                                                           const CoefficientSums& sums,
                                                           double level);

}  // namespace tcert::statistics
