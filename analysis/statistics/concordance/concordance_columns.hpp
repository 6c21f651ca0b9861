#pragma once
/// \file
/// What C is computed from: the complete rows, copied only where some are left out. Internal to C.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/concordance/concordance.hpp>
#include <vector>

namespace tcert::statistics {

/// Spans go into the caller's columns or into copies held here. Times are raised to
/// `options.earliest`, and a start that all rows share is dropped.
class ConcordanceColumns {
 public:
  /// \throws std::invalid_argument as `concordance` does for lengths, clusters, times and level.
  ConcordanceColumns(const SurvivalOutcome& outcome,
                     std::span<const Predictor> predictors,
                     const ConcordanceOptions& options);
  ConcordanceColumns(const ConcordanceColumns&) = delete;
  ConcordanceColumns& operator=(const ConcordanceColumns&) = delete;
  ConcordanceColumns(ConcordanceColumns&&) = delete;
  ConcordanceColumns& operator=(ConcordanceColumns&&) = delete;
  ~ConcordanceColumns() = default;

  [[nodiscard]] const SurvivalOutcome& outcome() const noexcept { return *outcome_; }
  [[nodiscard]] std::span<const double> predictor(std::size_t i) const { return predictors_[i]; }
  /// Empty if there are none; so `strata` and `cluster`.
  [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
  [[nodiscard]] std::span<const std::uint32_t> strata() const noexcept { return strata_; }
  [[nodiscard]] std::span<const std::uint32_t> cluster() const noexcept { return cluster_; }

  /// Rows of the input with every predictor known; empty if all are.
  [[nodiscard]] const std::vector<std::size_t>& rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t missing() const noexcept { return missing_; }

 private:
  [[nodiscard]] bool is_complete(std::size_t row) const;
  void find_complete_rows();
  void copy_complete_rows();

  const SurvivalOutcome* outcome_;
  std::vector<std::span<const double>> predictors_;
  std::span<const double> weights_;
  std::span<const std::uint32_t> strata_;
  std::span<const std::uint32_t> cluster_;
  std::vector<std::size_t> rows_;
  std::size_t missing_ = 0;

  SurvivalOutcome own_outcome_;
  std::vector<std::vector<double>> own_predictors_;
  std::vector<double> own_weights_;
  std::vector<std::uint32_t> own_strata_;
  std::vector<std::uint32_t> own_cluster_;
};

}  // namespace tcert::statistics
