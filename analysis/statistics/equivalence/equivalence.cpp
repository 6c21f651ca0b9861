#include <statistics/equivalence/equivalence.hpp>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/basics/wald_chi_squared.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check_alpha(double alpha) {
  if (!(alpha > 0.0 && alpha < 0.5)) {
    throw std::invalid_argument("equivalence: alpha must be in (0, 0.5)");
  }
}

void check(const GroupEstimates& groups, const EquivalenceOptions& options) {
  const Eigen::Index k = groups.values.size();
  if (groups.covariance.rows() != k || groups.covariance.cols() != k ||
      groups.names.size() != static_cast<std::size_t>(k) || groups.clusters == 1) {
    throw std::invalid_argument("equivalence: sizes differ");
  }
  if (!groups.values.allFinite() || !groups.covariance.allFinite()) {
    throw std::invalid_argument("equivalence: an estimate or a covariance is not finite");
  }
  check_alpha(options.alpha);
  if (!(options.margin > 0.0) || !(options.power > 0.0 && options.power < 1.0)) {
    throw std::invalid_argument("equivalence: margin must be above 0, power in (0, 1)");
  }
}

/// Of Student's t with clusters - 1 degrees of freedom; normal without clusters.
double quantile_of(double p, std::size_t clusters) {
  return clusters == 0 ? normal_quantile(p)
                       : t_factor(2.0 * p - 1.0, static_cast<double>(clusters) - 1.0);
}

double lower_tail(double z, std::size_t clusters) {
  return clusters == 0 ? normal_cdf(z)
                       : t_p_value(z, static_cast<double>(clusters) - 1.0, Alternative::less);
}

EquivalencePair pair_of(const GroupEstimates& groups,
                        Eigen::Index first,
                        Eigen::Index second,
                        const EquivalenceOptions& options) {
  EquivalencePair pair;
  pair.first = static_cast<std::size_t>(first);
  pair.second = static_cast<std::size_t>(second);
  pair.difference = groups.values[first] - groups.values[second];
  const double variance = groups.covariance(first, first) + groups.covariance(second, second) -
                          2.0 * groups.covariance(first, second);
  pair.standard_error = std::sqrt(std::max(0.0, variance));
  const double half = quantile_of(1.0 - options.alpha, groups.clusters) * pair.standard_error;
  pair.interval = {pair.difference - half, pair.difference + half, 1.0 - 2.0 * options.alpha};
  pair.smallest_margin = std::abs(pair.difference) + half;
  pair.equivalent = pair.smallest_margin < options.margin;
  const double room = options.margin - std::abs(pair.difference);
  pair.p_value = pair.standard_error > 0.0
                     ? lower_tail(-room / pair.standard_error, groups.clusters)
                     : (room > 0.0 ? 0.0 : 1.0);
  return pair;
}

}  // namespace

std::optional<ChiSquareTest> equality_test(const GroupEstimates& groups) {
  const Eigen::Index k = groups.values.size();
  if (k < 2) {
    return std::nullopt;
  }
  // Each group less the last one.
  Eigen::MatrixXd contrasts = Eigen::MatrixXd::Zero(k - 1, k);
  contrasts.leftCols(k - 1).setIdentity();
  contrasts.col(k - 1).setConstant(-1.0);
  const Eigen::VectorXd differences = contrasts * groups.values;
  const Eigen::MatrixXd covariance = contrasts * groups.covariance * contrasts.transpose();
  return groups.clusters == 0 ? wald_test(differences, covariance)
                              : hotelling_test(differences, covariance, groups.clusters);
}

double margin_with_power(const std::vector<EquivalencePair>& pairs,
                         double alpha,
                         double power,
                         std::size_t clusters) {
  double widest = 0.0;
  for (const EquivalencePair& pair : pairs) {
    widest = std::max(widest, pair.standard_error);
  }
  const double miss = (1.0 - power) / static_cast<double>(std::max<std::size_t>(1, pairs.size()));
  return widest * (quantile_of(1.0 - alpha, clusters) + quantile_of(1.0 - 0.5 * miss, clusters));
}

double equivalence_power(double truth, double error, double margin, double alpha) {
  const double reach = margin - normal_quantile(1.0 - alpha) * error;
  if (!(reach > 0.0)) {
    return 0.0;
  }
  return normal_cdf((reach - truth) / error) - normal_cdf((-reach - truth) / error);
}

Equivalence equivalence(const GroupEstimates& groups, const EquivalenceOptions& options) {
  check(groups, options);
  Equivalence result;
  result.options = options;
  const Eigen::Index k = groups.values.size();
  if (k < 2) {
    result.conditions.push_back({ConditionKind::one_group, ConditionSeverity::error, "", ""});
    return result;
  }
  result.equivalent = true;
  result.p_value = 0.0;
  result.smallest_margin = 0.0;
  for (Eigen::Index i = 0; i < k; ++i) {
    for (Eigen::Index j = i + 1; j < k; ++j) {
      const EquivalencePair pair = pair_of(groups, i, j, options);
      result.equivalent = *result.equivalent && pair.equivalent;
      result.p_value = std::max(*result.p_value, pair.p_value);
      result.smallest_margin = std::max(*result.smallest_margin, pair.smallest_margin);
      result.pairs.push_back(pair);
    }
  }
  result.margin_with_power =
      margin_with_power(result.pairs, options.alpha, options.power, groups.clusters);
  result.range = groups.values.maxCoeff() - groups.values.minCoeff();
  result.heterogeneity = equality_test(groups);
  if (!result.heterogeneity) {
    result.conditions.push_back(
        {ConditionKind::singular_covariance, ConditionSeverity::warning, "", ""});
  }
  return result;
}

NonInferiority non_inferiority(double loss, double standard_error, double margin, double alpha) {
  check_alpha(alpha);
  if (!(standard_error > 0.0)) {
    throw std::invalid_argument("non-inferiority: the standard error must be above 0");
  }
  NonInferiority result;
  result.upper = loss + normal_quantile(1.0 - alpha) * standard_error;
  result.non_inferior = result.upper < margin;
  result.smallest_margin = result.upper;
  result.p_value = normal_cdf((loss - margin) / standard_error);
  return result;
}

std::optional<NonInferiority> non_inferiority(std::size_t lost,
                                              std::size_t trials,
                                              double margin,
                                              double alpha) {
  check_alpha(alpha);
  if (!(margin > 0.0 && margin < 1.0)) {
    throw std::invalid_argument("non-inferiority: the margin of a proportion is in (0, 1)");
  }
  const std::optional<double> upper = clopper_pearson_upper(lost, trials, 1.0 - alpha);
  if (!upper) {
    return std::nullopt;
  }
  NonInferiority result;
  result.upper = *upper;
  result.non_inferior = result.upper < margin;
  result.smallest_margin = result.upper;
  // Pr(at most so many lost | a share of `margin` is): the bound's own test.
  result.p_value = lost == trials ? 1.0
                                  : boost::math::ibetac(static_cast<double>(lost) + 1.0,
                                                        static_cast<double>(trials - lost),
                                                        margin);
  return result;
}

}  // namespace tcert::statistics
