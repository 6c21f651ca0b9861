#pragma once
/// \file
/// The rows of a Cox model in the order in which the passes over the risk sets read them.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "analysis/cox.hpp"
#include "analysis/cox_risk_sets.hpp"

namespace tcert {

/// Contiguous arrays of the m rows that are ever at risk, in the order of `sets.order`. Columns are
/// centred and scaled: sums over risk sets then neither overflow nor cancel.
struct CoxRows {
  RiskSets sets;
  std::size_t columns = 0;     ///< p.
  Eigen::VectorXd centre;      ///< p: the weighted mean over all n rows.
  Eigen::VectorXd scale;       ///< p: the weighted mean absolute deviation; 1 if it is 0.
  std::vector<double> x;       ///< m x p, a row after the other: (x - centre) / scale.
  std::vector<double> weight;  ///< m.
  std::vector<double> offset;  ///< m.

  [[nodiscard]] std::size_t rows() const noexcept { return sets.order.size(); }
  [[nodiscard]] const double* row(std::size_t place) const noexcept {
    return x.data() + place * columns;
  }
};

/// O(n (log n + p)).
[[nodiscard]] CoxRows cox_rows(const CoxData& data);

/// Risk scores exp(x beta + offset - shift) of the m rows.
struct RiskScores {
  std::vector<double> score;
  double shift = 0.0;  ///< 0 unless the largest exponent would overflow.
};

/// `beta` are the coefficients of the scaled columns. O(m p).
void risk_scores(const CoxRows& rows, const Eigen::VectorXd& beta, RiskScores& scores);

}  // namespace tcert
