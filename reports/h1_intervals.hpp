#pragma once
/// \file
/// The bootstrap intervals of H1 and H2: how the one that is printed is called, and all of them.

#include <string>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "reports/table.hpp"

namespace tcert {

/// "95 % expanded": what stands in the brackets of a heading.
[[nodiscard]] std::string interval_text(statistics::BootstrapMethod method, double level);
[[nodiscard]] std::string h1_interval_text(const study::H1Options& options);

/// "expanded percentiles (Hesterberg 2015)", "percentiles", "BCa": what stands in a note.
[[nodiscard]] std::string interval_words(statistics::BootstrapMethod method);

/// A table without rows of values with their expanded, percentile and BCa intervals; a row of it
/// belongs to a panel and to a `row_name`.
[[nodiscard]] Table h1_interval_columns(std::string name,
                                        std::string row_name,
                                        std::string row_heading);

/// Both ends of the three intervals, as columns and as cells.
[[nodiscard]] std::vector<Column> interval_columns();
void append_intervals(const statistics::BootstrapIntervals& intervals,
                      std::vector<TableCell>& cells);

/// A footnote that says why BCa alone has no interval, if it has none; `of` names the row: "paper,
/// tc_early, AUC".
void add_no_bca(const std::string& of,
                const statistics::BootstrapIntervals& intervals,
                Table& table);

/// A row with its footnote, if the score has a value.
void add_intervals(const std::string& panel,
                   const std::string& row,
                   const std::string& quantity,
                   const study::H1Score& score,
                   Table& table);

/// Of every row and quantity of H1.
[[nodiscard]] Table h1_interval_table(const study::H1Table& h1);

}  // namespace tcert
