#include "reports/edges_table.hpp"

#include <string>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

struct NumberedEdge {
  std::size_t number;
  const Edge& edge;
  const std::vector<Node>& nodes;
  const witness::EdgePaths* proofs;

  [[nodiscard]] std::uint32_t end(std::size_t which) const { return edge.ends[which].node; }
  [[nodiscard]] Point position(std::size_t which) const { return nodes[end(which)].pose.position; }
};

/// Empty where there is no path.
TableCell proved_cell(const NumberedEdge& row) {
  const auto& path = row.proofs->paths[row.number];
  return path ? TableCell{Number{path->checked.margin_m, kColumnDecimals}} : TableCell{};
}

/// How a value is spread over the ticks of the best pass: <name>_min_m ... <name>_max_m.
void add_profile(ColumnsOf<NumberedEdge>& columns,
                 const std::string& name,
                 const std::string& heading,
                 const char* unit,
                 Profile Pass::*profile,
                 const std::string& what) {
  struct Level {
    const char* name;
    double Profile::*value;
    const char* words;
  };
  for (const Level& level : {Level{"min", &Profile::min, "least "},
                             Level{"p05", &Profile::p05, "5 % quantile of the "},
                             Level{"p50", &Profile::p50, "median "},
                             Level{"p95", &Profile::p95, "95 % quantile of the "},
                             Level{"max", &Profile::max, "largest "}}) {
    columns
        .fixed(name + '_' + level.name + '_' + unit,
               heading + ' ' + level.name,
               unit,
               3,
               [profile, value = level.value](auto& r) { return r.edge.pass.*profile.*value; })
        .doc(level.words + what);
  }
}

ColumnsOf<NumberedEdge> edge_columns(bool has_proofs) {
  ColumnsOf<NumberedEdge> columns;
  columns.integer("edge", "edge", &NumberedEdge::number)
      .doc("number of the edge, from 0")
      .integer("a", "a", [](auto& r) { return r.end(0); })
      .doc("node at one end")
      .fixed("a_x_m", "a x", "m", 3, [](auto& r) { return r.position(0).x_m; })
      .doc("where it lies")
      .fixed("a_y_m", "a y", "m", 3, [](auto& r) { return r.position(0).y_m; })
      .doc("the same")
      .integer("b", "b", [](auto& r) { return r.end(1); })
      .doc("node at the other end")
      .fixed("b_x_m", "b x", "m", 3, [](auto& r) { return r.position(1).x_m; })
      .doc("where it lies")
      .fixed("b_y_m", "b y", "m", 3, [](auto& r) { return r.position(1).y_m; })
      .doc("the same")
      .fixed("margin_m", "margin", "m", 3, [](auto& r) { return r.edge.pass.margin_m; })
      .doc("smallest tick margin of the best pass along it")
      .fixed(
          "narrowest_x_m", "x", "m", 3, [](auto& r) { return r.edge.pass.narrowest.position.x_m; })
      .doc("pose of the tick with that margin")
      .fixed(
          "narrowest_y_m", "y", "m", 3, [](auto& r) { return r.edge.pass.narrowest.position.y_m; })
      .doc("the same")
      .fixed("narrowest_yaw_rad",
             "yaw",
             "rad",
             3,
             [](auto& r) { return r.edge.pass.narrowest.yaw_rad; })
      .doc("the same")
      .fixed("width_m", "width", "m", 3, [](auto& r) { return r.edge.pass.width_m; })
      .doc("width there")
      .fixed(
          "turn_radius_m", "turn radius", "m", 3, [](auto& r) { return r.edge.pass.turn_radius_m; })
      .doc("turn radius there");
  add_profile(columns, "width", "width", "m", &Pass::width, "free width over that pass");
  add_profile(
      columns, "turn_radius", "turn radius", "m", &Pass::turn_radius, "turn radius over that pass");
  if (has_proofs) {
    columns.add(fixed_column("proved_m", "proved", "m"), proved_cell)
        .doc(
            "margin of the path along it that was found and checked (--witness-edges); empty if "
            "there is none");
  }
  return columns;
}

}  // namespace

std::string edges_csv(const study::TrialSeries& series,
                      const witness::EdgePaths* proofs,
                      const std::optional<SyntheticLabel>& synthetic) {
  const ColumnsOf<NumberedEdge> columns = edge_columns(proofs != nullptr);
  Table table = columns.table("edges", "");
  table.synthetic = synthetic;
  for (std::size_t e = 0; e < series.edges.size(); ++e) {
    table.add_row(columns.row({e, series.edges[e], series.nodes, proofs}));
  }
  return render(table, TableFormat::csv);
}

std::vector<ColumnDoc> edge_column_docs() {
  std::vector<ColumnDoc> docs = edge_columns(true).docs();
  docs.push_back(synthetic_seed_doc());
  return docs;
}

}  // namespace tcert
