#include "reports/table_json.hpp"

#include <charconv>
#include <cmath>

namespace tcert {
namespace {

using Json = OrderedJson;

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

struct JsonCell {
  Json& row;
  const Column& column;

  void operator()(std::monostate /*missing*/) const {
    if (column.kind == ColumnKind::estimate) {
      (*this)(Estimate{});
    } else {
      row[column.name] = nullptr;
    }
  }
  void operator()(const std::string& text) const { row[column.name] = text; }
  void operator()(std::int64_t value) const { row[column.name] = value; }
  void operator()(const Number& number) const { row[column.name] = json_number(number.value); }
  void operator()(const Estimate& estimate) const {
    row[column.name] = json_number(estimate.value);
    row[column.name + "_low"] = json_number(estimate.low);
    row[column.name + "_high"] = json_number(estimate.high);
  }
  void operator()(const PValue& p) const { row[column.name] = json_number(p.value); }
};

}  // namespace

OrderedJson json_row(const Table& table, const std::vector<TableCell>& cells) {
  Json row = Json::object();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::visit(JsonCell{row, table.columns[c]}, cells[c]);
  }
  return row;
}

OrderedJson setting_value(const std::string& text) {
  if (text.empty()) {
    return nullptr;
  }
  if (text == "true" || text == "false") {
    return text == "true";
  }
  const char* end = text.data() + text.size();
  std::uint64_t whole = 0;
  if (const auto read = std::from_chars(text.data(), end, whole);
      read.ec == std::errc{} && read.ptr == end) {
    return whole;
  }
  double number = 0.0;
  if (const auto read = std::from_chars(text.data(), end, number);
      read.ec == std::errc{} && read.ptr == end && std::isfinite(number)) {
    return number;
  }
  return text;
}

std::string dumped(const OrderedJson& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tcert
