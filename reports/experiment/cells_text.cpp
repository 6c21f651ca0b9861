#include "reports/experiment/cells_text.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <table/json_shape.hpp>

namespace tcert {
namespace {

using Json = nlohmann::json;

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_of(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

/// A cell as [kind, values ...]; the numbers of nlohmann read back to the same bits.
struct CellJson {
  Json operator()(std::monostate /*missing*/) const { return Json::array(); }
  Json operator()(const std::string& text) const { return {"text", text}; }
  Json operator()(std::int64_t value) const { return {"integer", value}; }
  Json operator()(const Number& n) const { return {"number", json_of(n.value), n.decimals}; }
  Json operator()(const Estimate& e) const {
    return {"estimate", json_of(e.value), json_of(e.low), json_of(e.high), e.decimals};
  }
  Json operator()(const PValue& p) const { return {"p", json_of(p.value)}; }
};

Json json_of(const std::vector<TableCell>& cells) {
  Json list = Json::array();
  for (const TableCell& cell : cells) {
    list.push_back(std::visit(CellJson{}, cell));
  }
  return list;
}

TableCell cell_of(const Json& json) {
  if (json.empty()) {
    return {};
  }
  const auto kind = json.at(0).get<std::string>();
  if (kind == "text") {
    return json.at(1).get<std::string>();
  }
  if (kind == "integer") {
    return json.at(1).get<std::int64_t>();
  }
  if (kind == "number") {
    return Number{number_of(json.at(1)), json.at(2).get<int>()};
  }
  if (kind == "p") {
    return PValue{number_of(json.at(1))};
  }
  return Estimate{
      number_of(json.at(1)), number_of(json.at(2)), number_of(json.at(3)), json.at(4).get<int>()};
}

std::vector<TableCell> cells_of(const Json& json) {
  std::vector<TableCell> cells;
  for (const Json& cell : json) {
    cells.push_back(cell_of(cell));
  }
  return cells;
}

}  // namespace

std::string to_text(const CellRows& rows) {
  Json json = Json::array();
  for (const auto& row : rows) {
    json.push_back(json_of(row));
  }
  return json.dump();
}

CellRows cell_rows_from(const std::string& text) {
  if (const auto shape = table::json_shape_problem(text); !shape.empty()) {
    throw std::invalid_argument(std::string(shape));
  }
  try {
    CellRows rows;
    for (const Json& row : Json::parse(text)) {
      rows.push_back(cells_of(row));
    }
    return rows;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace tcert
