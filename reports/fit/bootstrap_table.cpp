#include "reports/fit/bootstrap_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using statistics::BootstrapMethod;

/// Beside BCa.
constexpr std::array kMethods{std::pair("expanded", BootstrapMethod::expanded),
                              std::pair("percentile", BootstrapMethod::percentile),
                              std::pair("basic", BootstrapMethod::basic),
                              std::pair("normal", BootstrapMethod::normal)};

struct Value {
  std::string name;
  const statistics::BootstrapResult& result;
  std::size_t value;
  statistics::BootstrapEstimate bca;
  std::map<BootstrapMethod, std::optional<statistics::Interval>> intervals;
};

/// How many replicates gave a value.
std::size_t used(const Value& r) {
  const auto& replicates = r.result.replicates[r.value];
  return static_cast<std::size_t>(std::count_if(
      replicates.begin(), replicates.end(), [](double one) { return std::isfinite(one); }));
}

ColumnsOf<Value> value_columns() {
  ColumnsOf<Value> columns;
  columns.text("term", "predictor", &Value::name)
      .number("estimate", "value", [](auto& r) { return r.bca.observed; })
      .number("bias", "bias", [](auto& r) { return r.bca.bias; })
      .number("std.error", "SE", [](auto& r) { return r.bca.standard_error; })
      .ends({"conf.low", "BCa low"}, {"conf.high", "BCa high"}, [](auto& r) {
        return r.bca.interval;
      });
  for (const auto& [word, method] : kMethods) {
    const std::string name = word;
    columns.ends({name + ".low", name + " low"},
                 {name + ".high", name + " high"},
                 [method = method](auto& r) { return r.intervals.at(method); });
  }
  return columns
      .number(
          "acceleration", "acceleration", [](auto& r) { return r.result.acceleration[r.value]; })
      .integer("replicates", "replicates used", used);
}

}  // namespace

BootstrapTable::BootstrapTable(double level)
    : level_(level), table_(value_columns().table("bootstrap", "Bootstrap intervals")) {}

void BootstrapTable::add(const std::string& name,
                         const statistics::BootstrapResult& result,
                         std::size_t value) {
  const statistics::BootstrapEstimate bca = statistics::bootstrap_estimate(result, value, level_);
  Value row{name, result, value, bca, {}};
  for (const auto& [word, method] : kMethods) {
    row.intervals[method] = statistics::bootstrap_estimate(result, value, level_, method).interval;
  }
  table_.add_row(value_columns().row(row));
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
