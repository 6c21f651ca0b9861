#include "reports/study/study_summary.hpp"

#include "reports/fit/cells.hpp"

namespace tcert {

FitReport study_report(std::string name, std::uint64_t seed) {
  FitReport report;
  report.model = std::move(name);
  report.synthetic = SyntheticLabel{seed};
  return report;
}

Table study_summary(const std::vector<std::pair<std::string, std::uint64_t>>& numbers) {
  Table table;
  table.name = "summary";
  table.title = "Options";
  std::vector<TableCell> row;
  for (const auto& [name, value] : numbers) {
    table.columns.push_back(integer_column(name, name));
    row.push_back(integer_cell(value));
  }
  table.add_row(std::move(row));
  return table;
}

}  // namespace tcert
