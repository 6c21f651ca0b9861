#include "reports/fit/bootstrap_table.hpp"

#include <algorithm>
#include <cmath>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using statistics::BootstrapMethod;

struct Value {
  std::string name;
  const statistics::BootstrapResult& result;
  std::size_t value;
  statistics::BootstrapEstimate bca;
  std::optional<statistics::Interval> expanded;
  std::optional<statistics::Interval> percentile;
  std::optional<statistics::Interval> basic;
  std::optional<statistics::Interval> normal;
};

/// How many replicates gave a value.
std::size_t used(const Value& r) {
  const auto& replicates = r.result.replicates[r.value];
  return static_cast<std::size_t>(std::count_if(
      replicates.begin(), replicates.end(), [](double one) { return std::isfinite(one); }));
}

ColumnsOf<Value> bootstrap_columns() {
  return ColumnsOf<Value>()
      .text("term", "predictor", &Value::name)
      .number("estimate", "value", [](auto& r) { return r.bca.observed; })
      .number("bias", "bias", [](auto& r) { return r.bca.bias; })
      .number("std.error", "SE", [](auto& r) { return r.bca.standard_error; })
      .ends({"conf.low", "BCa low"},
            {"conf.high", "BCa high"},
            [](auto& r) { return r.bca.interval; })
      .ends({"expanded.low", "expanded low"}, {"expanded.high", "expanded high"}, &Value::expanded)
      .ends({"percentile.low", "percentile low"},
            {"percentile.high", "percentile high"},
            &Value::percentile)
      .ends({"basic.low", "basic low"}, {"basic.high", "basic high"}, &Value::basic)
      .ends({"normal.low", "normal low"}, {"normal.high", "normal high"}, &Value::normal)
      .number(
          "acceleration", "acceleration", [](auto& r) { return r.result.acceleration[r.value]; })
      .integer("replicates", "replicates used", used);
}

}  // namespace

BootstrapTable::BootstrapTable(double level)
    : level_(level), table_(bootstrap_columns().table("bootstrap", "Bootstrap intervals")) {}

void BootstrapTable::add(const std::string& name,
                         const statistics::BootstrapResult& result,
                         std::size_t value) {
  const statistics::BootstrapEstimate bca = statistics::bootstrap_estimate(result, value, level_);
  const auto interval_by = [&](BootstrapMethod method) {
    return statistics::bootstrap_estimate(result, value, level_, method).interval;
  };
  table_.add_row(bootstrap_columns().row({name,
                                          result,
                                          value,
                                          bca,
                                          interval_by(BootstrapMethod::expanded),
                                          interval_by(BootstrapMethod::percentile),
                                          interval_by(BootstrapMethod::basic),
                                          interval_by(BootstrapMethod::normal)}));
  for (statistics::Condition condition : bca.conditions) {
    condition.column = name;
    conditions_.push_back(std::move(condition));
  }
}

void BootstrapTable::append_to(FitReport& report) const {
  report.tables.push_back(table_);
  report.add(conditions_);
}

}  // namespace tcert
