#pragma once
/// \file
/// What a fit gives, in every format: its summary, its tables, the conditions it met.

#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "reports/manifest.hpp"
#include "reports/table.hpp"

namespace tcert {

/// A document that goes with a report, for another program to take as it is.
struct Attachment {
  std::string name;  ///< snake_case: the file name without its ending.
  std::string title;
  std::string text;             ///< Ends with a line end.
  std::string ending = "json";  ///< What it is: "json", or "ini" of a config file.
};

struct FitReport {
  std::string model;           ///< "cox".
  Settings settings;           ///< Formula, data, options; in this order.
  Table findings;              ///< See findings.hpp; without rows if nothing is to be said.
  Table summary;               ///< One row: n, events, tests of the whole model, how the fit ended.
  std::vector<Table> tables;   ///< For people and programs; the first one is the main table.
  std::vector<Table> details;  ///< For programs: covariances, residuals, curves.
  std::vector<Attachment> attachments;
  statistics::Conditions conditions;
  std::optional<SyntheticLabel> synthetic;

  /// Null if there is no table of that name.
  [[nodiscard]] const Table* find(std::string_view table) const noexcept;
  [[nodiscard]] std::vector<std::string> table_names() const;

  void add(const statistics::Conditions& more);
};

/// Whether there is what the fit is for: a number in the column `estimate` of the main table (of a
/// fixed effect, where there are random ones), or a Brier score. True without such a column, and
/// without a row: a model without coefficients lacks none.
[[nodiscard]] bool has_estimate(const FitReport& report);

/// A row each, for programs.
[[nodiscard]] Table all_conditions_table(const statistics::Conditions& conditions);

/// Those that people read: a line a kind, however many columns have it.
[[nodiscard]] Table conditions_table(const statistics::Conditions& conditions);
[[nodiscard]] std::string conditions_text(const statistics::Conditions& conditions,
                                          std::size_t width = 0);

/// Text: the findings as lines, `tables`, the summary, the attachments and the conditions; for a
/// terminal of `width`, on which the end is what one sees, the findings are last. Markdown:
/// likewise, the findings as a table. LaTeX: `tables` and the summary, for a text has words of its
/// own. JSON: one document with everything; the summary is an object, every table a list of
/// objects, each condition an object with name, severity, column, detail, each attachment what it
/// is, a text unless it is JSON. CSV and JSON Lines: the main table. With `table` only the table of
/// that name, in any format; it is to be there. After an error without a single number in the main
/// table, text, Markdown and LaTeX have the conditions alone.
[[nodiscard]] std::string render(const FitReport& report,
                                 TableFormat format,
                                 std::string_view table = {},
                                 std::size_t width = 0);

}  // namespace tcert
