#pragma once
/// \file
/// How often certificates were issued, by what became of the trial.

#include <table/data_table.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// Of the successes, then of the failures; empty if the table does not say.
[[nodiscard]] std::vector<IssuedCount> issued_counts(const table::DataTable& table,
                                                     const H1Options& options);

}  // namespace tcert::study
