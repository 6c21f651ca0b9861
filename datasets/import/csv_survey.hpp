#pragma once
/// \file
/// What CSV files a source holds, which of them are alike, and what trials their names tell apart.

#include <cstddef>
#include <filesystem>
#include <string>
#include <table/check_csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::recording {

/// Files with the same columns.
struct CsvGroup {
  std::string pattern;                       ///< Their names below the source, with {trial} for
                                             ///< what differs; of one file its name.
  std::vector<std::filesystem::path> files;  ///< Sorted.
  table::CsvCheck check;                     ///< Of the first.
  bool is_of_trials = false;                 ///< A table of outcomes: a row a trial.
};

/// Groups in order of the number of their files, the largest first. A file that is no table is not
/// among them. The first file of each group is read, of the others the header. At most 10,000 files
/// are looked at. `clock` names the clock of the groups that have such a column; it may be empty.
[[nodiscard]] std::vector<CsvGroup> survey_csv(const std::filesystem::path& source,
                                               bool decimal_comma,
                                               const std::string& clock,
                                               table::DiagnosticGroups& problems);

/// What is common to names at their beginning and their end with {trial} between; cut at the
/// borders of words, so that run_07 and run_08 are run_{trial}. One name as it is.
[[nodiscard]] std::string pattern_of(const std::vector<std::string>& names);

}  // namespace tcert::recording
