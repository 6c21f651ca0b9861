#pragma once
/// \file
/// The feature table: one row a trial, its outcome and what its early window shows. Every test of a
/// hypothesis starts here.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/features.hpp"
#include "datasets/bundle.hpp"
#include "datasets/csv.hpp"
#include "datasets/diagnostic.hpp"

namespace tcert {

struct FeatureRow {
  TrialRow trial;  ///< `trial.extra` holds one cell per FeatureTable::extra_columns.
  Features features;
};

struct FeatureTable {
  std::vector<std::string> extra_columns;
  std::vector<FeatureRow> rows;
};

/// A column of the table that is a feature. Truth values are 0 and 1.
struct FeatureColumn {
  std::string_view name;
  std::string_view unit;  ///< Empty for a pure number.
  std::string_view meaning;
  std::optional<double> (*get)(const Features& features);
  void (*set)(Features& features, std::optional<double> value);
};

/// All features, in the order of the file's columns.
[[nodiscard]] std::span<const FeatureColumn> feature_columns() noexcept;

/// The table as CSV: the trial's columns, the extra ones as they are, the features. Numbers read
/// back to the same bits; a missing value is an empty cell. `comment`, if any, is the first line,
/// after "# ".
/// \throws std::invalid_argument if an extra column has the name of another column, case folded.
[[nodiscard]] std::string to_csv(const FeatureTable& table, std::string_view comment = {});

struct FeatureTableResult {
  std::optional<FeatureTable> table;  ///< Empty iff it has an error.
  std::vector<Diagnostic> diagnostics;
};

/// Any table with a column `success` (0, 1, true, false or missing). Trial columns and features are
/// found by name and may be absent, all other columns are carried as extra ones; a trial without an
/// id gets its row number. Missing is an empty cell or NA. `file` is its name in the diagnostics,
/// which hold every bad cell. A feature table that was written reads back the same.
[[nodiscard]] FeatureTableResult to_feature_table(const TextTable& table, std::string_view file);

}  // namespace tcert
