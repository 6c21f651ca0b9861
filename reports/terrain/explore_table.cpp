#include "reports/terrain/explore_table.hpp"

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using terrain::ExploreStep;

ColumnsOf<terrain::Cell> cell_columns() {
  return ColumnsOf<terrain::Cell>()
      .integer("next_x", "next_x", "cell", &terrain::Cell::x)
      .doc("row of the cell chosen next; empty if there is none")
      .integer("next_y", "next_y", "cell", &terrain::Cell::y)
      .doc("column of the cell chosen next");
}

ColumnsOf<ExploreStep> step_columns() {
  return ColumnsOf<ExploreStep>()
      .integer("step", "step", &ExploreStep::step)
      .doc("measurements after the first batch; row 0 is the state after that batch")
      .fixed("x", "x", "cell", 3, [](auto& s) { return s.at.x(); })
      .doc("row of the terrain at which was measured")
      .fixed("y", "y", "cell", 3, [](auto& s) { return s.at.y(); })
      .doc("column of the terrain at which was measured")
      .fixed("measurement", "measurement", &ExploreStep::value)
      .doc("value that was felt there")
      .integer("safe_cells", "safe_cells", "cell", &ExploreStep::safe)
      .doc("|S_t|, cells that the rules hold to be safe")
      .integer("expander_cells", "expander_cells", "cell", &ExploreStep::expanders)
      .doc("|G_t|, cells that could make S_t grow")
      .part(cell_columns(), &ExploreStep::next)
      .fixed("width", "width", [](auto& s) { return when(s.next.has_value(), s.upper - s.lower); })
      .doc("u_t - l_t there")
      .fixed("certificate", "certificate", &ExploreStep::certificate)
      .doc("widest path over S_t of l_t - h from start to goal; empty until joined")
      .fixed("lipschitz", "lipschitz", "1/cell", 3, &ExploreStep::lipschitz)
      .doc("Lipschitz constant in use")
      .fixed("travelled", "travelled", "cell", 3, &ExploreStep::travelled)
      .doc("length of the way so far")
      .integer("unsafe_certified", "unsafe_certified", "cell", &ExploreStep::unsafe_certified)
      .doc("cells of S_t whose true value is below the threshold")
      .integer("unsafe_visits", "unsafe_visits", &ExploreStep::unsafe_visits)
      .doc("steps onto such cells so far");
}

}  // namespace

std::vector<ColumnDoc> explore_columns() { return step_columns().docs(); }

Table explore_table(const terrain::ExploreResult& result,
                    const std::optional<SyntheticLabel>& synthetic) {
  Table table = step_columns().table("series", "Exploration, step by step", result.steps);
  table.synthetic = synthetic;
  return table;
}

Table path_table(const terrain::ExploreResult& result,
                 const std::optional<SyntheticLabel>& synthetic) {
  using terrain::Position;
  Table table = ColumnsOf<Position>()
                    .fixed("x", "x", "cell", 3, [](auto& p) { return p.x(); })
                    .fixed("y", "y", "cell", 3, [](auto& p) { return p.y(); })
                    .table("path", "The robot's way", result.path);
  table.synthetic = synthetic;
  return table;
}

}  // namespace tcert
