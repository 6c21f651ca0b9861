#pragma once
/// \file
/// The cells of a foreign table of outcomes as those of trials.csv. Internal to trial_outcomes.cpp.

#include <cstddef>
#include <optional>
#include <string>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// The table of outcomes, and where its problems are. What it is made from must outlive it.
class Outcomes {
 public:
  Outcomes(const table::TextTable& table, std::string file, table::DiagnosticGroups& problems);

  /// The place of a column; one that is not there is an error, with the nearest name.
  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;

  /// Says what is wrong with a cell.
  void add(table::Severity severity,
           std::size_t row,
           std::size_t column,
           std::string expectation) const;

  /// Fills the members of `trial` that `sources` name. \pre their columns are there.
  void fill(std::size_t row, const std::vector<OutcomeSource>& sources, TrialRow& trial) const;

 private:
  [[nodiscard]] std::optional<bool> success(std::size_t row,
                                            std::size_t column,
                                            const OutcomeSource& source) const;
  [[nodiscard]] std::optional<double> number(std::size_t row,
                                             std::size_t column,
                                             double scale) const;
  [[nodiscard]] EndReason end_reason(std::size_t row, std::size_t column) const;

  const table::TextTable& table_;
  std::string file_;
  table::DiagnosticGroups& problems_;
};

}  // namespace tcert::recording
