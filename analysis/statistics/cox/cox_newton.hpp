#pragma once
/// \file
/// The maximum of the partial likelihood, the columns that have one, and those that run away.

#include <Eigen/Core>
#include <cstdint>
#include <statistics/cox/cox_likelihood.hpp>
#include <statistics/cox/cox_rows.hpp>
#include <vector>

namespace tcert::statistics {

enum class ColumnState : std::uint8_t {
  estimated,
  constant,   ///< In every risk set.
  collinear,  ///< The columns before it determine it.
  infinite,   ///< The likelihood rises without end along it.
};

/// In units of the scaled columns.
struct CoxMaximum {
  Eigen::VectorXd beta;
  CoxDerivatives null;    ///< At beta = 0.
  CoxDerivatives fitted;  ///< At `beta`.
  std::vector<ColumnState> columns;
  Eigen::VectorXd recession;  ///< A direction in which the likelihood rises; empty without one.
  bool at_limit = true;       ///< False: rounding has stopped the fit before its limit.
  CoxSummary summary;
};

/// \pre some event. Information that a column adds to those before it is compared with what it has
/// alone, at beta = 0, to find constant and collinear ones.
[[nodiscard]] CoxMaximum maximise(const CoxRows& rows, const CoxOptions& options);

/// Columns that are neither constant nor collinear.
[[nodiscard]] std::vector<Eigen::Index> ranked_columns(const std::vector<ColumnState>& columns);

/// Inverse of the information over the columns that keep some in the limit, 0 elsewhere. Where the
/// likelihood runs away the columns that do so come last: those that the others determine on the
/// rows that are left in the limit are taken out, so the rest have the variance of the limit.
[[nodiscard]] Eigen::MatrixXd limit_inverse(const CoxMaximum& maximum);

/// The same with NaN in rows and columns of coefficients that are NA.
[[nodiscard]] Eigen::MatrixXd with_missing(Eigen::MatrixXd variance, const CoxMaximum& maximum);

}  // namespace tcert::statistics
