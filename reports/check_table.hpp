#pragma once
/// \file
/// What `check` found, as tables.

#include <optional>
#include <span>
#include <string>
#include <table/check_csv.hpp>
#include <vector>

#include "datasets/check_trial.hpp"
#include "datasets/import/bag_survey.hpp"
#include "datasets/import/csv_survey.hpp"
#include "reports/table.hpp"

namespace tcert {

/// One row a column of the file, with what it may be to a bundle and in which unit; the footnotes
/// say dialect, header, rows, clock, and what program writes such files.
[[nodiscard]] Table csv_check_table(const table::CsvCheck& check, const std::string& file);

/// One row a topic of a bag: its messages, rate and clock, and what it may be to a bundle.
[[nodiscard]] Table topics_table(std::span<const recording::TopicSurvey> topics,
                                 const std::string& bag);

/// One row a kind of file of a folder, with the columns that may be something to a bundle.
[[nodiscard]] Table csv_groups_table(std::span<const recording::CsvGroup> groups,
                                     const std::string& folder);

/// One row a trial: columns here, rows by trial_check_row.
[[nodiscard]] Table trial_check_table(const std::optional<SyntheticLabel>& synthetic);
[[nodiscard]] std::vector<TableCell> trial_check_row(const std::string& trial_id,
                                                     const TrialCheck& check);

}  // namespace tcert
