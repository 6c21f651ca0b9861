#include "reports/columns_of.hpp"

#include <utility>

namespace tcert {

TableCell estimated_cell(const Estimated& estimated) {
  return estimate_cell(estimated.value, estimated.interval);
}

void ColumnList::push(Column column, std::unique_ptr<const Cell> cell, const std::string& doc) {
  columns_.push_back({std::move(column), std::move(cell), doc});
}

void ColumnList::push(Column (*column)(std::string, std::string),
                      std::string_view name,
                      std::string_view heading,
                      std::unique_ptr<const Cell> cell) {
  push(column(std::string(name), std::string(heading)), std::move(cell));
}

void ColumnList::set_unit(std::string_view unit, int decimals) {
  columns_.back().column.unit = unit;
  columns_.back().column.decimals = decimals;
}

std::vector<TableCell> ColumnList::cells_of(const void* row) const {
  std::vector<TableCell> cells;
  cells.reserve(columns_.size());
  for (const One& one : columns_) {
    cells.push_back(one.cell->of(row));
  }
  return cells;
}

Table ColumnList::without_rows(std::string name, std::string title) const {
  Table table;
  table.name = std::move(name);
  table.title = std::move(title);
  append_to(table.columns);
  return table;
}

void ColumnList::append_to(std::vector<Column>& columns) const {
  for (const One& one : columns_) {
    columns.push_back(one.column);
  }
}

std::vector<ColumnDoc> ColumnList::docs() const {
  std::vector<ColumnDoc> docs;
  for (const One& one : columns_) {
    docs.push_back({one.column.name, one.column.unit, one.doc});
  }
  return docs;
}

}  // namespace tcert
