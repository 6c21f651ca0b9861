#pragma once
/// \file
/// Logistic estimates that are finite, but only because a few rows overlap by a hair.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <vector>

namespace tcert::statistics {

/// Kept coefficients of a solved problem, in units in which no number is extreme.
struct KeptEstimates {
  const Eigen::MatrixXd& back;       ///< Row k: what coefficient k is of those along the basis.
  const Eigen::VectorXd& estimates;  ///< back * those along the basis.
  const Eigen::VectorXd& variances;  ///< By the model, never the robust ones.
  const Eigen::VectorXd& units;      ///< Of each row in its column's own units.
};

/// Per kept column whether its estimate has run away (`has_run_away`), in a fit with a probability
/// within 1e-6 of 0 or 1 (`largest_eta` above kSuspiciousEta; else none has). The curvature is held
/// against that of all trials at even odds, over their number. The intercept, which has no spread,
/// follows if another column has run away and it passes the bounds itself. `names[k]` is the
/// input's column of the problem's column k. O(rows columns^2).
[[nodiscard]] std::vector<bool> ran_away(const LogisticInput& input,
                                         const LogisticProblem& problem,
                                         const std::vector<std::size_t>& names,
                                         const KeptEstimates& kept,
                                         double largest_eta);

}  // namespace tcert::statistics
