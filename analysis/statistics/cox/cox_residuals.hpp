#pragma once
/// \file
/// Residuals of a Cox model, as R's `residuals.coxph` defines them.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/cox/cox.hpp>
#include <vector>

namespace tcert::statistics {

/// n rows in the data's order, p columns, D events. Columns whose coefficient is NA hold NaN where
/// the residual is one of the coefficient. If a coefficient runs to infinity, all are those of the
/// limit.
struct CoxResiduals {
  Eigen::VectorXd martingale;  ///< n: event minus the cumulative hazard that the row was under.
  Eigen::VectorXd deviance;    ///< n.

  // The rest is empty with exact ties, for which it is not defined.
  Eigen::MatrixXd score;    ///< n x p, not weighted.
  Eigen::MatrixXd dfbeta;   ///< n x p: about the change of beta by the row, weighted.
  Eigen::MatrixXd dfbetas;  ///< n x p: in model standard errors.

  std::vector<std::size_t> event_rows;  ///< D, by stratum, time, row.
  Eigen::MatrixXd schoenfeld;           ///< D x p: x minus its mean over the risk set.
  Eigen::MatrixXd scaled_schoenfeld;    ///< D x p: about beta(t); by the model variance.
};

/// \pre `fit` is the fit to `data`, with inference, without an error. O(n (log n + p^2)).
/// \throws std::invalid_argument if the fit has no model variance.
[[nodiscard]] CoxResiduals cox_residuals(const CoxData& data, const CoxFit& fit);

}  // namespace tcert::statistics
