#pragma once
/// \file
/// The trials of one H1 panel: those that count, complete in everything, in columns.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/concordance/concordance.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

struct H1Data {
  std::vector<std::uint8_t> success;
  std::vector<std::vector<double>> predictors;  ///< As H1Options::predictors.
  std::vector<statistics::HigherMeans> higher;
  std::vector<std::string> names;
  std::optional<statistics::SurvivalOutcome>
      censored;  ///< Egress is the event; failures end when they fail.
  std::optional<statistics::SurvivalOutcome> at_limit;  ///< Failures stay at risk to the limit.
  std::vector<std::uint8_t> cut;  ///< 1 where the trial limit ended the trial.
  table::Factor cluster;          ///< Levels without a trial are gone.
  std::optional<table::Factor>
      strata;  ///< A code may be missing: only the stratified ratio needs them.
  std::string strata_name;
  std::optional<table::Factor> group;  ///< Levels without a trial are gone.
  /// The cross of `within_columns`; a code may be missing. Empty if the table has none of them.
  std::optional<table::Factor> within;
  std::vector<std::string> within_columns;

  [[nodiscard]] std::size_t rows() const noexcept { return success.size(); }
  [[nodiscard]] statistics::Score score(std::size_t predictor) const {
    return {predictors[predictor], higher[predictor]};
  }
  /// Of every predictor.
  [[nodiscard]] std::vector<statistics::Score> scores() const;
  /// Larger values go with a longer time where they speak for failure.
  [[nodiscard]] statistics::Predictor timed(std::size_t predictor) const {
    return {names[predictor],
            predictors[predictor],
            higher[predictor] == statistics::HigherMeans::success
                ? statistics::LargerMeans::shorter_time
                : statistics::LargerMeans::longer_time};
  }
};

/// Chooses the rows and counts what is left out, in `panel`. \throws FormulaError.
[[nodiscard]] H1Data panel_data(const table::DataTable& table,
                                const H1Options& options,
                                H1Panel& panel);

/// True if the complete trials of the panel have both outcomes and two clusters; otherwise its
/// conditions say why not.
[[nodiscard]] bool can_be_scored(H1Panel& panel);

/// \throws FormulaError with the nearest name if a required column is absent.
void require_columns(const table::DataTable& table, const H1Options& options);

/// True if the table has the landmark column of every predictor, or if a landmark is asked for.
/// \throws FormulaError if it is, and the table does not say when any trial ended.
[[nodiscard]] bool has_landmark(const table::DataTable& table, const H1Options& options);

}  // namespace tcert::study
