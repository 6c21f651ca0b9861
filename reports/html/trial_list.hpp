#pragma once
/// \file
/// The list of trials as the page sorts and filters it.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <vector>

namespace tcert {

/// features.csv and certificates.csv of one result, joined by trial.
class TrialList {
 public:
  /// Either may be missing, not both. Trials are in the order of the features.
  TrialList(const std::optional<table::TextTable>& features,
            const std::optional<table::TextTable>& certificates);

  [[nodiscard]] std::size_t size() const noexcept { return ids_.size(); }
  [[nodiscard]] const std::string& id(std::size_t trial) const { return ids_[trial]; }

  /// The cell as it is in the file; empty if it is missing, or there is no such column.
  [[nodiscard]] std::string_view cell(std::size_t trial, std::string_view column) const;

  /// The same as a number; NaN if it is none.
  [[nodiscard]] double number(std::size_t trial, std::string_view column) const;

  /// "CB-V, Dark, day 3: success after 55.2 s. Certificate 0.214 m, issued at 54.9 s."
  [[nodiscard]] std::string facts(std::size_t trial) const;

 private:
  std::optional<table::TextTable> features_;
  std::optional<table::TextTable> certificates_;
  std::vector<std::string> ids_;
  std::vector<std::size_t> certificate_rows_;  ///< By trial; kNoRow if it has none.
};

/// Values of one trial's corridor value and certificate, few and evenly spaced in time; NaN where
/// missing.
using Sparkline = std::vector<double>;

inline constexpr std::size_t kSparkPoints = 40;

/// T_t where it is issued, before that V_t, at `kSparkPoints` times from the first tick to the
/// last.
[[nodiscard]] Sparkline sparkline(const table::NumberTable& series);

/// packed() JSON: columns that hold anything, a row a trial, sparklines (none if `sparks` is
/// empty). Numbers as the files have them, to the digits that the page shows.
[[nodiscard]] std::string trial_list_block(const TrialList& trials,
                                           const std::vector<Sparkline>& sparks);

}  // namespace tcert
