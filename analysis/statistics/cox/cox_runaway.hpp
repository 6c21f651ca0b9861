#pragma once
/// \file
/// Hazard ratios that are finite, but only because a few rows are out of order by a hair.

#include <Eigen/Core>
#include <statistics/cox/cox_newton.hpp>
#include <statistics/cox/cox_rows.hpp>
#include <vector>

namespace tcert::statistics {

/// Per column whether its estimate has run away (`has_run_away`): the curvature along it is held
/// against that without effect, over the number of events. `inverse` is that of the information at
/// the estimate, of the scaled columns; columns that it does not know (NaN) have not. O(n p + p^3).
[[nodiscard]] std::vector<bool> cox_runaways(const CoxData& data,
                                             const CoxRows& rows,
                                             const CoxMaximum& maximum,
                                             const Eigen::MatrixXd& inverse,
                                             std::size_t events);

}  // namespace tcert::statistics
