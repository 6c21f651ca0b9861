#include "datasets/import/barn_metrics.hpp"

#include <set>

namespace tcert {

std::vector<std::string> metric_columns(const BarnSource& metrics) {
  std::vector<std::string> columns{"m1", "m2", "m3", "m4", "m5"};
  for (const char* const name : {"norm1", "norm2", "norm3", "norm4", "norm5"}) {
    if (metrics.has(name)) {
      columns.emplace_back(name);
    }
  }
  return columns;
}

std::map<long, std::string> metrics_by_world(const BarnSource& metrics,
                                             const std::vector<std::string>& columns) {
  std::map<long, std::string> result;
  std::set<long> seen;
  for (std::size_t row = 0; row < metrics.rows(); ++row) {
    const std::optional<long> world = barn_world(metrics.cell(row, "world"));
    if (!world) {
      metrics.add(
          table::Severity::error, row, "world", "a whole number, 0 or more; the row is left out");
      continue;
    }
    if (!seen.insert(*world).second) {
      metrics.add(table::Severity::error, row, "world", "each world once; the first row counts");
      continue;
    }
    std::string cells;
    bool good = true;
    for (const std::string& column : columns) {
      if (!finite_number(metrics.cell(row, column))) {
        metrics.add(
            table::Severity::error, row, column, "a finite number; the world has no metrics");
        good = false;
      }
      cells += ',' + metrics.cell(row, column);
    }
    if (good) {
      result.emplace(*world, cells);
    }
  }
  return result;
}

}  // namespace tcert
