#pragma once
/// \file
/// The rows of a Cox model in the order in which the passes over the risk sets read them.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_risk_sets.hpp>
#include <vector>

namespace tcert::statistics {

/// Contiguous arrays of the m rows that are ever at risk, in the order of `sets.order`. Columns are
/// centred and scaled: sums over risk sets then neither overflow nor cancel.
struct CoxRows {
  RiskSets sets;
  std::size_t columns = 0;     ///< p.
  Eigen::VectorXd centre;      ///< p: the weighted mean over all n rows.
  Eigen::VectorXd scale;       ///< p: the weighted mean absolute deviation; 1 if it is 0.
  std::vector<double> x;       ///< m x p, a row after the other: (x - centre) / scale.
  std::vector<double> weight;  ///< m, or empty: every weight is 1.
  std::vector<double> offset;  ///< m, less `offset_centre`; or empty: every offset is 0.
  double offset_centre = 0.0;  ///< The mean over all n rows.

  [[nodiscard]] std::size_t rows() const noexcept { return sets.order.size(); }
  [[nodiscard]] double weight_of(std::size_t place) const noexcept {
    return weight.empty() ? 1.0 : weight[place];
  }
  [[nodiscard]] double offset_of(std::size_t place) const noexcept {
    return offset.empty() ? 0.0 : offset[place];
  }
  [[nodiscard]] const double* row(std::size_t place) const noexcept {
    return x.data() + place * columns;
  }
};

/// O(n (log n + p)).
[[nodiscard]] CoxRows cox_rows(const CoxData& data);

/// Risk scores exp(x beta + offset - shift) of the m rows.
struct RiskScores {
  std::vector<double> score;
  std::vector<double> weighted;  ///< Times the weight; empty if every weight is 1.
  double shift = 0.0;            ///< 0 unless an exponent would leave the range of numbers.

  /// What a row adds to the sums over risk sets.
  [[nodiscard]] const double* risk() const noexcept {
    return weighted.empty() ? score.data() : weighted.data();
  }
};

/// `beta` are the coefficients of the scaled columns. O(m p).
void risk_scores(const CoxRows& rows, const Eigen::VectorXd& beta, RiskScores& scores);

}  // namespace tcert::statistics
