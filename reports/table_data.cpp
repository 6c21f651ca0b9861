#include <cmath>
#include <cstddef>
#include <table/csv_write.hpp>
#include <utility>

#include "reports/table_formats.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

constexpr std::string_view kSeedColumn = "synthetic_seed";

void append_finite(std::string& out, double value) {
  if (std::isfinite(value)) {
    table::append_number(out, value);
  }
}

struct CsvCell {
  std::string& out;
  ColumnKind kind;

  void operator()(std::monostate /*missing*/) const {
    if (kind == ColumnKind::estimate) {
      out += ",,";
    }
  }
  void operator()(const std::string& text) const { table::append_text(out, text); }
  void operator()(std::int64_t value) const { out += std::to_string(value); }
  void operator()(const Number& number) const { append_finite(out, number.value); }
  void operator()(const Estimate& estimate) const {
    append_finite(out, estimate.value);
    out += ',';
    append_finite(out, estimate.low);
    out += ',';
    append_finite(out, estimate.high);
  }
  void operator()(const PValue& p) const { append_finite(out, p.value); }
};

using Json = OrderedJson;

/// Row, column and decimals of each cell that is rounded otherwise than its column says.
Json own_decimals(const Table& table) {
  Json list = Json::array();
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const auto* const number = std::get_if<Number>(&table.rows[r][c]);
      const auto* const estimate = std::get_if<Estimate>(&table.rows[r][c]);
      const int decimals = number != nullptr     ? number->decimals
                           : estimate != nullptr ? estimate->decimals
                                                 : kColumnDecimals;
      if (decimals != kColumnDecimals) {
        list.push_back(Json::array({r, c, decimals}));
      }
    }
  }
  return list;
}

}  // namespace

void append_csv_header(std::string& out, const Table& table) {
  std::string_view separator;
  for (const Column& column : table.columns) {
    out += separator;
    separator = ",";
    table::append_text(out, column.name);
    if (column.kind == ColumnKind::estimate) {
      out += ',';
      table::append_text(out, column.name + "_low");
      out += ',';
      table::append_text(out, column.name + "_high");
    }
  }
  if (table.synthetic) {
    out += separator;
    out += kSeedColumn;
  }
  out += '\n';
}

void append_csv_row(std::string& out, const Table& table, const std::vector<TableCell>& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (c > 0) {
      out += ',';
    }
    std::visit(CsvCell{out, table.columns[c].kind}, cells[c]);
  }
  if (table.synthetic) {
    out += ',';
    out += table.synthetic->seed ? std::to_string(*table.synthetic->seed) : "";
  }
  out += '\n';
}

std::string render_csv(const Table& table) {
  std::string out;
  append_csv_header(out, table);
  for (const auto& row : table.rows) {
    append_csv_row(out, table, row);
  }
  return out;
}

std::string render_json(const Table& table) {
  Json json;
  json["synthetic"] = table.synthetic.has_value();
  if (table.synthetic) {
    json["seed"] = table.synthetic->seed ? Json(*table.synthetic->seed) : Json(nullptr);
  }
  json["table"] = table.name;
  json["title"] = table.title;
  json["n"] = table.n ? Json(*table.n) : Json(nullptr);
  json["columns"] = Json::array();
  for (const Column& column : table.columns) {
    json["columns"].push_back({{"name", column.name},
                               {"heading", column.heading},
                               {"unit", column.unit},
                               {"kind", to_string(column.kind)},
                               {"decimals", column.decimals},
                               {"significant", column.significant}});
  }
  json["rows"] = Json::array();
  for (const auto& row : table.rows) {
    json["rows"].push_back(json_row(table, row));
  }
  if (Json decimals = own_decimals(table); !decimals.empty()) {
    json["cell_decimals"] = std::move(decimals);
  }
  json["footnotes"] = table.footnotes;
  return dumped(json, 2);
}

std::string render_jsonl(const Table& table) {
  std::string out;
  for (const auto& cells : table.rows) {
    Json row = json_row(table, cells);
    if (table.synthetic) {
      row[std::string(kSeedColumn)] =
          table.synthetic->seed ? Json(*table.synthetic->seed) : Json(nullptr);
    }
    out += dumped(row, -1);
  }
  return out;
}

}  // namespace tcert
