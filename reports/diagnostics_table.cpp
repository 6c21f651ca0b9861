#include "reports/diagnostics_table.hpp"

#include <array>
#include <string_view>

namespace tcert {
namespace {

constexpr std::array<std::string_view, 3> kSeverities = {"note", "warning", "error"};

TableCell text_or_missing(const std::string& text) {
  return text.empty() ? TableCell{} : TableCell{text};
}

}  // namespace

Table diagnostics_table(const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "diagnostics";
  table.title = "Problems of the inputs";
  table.synthetic = synthetic;
  table.columns = {{"trial_id", "trial", "", ColumnKind::text},
                   {"severity", "severity", "", ColumnKind::text},
                   {"file", "file", "", ColumnKind::text},
                   {"line", "line", "", ColumnKind::integer},
                   {"column", "column", "", ColumnKind::text},
                   {"value", "found", "", ColumnKind::text},
                   {"expectation", "expected", "", ColumnKind::text},
                   {"count", "count", "", ColumnKind::integer}};
  return table;
}

std::vector<TableCell> diagnostics_row(const std::string& trial_id,
                                       const table::Diagnostic& diagnostic) {
  return {
      text_or_missing(trial_id),
      std::string(kSeverities[static_cast<std::size_t>(diagnostic.severity)]),
      text_or_missing(diagnostic.file),
      diagnostic.line == 0 ? TableCell{} : TableCell{static_cast<std::int64_t>(diagnostic.line)},
      text_or_missing(diagnostic.column),
      text_or_missing(diagnostic.value),
      text_or_missing(diagnostic.expectation),
      static_cast<std::int64_t>(diagnostic.count)};
}

}  // namespace tcert
