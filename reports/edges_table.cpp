#include "reports/edges_table.hpp"

#include <array>
#include <string_view>

namespace tcert {
namespace {

struct Described {
  Column column;
  std::string_view doc;
};

Column integer(std::string name) { return {name, name, "", ColumnKind::integer}; }
Column number(std::string name, std::string unit) {
  return {name, name, std::move(unit), ColumnKind::number};
}

std::vector<Described> columns() {
  return {{integer("edge"), "number of the edge, from 0"},
          {integer("a"), "node at one end"},
          {number("a_x_m", "m"), "where it lies"},
          {number("a_y_m", "m"), "the same"},
          {integer("b"), "node at the other end"},
          {number("b_x_m", "m"), "where it lies"},
          {number("b_y_m", "m"), "the same"},
          {number("margin_m", "m"), "smallest tick margin of the best pass along it"},
          {number("narrowest_x_m", "m"), "pose of the tick with that margin"},
          {number("narrowest_y_m", "m"), "the same"},
          {number("narrowest_yaw_rad", "rad"), "the same"},
          {number("width_m", "m"), "width there"},
          {number("turn_radius_m", "m"), "turn radius there"}};
}

std::vector<TableCell> row_of(std::size_t index, const Edge& edge, const std::vector<Node>& nodes) {
  const std::uint32_t a = edge.ends[0].node;
  const std::uint32_t b = edge.ends[1].node;
  const Point from = nodes[a].pose.position;
  const Point to = nodes[b].pose.position;
  return {static_cast<std::int64_t>(index),
          std::int64_t{a},
          Number{from.x_m},
          Number{from.y_m},
          std::int64_t{b},
          Number{to.x_m},
          Number{to.y_m},
          Number{edge.pass.margin_m},
          Number{edge.pass.narrowest.position.x_m},
          Number{edge.pass.narrowest.position.y_m},
          Number{edge.pass.narrowest.yaw_rad},
          Number{edge.pass.width_m},
          Number{edge.pass.turn_radius_m}};
}

}  // namespace

std::string edges_csv(const study::TrialSeries& series,
                      const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "edges";
  table.synthetic = synthetic;
  for (const Described& one : columns()) {
    table.columns.push_back(one.column);
  }
  for (std::size_t e = 0; e < series.edges.size(); ++e) {
    table.add_row(row_of(e, series.edges[e], series.nodes));
  }
  return render(table, TableFormat::csv);
}

std::vector<ColumnDoc> edge_column_docs() {
  std::vector<ColumnDoc> docs;
  for (const Described& one : columns()) {
    docs.push_back({one.column.name, one.column.unit, std::string(one.doc)});
  }
  docs.push_back({"synthetic_seed", "", "seed of synthetic data; not in real data"});
  return docs;
}

}  // namespace tcert
