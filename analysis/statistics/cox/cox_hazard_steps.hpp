#pragma once
/// \file
/// The baseline hazard's steps, with what residuals and variances need of each event time.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <statistics/cox/cox_rows.hpp>
#include <vector>

namespace tcert::statistics {

/// T event times, p scaled columns (matrices are T x p, row-major, so that a time is contiguous).
/// Cumulative sums start anew in every stratum. Of tied events under Efron's rule each sees its own
/// hazard reduced: `event_*` is the time's own step for a row that has its event then.
struct HazardSteps {
  std::vector<double> hazard;  ///< Cumulative, of a row with risk score 1.
  std::vector<double>
      hazard_variance;  ///< Cumulative: the part without the coefficients' variance.
  std::vector<double> event_hazard;
  std::vector<double> mean;         ///< Of x over the risk set, averaged over the tied events.
  std::vector<double> mean_hazard;  ///< Cumulative integral of the mean by the hazard.
  std::vector<double> event_mean_hazard;
  std::vector<double> none;  ///< Zeros: a sum over no event time.
  RiskScores risks;          ///< Scores of the rows; `hazard` belongs to scores with their shift.
};

/// The same with the step of each time alone where `hazard_steps` has cumulative sums.
[[nodiscard]] HazardSteps hazard_increments(const CoxRows& rows,
                                            const Eigen::VectorXd& beta,
                                            Ties ties);

/// With exact ties the steps are Breslow's, as in R. O(m p).
[[nodiscard]] HazardSteps hazard_steps(const CoxRows& rows, const Eigen::VectorXd& beta, Ties ties);

/// The cumulative hazard that the row at `place` has been under, of risk score 1.
[[nodiscard]] double hazard_of_row(const CoxRows& rows,
                                   const HazardSteps& steps,
                                   std::size_t place) noexcept;

using ScoreResidualVisit = std::function<void(std::size_t place, double* residual)>;

/// Calls `visit` with every row's score residual, unweighted, in scaled columns (p numbers, which it
/// may change), upwards in places. Rows of one time share what they were exposed to. O(m p).
void for_each_score_residual(const CoxRows& rows,
                             const HazardSteps& steps,
                             const ScoreResidualVisit& visit);

}  // namespace tcert::statistics
