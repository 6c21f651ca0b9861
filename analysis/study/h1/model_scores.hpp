#pragma once
/// \file
/// The models among the rows of H1: all rivals together, and the predictor under test added to
/// them.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <statistics/cox/cox.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_refit.hpp>
#include <string>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// A logistic model of success for the AUC and a Cox model of egress for C, on the same predictors,
/// each scaled to its standard deviation. Both are scored by their fixed part.
class H1Model {
 public:
  /// `columns` are indices of the panel's predictors.
  H1Model(const H1Data& data, const std::vector<std::size_t>& columns);

  /// AUC of the logistic model fitted to these multiplicities, on them; NaN without an estimate.
  [[nodiscard]] double auc(std::span<const std::uint32_t> multiplicity) const;

  /// C of the Cox model, likewise: each row stands as often as it was drawn, so Efron's ties are
  /// those of the resample. \pre the panel has times.
  [[nodiscard]] double c(std::span<const std::uint32_t> multiplicity) const;

  /// Coefficient of the last of `columns`, per standard deviation, fitted to these multiplicities:
  /// the log odds of success, the log hazard of egress. NaN without an estimate.
  [[nodiscard]] double added_logistic_coefficient(
      std::span<const std::uint32_t> multiplicity) const;
  [[nodiscard]] double added_cox_coefficient(std::span<const std::uint32_t> multiplicity) const;

  /// Linear predictors of all rows, fitted to the rows where `train` is set; empty without an
  /// estimate. A larger one speaks for success, or for earlier egress.
  [[nodiscard]] std::optional<std::vector<double>> logistic_scores(
      std::span<const std::uint8_t> train) const;
  [[nodiscard]] std::optional<std::vector<double>> cox_scores(
      std::span<const std::uint8_t> train) const;

  [[nodiscard]] const statistics::LogisticInput& logistic() const noexcept { return logistic_; }
  [[nodiscard]] const statistics::CoxData& cox() const noexcept { return cox_; }

 private:
  const H1Data& data_;
  statistics::LogisticInput logistic_;
  statistics::CoxData cox_;  ///< Of the censored outcome; without rows if there are no times.
  std::unique_ptr<statistics::LogisticRefit> refit_;
};

struct H1Models {
  std::vector<H1Model> models;  ///< Together, added; empty if there is no rival.
};

/// `data` must outlive them.
[[nodiscard]] H1Models h1_models(const H1Data& data);

}  // namespace tcert::study
