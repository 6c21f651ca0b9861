#pragma once
/// \file
/// trials.csv: one row a trial.

#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"

namespace tcert {

/// The words of trials.csv: "goal", "collision", ...; empty for unknown.
[[nodiscard]] std::string_view to_string(EndReason reason) noexcept;

/// Fills `bundle.trials` and `bundle.extra_columns` from the bytes of trials.csv; `bundle.info`
/// says the lighting tiers, the trial limit and the renames. Rows with an error are left out, and
/// so are all rows of a trial_id that is given twice.
void read_trial_table(const table::Bytes& bytes, Bundle& bundle, table::DiagnosticGroups& problems);

/// The text of a trials.csv that reads back as these rows.
[[nodiscard]] std::string to_trials_csv(const std::vector<TrialRow>& trials,
                                        const std::vector<std::string>& extra_columns);

}  // namespace tcert
