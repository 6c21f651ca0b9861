#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <table/json_shape.hpp>

#include "reports/table.hpp"

namespace tcert {
namespace {

using ReadJson = nlohmann::json;

ColumnKind kind_of(const std::string& word) {
  constexpr std::array kKinds{ColumnKind::text,
                              ColumnKind::integer,
                              ColumnKind::number,
                              ColumnKind::estimate,
                              ColumnKind::p_value};
  const auto* const kind = std::find_if(
      kKinds.begin(), kKinds.end(), [&](ColumnKind one) { return to_string(one) == word; });
  if (kind == kKinds.end()) {
    throw std::invalid_argument("unknown kind of column '" + word + "'");
  }
  return *kind;
}

double number_of(const ReadJson& row, const std::string& name) {
  const ReadJson& value = row.at(name);
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

TableCell cell_of(const ReadJson& row, const Column& column) {
  if (row.at(column.name).is_null() && column.kind != ColumnKind::estimate) {
    return {};
  }
  switch (column.kind) {
    case ColumnKind::text:
      return row.at(column.name).get<std::string>();
    case ColumnKind::integer:
      return row.at(column.name).get<std::int64_t>();
    case ColumnKind::number:
      return Number{number_of(row, column.name)};
    case ColumnKind::p_value:
      return PValue{number_of(row, column.name)};
    case ColumnKind::estimate: {
      const Estimate estimate{number_of(row, column.name),
                              number_of(row, column.name + "_low"),
                              number_of(row, column.name + "_high")};
      const bool none =
          std::isnan(estimate.value) && std::isnan(estimate.low) && std::isnan(estimate.high);
      return none ? TableCell{} : TableCell{estimate};
    }
  }
  return {};
}

void take_own_decimals(const ReadJson& json, Table& table) {
  if (!json.contains("cell_decimals")) {
    return;
  }
  for (const ReadJson& one : json.at("cell_decimals")) {
    TableCell& cell = table.rows.at(one.at(0).get<std::size_t>()).at(one.at(1).get<std::size_t>());
    if (auto* const number = std::get_if<Number>(&cell)) {
      number->decimals = one.at(2).get<int>();
    } else if (auto* const estimate = std::get_if<Estimate>(&cell)) {
      estimate->decimals = one.at(2).get<int>();
    }
  }
}

Table table_of(const ReadJson& json) {
  Table table;
  table.name = json.at("table").get<std::string>();
  table.title = json.at("title").get<std::string>();
  if (json.at("synthetic").get<bool>()) {
    table.synthetic.emplace();
    if (!json.at("seed").is_null()) {
      table.synthetic->seed = json.at("seed").get<std::uint64_t>();
    }
  }
  if (!json.at("n").is_null()) {
    table.n = json.at("n").get<std::int64_t>();
  }
  for (const ReadJson& one : json.at("columns")) {
    table.columns.push_back({one.at("name").get<std::string>(),
                             one.at("heading").get<std::string>(),
                             one.at("unit").get<std::string>(),
                             kind_of(one.at("kind").get<std::string>()),
                             one.at("decimals").get<int>(),
                             one.at("significant").get<int>()});
  }
  for (const ReadJson& one : json.at("rows")) {
    std::vector<TableCell> cells;
    for (const Column& column : table.columns) {
      cells.push_back(cell_of(one, column));
    }
    table.add_row(std::move(cells));
  }
  take_own_decimals(json, table);
  table.footnotes = json.at("footnotes").get<std::vector<std::string>>();
  return table;
}

}  // namespace

Table table_from_json(std::string_view text) {
  if (const auto shape = table::json_shape_problem(text); !shape.empty()) {
    throw std::invalid_argument("not a table: " + std::string(shape));
  }
  try {
    return table_of(ReadJson::parse(text));
  } catch (const ReadJson::exception& error) {
    throw std::invalid_argument(std::string("not a table: ") + error.what());
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("not a table: decimals of a cell that is not there");
  }
}

}  // namespace tcert
