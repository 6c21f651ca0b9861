#pragma once
/// \file
/// Outcomes of trials from a foreign table, by the map.

#include <filesystem>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// Fills the rows, whose trial_id is set, from the map's table: a row whose id is the trial's, or
/// where no id is, whose only number is that of the trial's name ("7" of run_07, said so). The
/// table lies beside the map or below the first source. A trial that has no row keeps an unknown
/// outcome (a warning); rows of other trials are a note; two rows of one trial, a column that is
/// not there and a word that is neither true nor false are errors. Nothing to do without a table.
void read_outcomes(const LogMap& map,
                   const std::vector<std::filesystem::path>& folders,
                   bool decimal_comma,
                   std::vector<TrialRow>& trials,
                   table::DiagnosticGroups& problems);

}  // namespace tcert::recording
