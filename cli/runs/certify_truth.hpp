#pragma once
/// \file
/// The truth of a bundle's worlds beside its certificates.

#include "analysis/study/trials/study_tables.hpp"
#include "cli/runs/inputs.hpp"

namespace tcert::cli {

/// Appends the columns truth_lower_m and truth_upper_m to the extra columns of the bundle, so that
/// they come out in the features: T of worlds/<world>.json, `world` being the trial's column of
/// that name or else its id. Empty where there is no such file or no path; a world that cannot be
/// used is said and leaves its trials without. The same text is computed once.
void add_truth(OpenedBundle& opened, std::int64_t threads, Progress& progress);

/// Says each failed trial that was issued a certificate, with its T_t and its truth.
void say_issued_failures(const std::vector<study::TrialRecord>& trials, Progress& progress);

}  // namespace tcert::cli
