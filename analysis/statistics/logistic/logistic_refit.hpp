#pragma once
/// \file
/// A logistic regression fitted again and again on resampled rows: what a bootstrap replicate
/// needs and no more.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>

namespace tcert::statistics {

/// One replicate.
struct LogisticReplicate {
  /// Along the basis; pass them to `linear_predictor`. Empty unless `termination` is converged.
  std::optional<Eigen::VectorXd> coefficients;
  Termination termination = Termination::converged;  ///< `diverging` is proven separation.
};

/// Holds the basis of the design and the estimate of all rows, from which replicates start.
/// Immutable: replicates may be fitted by several threads at once.
class LogisticRefit {
 public:
  /// \throws std::invalid_argument as `fit_logistic`.
  explicit LogisticRefit(const LogisticInput& input, const NewtonOptions& options = {});

  /// False if all rows together have no finite estimate; replicates then start from 0.
  [[nodiscard]] bool warm() const noexcept { return warm_; }

  /// Each row of the input counts `multiplicities[row]` times; a replicate without both outcomes
  /// counts as separated. \throws std::invalid_argument if the length is not the input's.
  /// O(rows columns^2) an iteration, usually 4.
  [[nodiscard]] LogisticReplicate fit(std::span<const std::uint32_t> multiplicities) const;

  /// X beta with the offset, one entry per row of the input that has trials and weight.
  [[nodiscard]] Eigen::VectorXd linear_predictor(const Eigen::VectorXd& coefficients) const;

  /// Of the input's columns; 0 for those that were dropped.
  [[nodiscard]] Eigen::VectorXd column_coefficients(const Eigen::VectorXd& coefficients) const;

 private:
  LogisticProblem problem_;
  NewtonOptions options_;
  Eigen::Index input_rows_;
  Eigen::Index input_columns_;
  Eigen::VectorXd start_;
  bool warm_ = false;
};

}  // namespace tcert::statistics
