#pragma once
/// \file
/// What `check` found, as tables.

#include <optional>
#include <string>
#include <table/check_csv.hpp>
#include <vector>

#include "datasets/check_trial.hpp"
#include "reports/table.hpp"

namespace tcert {

/// One row a column of the file; the footnotes say dialect, header, rows and clock.
[[nodiscard]] Table csv_check_table(const table::CsvCheck& check, const std::string& file);

/// One row a trial: columns here, rows by trial_check_row.
[[nodiscard]] Table trial_check_table(const std::optional<SyntheticLabel>& synthetic);
[[nodiscard]] std::vector<TableCell> trial_check_row(const std::string& trial_id,
                                                     const TrialCheck& check);

}  // namespace tcert
