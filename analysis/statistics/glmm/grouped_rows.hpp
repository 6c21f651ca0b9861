#pragma once
/// \file
/// The rows of a model with one grouping factor, group by group.

#include <Eigen/Core>
#include <cstdint>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <vector>

namespace tcert::statistics {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows of one group follow each other, within it in their first order.
struct GroupedRows {
  RowMajorMatrix basis;       ///< rows x columns.
  Eigen::VectorXd successes;  ///< Weights multiplied in.
  Eigen::VectorXd trials;
  Eigen::VectorXd offset;           ///< Empty for none.
  std::vector<Eigen::Index> start;  ///< groups + 1: where each group starts.
  bool unit_trials = false;         ///< Every row is one trial.

  [[nodiscard]] Eigen::Index groups() const noexcept {
    return static_cast<Eigen::Index>(start.size()) - 1;
  }
};

/// `codes` holds a group below `groups` for every row of `basis`. O(rows columns).
[[nodiscard]] GroupedRows grouped_rows(const Eigen::MatrixXd& basis,
                                       const BinomialRows& rows,
                                       const std::vector<std::uint32_t>& codes,
                                       std::size_t groups);

}  // namespace tcert::statistics
