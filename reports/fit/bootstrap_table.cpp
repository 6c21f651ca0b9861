#include "reports/fit/bootstrap_table.hpp"

#include <algorithm>
#include <cmath>

#include "reports/fit/cells.hpp"

namespace tcert {

BootstrapTable::BootstrapTable(double level) : level_(level) {
  table_.name = "bootstrap";
  table_.title = "Bootstrap intervals";
  table_.columns = {text_column("term", "predictor"),
                    number_column("estimate", "value"),
                    number_column("bias", "bias"),
                    number_column("std.error", "SE"),
                    number_column("conf.low", "BCa low"),
                    number_column("conf.high", "BCa high"),
                    number_column("expanded.low", "expanded low"),
                    number_column("expanded.high", "expanded high"),
                    number_column("percentile.low", "percentile low"),
                    number_column("percentile.high", "percentile high"),
                    number_column("basic.low", "basic low"),
                    number_column("basic.high", "basic high"),
                    number_column("normal.low", "normal low"),
                    number_column("normal.high", "normal high"),
                    number_column("acceleration", "acceleration"),
                    integer_column("replicates", "replicates used")};
}

void BootstrapTable::add(const std::string& name,
                         const statistics::BootstrapResult& result,
                         std::size_t value) {
  const statistics::BootstrapEstimate bca = statistics::bootstrap_estimate(result, value, level_);
  std::vector<TableCell> cells{
      name, number_cell(bca.observed), number_cell(bca.bias), number_cell(bca.standard_error)};
  for (const statistics::BootstrapMethod method : {statistics::BootstrapMethod::bca,
                                                   statistics::BootstrapMethod::expanded,
                                                   statistics::BootstrapMethod::percentile,
                                                   statistics::BootstrapMethod::basic,
                                                   statistics::BootstrapMethod::normal}) {
    const auto interval = statistics::bootstrap_estimate(result, value, level_, method).interval;
    cells.push_back(low_cell(interval));
    cells.push_back(high_cell(interval));
  }
  cells.push_back(number_cell(result.acceleration[value]));
  const auto& replicates = result.replicates[value];
  cells.push_back(integer_cell(static_cast<std::size_t>(std::count_if(
      replicates.begin(), replicates.end(), [](double one) { return std::isfinite(one); }))));
  table_.add_row(std::move(cells));
  for (statistics::Condition condition : bca.conditions) {
    condition.column = name;
    conditions_.push_back(std::move(condition));
  }
}

void BootstrapTable::append_to(FitReport& report) const {
  report.tables.push_back(table_);
  report.conditions.insert(report.conditions.end(), conditions_.begin(), conditions_.end());
}

}  // namespace tcert
