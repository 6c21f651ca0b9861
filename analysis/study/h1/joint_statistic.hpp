#pragma once
/// \file
/// All bootstrapped numbers of an H1 panel as one statistic, so that they share their resamples.

#include <cstddef>
#include <statistics/resampling/statistic.hpp>

#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Where a number stands among the values of `joint_statistic`; `models` of them follow the
/// predictors.
struct H1Layout {
  std::size_t predictors = 0;
  std::size_t models = 0;  ///< 0 or 2: together, added.
  bool has_time = false;
  bool has_strata = false;

  [[nodiscard]] std::size_t scored() const noexcept { return predictors + models; }
  [[nodiscard]] static std::size_t auc(std::size_t row) noexcept { return row; }
  [[nodiscard]] std::size_t c(std::size_t row) const noexcept { return scored() + row; }
  /// Within strata, of predictors alone.
  [[nodiscard]] std::size_t auc_within(std::size_t row) const noexcept {
    return (has_time ? 2 : 1) * scored() + row;
  }
  [[nodiscard]] std::size_t c_within(std::size_t row) const noexcept {
    return auc_within(row) + predictors;
  }
};

/// AUC of every predictor and model, then C of each if there are times; then the same of the
/// predictors within strata, if there are any. Models are re-fitted on
/// each resample. NaN where a resample has one class, no comparable pair, or a fit without an
/// estimate.
[[nodiscard]] statistics::Statistic joint_statistic(const H1Data& data,
                                                    const H1Layout& layout,
                                                    const H1Models& models);

}  // namespace tcert::study
