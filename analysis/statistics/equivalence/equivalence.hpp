#pragma once
/// \file
/// Are k groups equal enough? "Not significantly different" is no answer: two one-sided tests of
/// all pairs against a margin (Schuirmann 1987), and beside them the test that they are all equal.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// Estimates of the same quantity in k groups, with their joint covariance.
struct GroupEstimates {
  std::vector<std::string> names;
  Eigen::VectorXd values;      ///< k.
  Eigen::MatrixXd covariance;  ///< k x k, of the estimates.
  std::size_t clusters = 0;    ///< That the covariance is made of; 0: as if of ever more.
};

struct EquivalenceOptions {
  double margin = 0.05;  ///< Differences of less than this do not matter.
  double alpha = 0.05;   ///< Of each one-sided test: the interval has level 1 - 2 alpha.
  double power = 0.80;   ///< Of `margin_with_power`.
};

/// First group less second.
struct EquivalencePair {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;
  double standard_error = 0.0;
  Interval interval;             ///< difference -+ SE times the quantile of 1 - alpha.
  double p_value = 1.0;          ///< Of two one-sided tests: the larger.
  bool equivalent = false;       ///< The interval lies within (-margin, margin): p < alpha.
  double smallest_margin = 0.0;  ///< At which it would just be: the interval's farther end.
};

struct Equivalence {
  std::vector<EquivalencePair> pairs;  ///< Every (i, j), i < j.
  /// Intersection-union: equivalent if every pair is, at alpha without correction (Berger 1982).
  std::optional<bool> equivalent;
  std::optional<double> p_value;          ///< The largest of the pairs.
  std::optional<double> smallest_margin;  ///< The largest of the pairs.
  std::optional<double> margin_with_power;
  std::optional<double> range;                 ///< Largest less smallest estimate.
  std::optional<ChiSquareTest> heterogeneity;  ///< Wald's, all equal, on k - 1 df.
  EquivalenceOptions options;
  Conditions conditions;  ///< one_group, singular_covariance.
};

/// By Student's t with clusters - 1 degrees of freedom and Hotelling's T^2, by the normal and
/// chi-squared distributions without clusters. Numbers are empty for fewer than two groups; a pair
/// without variance is an error of the caller. \throws std::invalid_argument if sizes differ, an
/// entry is not finite, or margin, alpha (0, 0.5) or power (0, 1) is out of range. O(k^3).
[[nodiscard]] Equivalence equivalence(const GroupEstimates& groups,
                                      const EquivalenceOptions& options = {});

/// Wald's test that all k are equal: (L t)' (L V L')^-1 (L t) with any k - 1 contrasts L. Empty if
/// L V L' cannot be inverted, as with fewer clusters than groups.
[[nodiscard]] std::optional<ChiSquareTest> equality_test(const GroupEstimates& groups);

/// The margin at which all pairs would be found equivalent with probability `power` at least, if
/// all groups were truly equal: the largest over pairs of SE (q_(1 - alpha) + q_(1 - b / 2)), b =
/// (1 - power) / pairs. For one pair it takes the SE as known; for more the probabilities to
/// miss are added (Bonferroni), so the power is a little more.
[[nodiscard]] double margin_with_power(const std::vector<EquivalencePair>& pairs,
                                       double alpha,
                                       double power,
                                       std::size_t clusters = 0);

/// Probability that one pair is found equivalent: difference `truth`, standard error `error`.
[[nodiscard]] double equivalence_power(double truth, double error, double margin, double alpha);

/// Is a loss below a margin? The one-sided tests of a difference and of a proportion.
struct NonInferiority {
  double upper = 0.0;            ///< One-sided upper bound of the loss at 1 - alpha.
  bool non_inferior = false;     ///< upper < margin.
  double smallest_margin = 0.0;  ///< What would just be accepted: the bound.
  double p_value = 1.0;          ///< Of loss >= margin.
};

/// By the normal distribution. \throws std::invalid_argument if the error is not above 0, or alpha
/// not in (0, 0.5).
[[nodiscard]] NonInferiority non_inferiority(double loss,
                                             double standard_error,
                                             double margin,
                                             double alpha = 0.05);

/// `lost` of `trials` successes: Clopper and Pearson's bound, and the exact binomial p. Empty
/// without trials. \throws std::invalid_argument as `clopper_pearson_upper`, or if the margin is
/// not in (0, 1).
[[nodiscard]] std::optional<NonInferiority> non_inferiority(std::size_t lost,
                                                            std::size_t trials,
                                                            double margin,
                                                            double alpha = 0.05);

}  // namespace tcert::statistics
