#pragma once
/// \file
/// The bootstrap intervals of H1 and H2: how the one that is printed is called, and all of them.

#include <string>
#include <string_view>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "reports/columns_of.hpp"

namespace tcert {

/// "95 % expanded": what stands in the brackets of a heading.
[[nodiscard]] std::string interval_text(statistics::BootstrapMethod method, double level);
[[nodiscard]] std::string h1_interval_text(const study::H1Options& options);

/// "expanded percentiles (Hesterberg 2015)", "percentiles", "BCa": what stands in a note.
[[nodiscard]] std::string interval_words(statistics::BootstrapMethod method);

/// Both ends of all three.
[[nodiscard]] ColumnsOf<statistics::BootstrapIntervals> bootstrap_columns();

/// A footnote that says why BCa alone has no interval, if it has none; `of` names the row: "paper,
/// tc_early, AUC".
void add_no_bca(const std::string& of,
                const statistics::BootstrapIntervals& intervals,
                Table& table);

struct NamedScore : RowOf<study::H1Score> {
  std::string panel;
  std::string row;  ///< Of the panel's table.
  std::string quantity;
};

/// The scores that have a value, with their intervals by three methods; why BCa has none is a
/// footnote.
[[nodiscard]] Table score_interval_table(std::string name,
                                         std::string_view row_name,
                                         std::string_view row_heading,
                                         const std::vector<NamedScore>& scores);

/// Of every row and quantity of H1.
[[nodiscard]] Table h1_interval_table(const study::H1Table& h1);

}  // namespace tcert
