#pragma once
/// \file
/// The maximum of the partial likelihood, the columns that have one, and those that run away.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "analysis/cox/cox_likelihood.hpp"
#include "analysis/cox/cox_rows.hpp"

namespace tcert {

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
  CoxSummary summary;
};

/// \pre some event. Information that a column adds to those before it is compared with what it has
/// alone, at beta = 0, to find constant and collinear ones.
[[nodiscard]] CoxMaximum maximise(const CoxRows& rows, const CoxOptions& options);

/// Columns that are neither constant nor collinear.
[[nodiscard]] std::vector<Eigen::Index> ranked_columns(const std::vector<ColumnState>& columns);

/// Inverse of the information; NaN in rows and columns of coefficients that are NA. Where the
/// likelihood runs away the directions that do so are taken out first, so the others have the
/// variance of the limit.
[[nodiscard]] Eigen::MatrixXd inverse_information(const CoxMaximum& maximum);

}  // namespace tcert
