#include "reports/terrain/explore_table.hpp"

namespace tcert {
namespace {

[[nodiscard]] TableCell whole(std::size_t value) { return static_cast<std::int64_t>(value); }

/// Missing where there is none.
[[nodiscard]] TableCell number(const std::optional<double>& value) {
  TableCell cell;
  if (value) {
    cell = Number{*value};
  }
  return cell;
}
[[nodiscard]] TableCell whole(const std::optional<int>& value) {
  TableCell cell;
  if (value) {
    cell = static_cast<std::int64_t>(*value);
  }
  return cell;
}

[[nodiscard]] std::vector<TableCell> row_of(const terrain::ExploreStep& s) {
  std::optional<int> next_x;
  std::optional<int> next_y;
  std::optional<double> width;
  if (s.next) {
    next_x = s.next->x;
    next_y = s.next->y;
    width = s.upper - s.lower;
  }
  std::vector<TableCell> cells;
  cells.push_back(whole(std::optional(s.step)));
  cells.push_back(number(s.at.x()));
  cells.push_back(number(s.at.y()));
  cells.push_back(number(s.value));
  cells.push_back(whole(s.safe));
  cells.push_back(whole(s.expanders));
  cells.push_back(whole(next_x));
  cells.push_back(whole(next_y));
  cells.push_back(number(width));
  cells.push_back(number(s.certificate));
  cells.push_back(number(s.lipschitz));
  cells.push_back(number(s.travelled));
  cells.push_back(whole(s.unsafe_certified));
  cells.push_back(whole(s.unsafe_visits));
  return cells;
}

}  // namespace

std::vector<ColumnDoc> explore_columns() {
  return {
      {"step", "", "measurements after the first batch; row 0 is the state after that batch"},
      {"x", "cell", "row of the terrain at which was measured"},
      {"y", "cell", "column of the terrain at which was measured"},
      {"measurement", "", "value that was felt there"},
      {"safe_cells", "cell", "|S_t|, cells that the rules hold to be safe"},
      {"expander_cells", "cell", "|G_t|, cells that could make S_t grow"},
      {"next_x", "cell", "row of the cell chosen next; empty if there is none"},
      {"next_y", "cell", "column of the cell chosen next"},
      {"width", "", "u_t - l_t there"},
      {"certificate", "", "widest path over S_t of l_t - h from start to goal; empty until joined"},
      {"lipschitz", "1/cell", "Lipschitz constant in use"},
      {"travelled", "cell", "length of the way so far"},
      {"unsafe_certified", "cell", "cells of S_t whose true value is below the threshold"},
      {"unsafe_visits", "", "steps onto such cells so far"}};
}

Table explore_table(const terrain::ExploreResult& result,
                    const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "series";
  table.title = "Exploration, step by step";
  table.synthetic = synthetic;
  for (const ColumnDoc& doc : explore_columns()) {
    const bool number = doc.name == "x" || doc.name == "y" || doc.name == "measurement" ||
                        doc.name == "width" || doc.name == "certificate" ||
                        doc.name == "lipschitz" || doc.name == "travelled";
    table.columns.push_back(
        {doc.name, doc.name, doc.unit, number ? ColumnKind::number : ColumnKind::integer});
  }
  for (const terrain::ExploreStep& s : result.steps) {
    table.add_row(row_of(s));
  }
  return table;
}

Table path_table(const terrain::ExploreResult& result,
                 const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "path";
  table.title = "The robot's way";
  table.synthetic = synthetic;
  table.columns = {{"x", "x", "cell", ColumnKind::number}, {"y", "y", "cell", ColumnKind::number}};
  for (const terrain::Position& p : result.path) {
    table.add_row({number(p.x()), number(p.y())});
  }
  return table;
}

}  // namespace tcert
