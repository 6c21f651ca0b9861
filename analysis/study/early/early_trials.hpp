#pragma once
/// \file
/// The trials that figures of the early certificate show: those of the panel of H1 that conclusions
/// are drawn from.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// One entry a trial: its outcome and TC_early are known.
struct EarlyTrials {
  H1PanelKind kind = H1PanelKind::paper;  ///< Landmark where the table has its column.
  std::vector<double> tc_early_m;
  std::vector<std::uint8_t> success;
  table::Factor day;  ///< Levels without a trial are gone; every trial its own without days.
  bool has_days = false;
  double landmark_s = 0.0;  ///< When the time window closes.

  [[nodiscard]] std::size_t size() const noexcept { return success.size(); }
  /// TC_early of the successes, or of the failures, in ascending order.
  [[nodiscard]] std::vector<double> sorted_values(bool of_successes) const;
};

/// As H1 chooses its trials, by the predictor under test alone and with the landmark at
/// `landmark_s`; empty if the table has no column `success` or `tc_early`, or no trial of it is
/// complete. \throws FormulaError if a column holds the wrong kind.
[[nodiscard]] std::optional<EarlyTrials> early_trials(const table::DataTable& features,
                                                      double landmark_s = H1Options().landmark_s);

}  // namespace tcert::study
