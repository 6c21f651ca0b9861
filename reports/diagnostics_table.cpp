#include "reports/diagnostics_table.hpp"

#include <array>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using table::Diagnostic;

constexpr std::array kSeverities = {"note", "warning", "error"};

struct Problem {
  const std::string& trial_id;
  const Diagnostic& of;
};

ColumnsOf<Problem> problem_columns() {
  return ColumnsOf<Problem>()
      .text("trial_id", "trial", [](auto& r) { return not_empty(r.trial_id); })
      .text("severity",
            "severity",
            [](auto& r) { return kSeverities[static_cast<std::size_t>(r.of.severity)]; })
      .answer()
      .text("file", "file", [](auto& r) { return not_empty(r.of.file); })
      .integer("line", "line", [](auto& r) { return when(r.of.line != 0, r.of.line); })
      .text("column", "column", [](auto& r) { return not_empty(r.of.column); })
      .text("value", "found", [](auto& r) { return not_empty(r.of.value); })
      .answer()
      .text("expectation", "expected", [](auto& r) { return not_empty(r.of.expectation); })
      .integer("count", "count", [](auto& r) { return r.of.count; });
}

}  // namespace

Table diagnostics_table(const std::optional<SyntheticLabel>& synthetic) {
  Table table = problem_columns().table("diagnostics", "Problems of the inputs");
  table.synthetic = synthetic;
  return table;
}

std::vector<TableCell> diagnostics_row(const std::string& trial_id, const Diagnostic& diagnostic) {
  static const ColumnsOf<Problem> columns = problem_columns();
  return columns.row({trial_id, diagnostic});
}

}  // namespace tcert
