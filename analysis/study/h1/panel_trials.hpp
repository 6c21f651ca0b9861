#pragma once
/// \file
/// Which trials of a table an H1 panel has, and who is left out.

#include <cstddef>
#include <table/data_table.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h1/panel_columns.hpp"

namespace tcert::study {

/// Rows with an outcome, and of the landmark panel those that still run and move then.
[[nodiscard]] std::vector<std::size_t> trials_of_panel(const table::DataTable& table,
                                                       const H1Options& options,
                                                       const PanelColumns& columns,
                                                       H1Panel& panel);

/// Counts the trials of the paper panel that are over before their window is.
void count_window_ends(const table::DataTable& table,
                       const H1Options& options,
                       const PanelColumns& columns,
                       H1Panel& panel);

/// Those of `rows` with everything known; adds a row of the panel for each predictor.
[[nodiscard]] std::vector<std::size_t> complete_trials(const std::vector<std::size_t>& rows,
                                                       const H1Options& options,
                                                       const PanelColumns& columns,
                                                       H1Panel& panel);

}  // namespace tcert::study
