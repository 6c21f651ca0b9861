#pragma once
/// \file
/// Estimates that are finite, but only because a few rows overlap by a hair: they have run away,
/// and neither they nor their odds ratios say anything.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "analysis/logistic/logistic.hpp"
#include "analysis/logistic/logistic_problem.hpp"

namespace tcert {

/// A spread that neither an outlier nor a rare level moves: the interquartile range over 1.349 (the
/// standard deviation of a normal sample); where that is 0, the median distance from the median of
/// the values that differ from it, which is 1 for a dummy. 0 for a constant.
[[nodiscard]] double typical_spread(std::vector<double> values);

/// Kept coefficients of a solved problem, in units in which no number is extreme.
struct KeptEstimates {
  const Eigen::MatrixXd& back;       ///< Row k: what coefficient k is of those along the basis.
  const Eigen::VectorXd& estimates;  ///< back * those along the basis.
  const Eigen::VectorXd& variances;  ///< By the model, never the robust ones.
  const Eigen::VectorXd& units;      ///< Of each row in its column's own units.
};

/// Per kept column whether its estimate has run away, in a fit with a probability within 1e-6 of 0
/// or 1 (`largest_eta` above kSuspiciousEta; else none has). With s the column's typical spread:
///   - the log odds ratio per s is above 34, so that one spread takes an even chance to a
///     probability that is numerically 0 or 1 (the bound of R's warning in `glm`); or
///   - its standard error per s is above 10, an interval of 17 powers of ten, and the curvature
///     along it is less than that of a single trial at even odds, averaged over all trials. So a
///     collinear or badly scaled column, whose curvature is small at any probability, is not meant.
/// The intercept, which has no spread, follows if another has run away and its own standard error
/// or estimate passes the same bounds. `names[k]` is the input's column of the problem's column k.
[[nodiscard]] std::vector<bool> ran_away(const LogisticInput& input,
                                         const LogisticProblem& problem,
                                         const std::vector<std::size_t>& names,
                                         const KeptEstimates& kept,
                                         double largest_eta);

}  // namespace tcert
