#include "reports/terrain/explore_table.hpp"

#include <fmt/format.h>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

using terrain::ExploreStep;

ColumnsOf<terrain::Cell> cell_columns() {
  return ColumnsOf<terrain::Cell>()
      .integer("next_x", "next_x", &terrain::Cell::x)
      .integer("next_y", "next_y", &terrain::Cell::y);
}

/// What is known without the terrain itself.
ColumnsOf<ExploreStep> felt_columns() {
  return ColumnsOf<ExploreStep>()
      .integer("step", "step", &ExploreStep::step)
      .fixed("x", "x", "cell", 3, [](auto& s) { return s.at.x(); })
      .fixed("y", "y", "cell", 3, [](auto& s) { return s.at.y(); })
      .fixed("measurement", "measurement", &ExploreStep::value)
      .integer("safe_cells", "safe_cells", &ExploreStep::safe)
      .integer("expander_cells", "expander_cells", &ExploreStep::expanders)
      .part(cell_columns(), &ExploreStep::next)
      .fixed("width", "width", [](auto& s) { return when(s.next.has_value(), s.upper - s.lower); })
      .fixed("certificate", "certificate", &ExploreStep::certificate)
      .fixed("lipschitz", "lipschitz", "1/cell", 3, &ExploreStep::lipschitz)
      .fixed("travelled", "travelled", "cell", 3, &ExploreStep::travelled);
}

ColumnsOf<ExploreStep> step_columns() {
  return felt_columns()
      .integer("unsafe_certified", "unsafe_certified", &ExploreStep::unsafe_certified)
      .integer("unsafe_visits", "unsafe_visits", &ExploreStep::unsafe_visits);
}

}  // namespace

Table explore_table(const terrain::ExploreResult& result,
                    const std::optional<SyntheticLabel>& synthetic) {
  Table table = step_columns().table("series", "Exploration, step by step", result.steps);
  table.synthetic = synthetic;
  return table;
}

Table path_table(const std::vector<terrain::Position>& path,
                 const std::optional<SyntheticLabel>& synthetic,
                 const std::optional<MapFrame>& map) {
  ColumnsOf<terrain::Position> columns;
  columns.fixed("x", "x", "cell", 3, [](auto& p) { return p.x(); })
      .fixed("y", "y", "cell", 3, [](auto& p) { return p.y(); });
  if (map) {
    columns.fixed("map_x", "map_x", "m", 3, [&](auto& p) { return map->first_of(p.x(), p.y()); })
        .fixed("map_y", "map_y", "m", 3, [&](auto& p) { return map->second_of(p.x(), p.y()); });
  }
  Table table = columns.table("path", "The robot's way", path);
  table.synthetic = synthetic;
  return table;
}

Table live_table(const std::vector<LiveRow>& rows, const std::optional<SyntheticLabel>& synthetic) {
  const auto way_of = [](const LiveRow& row) {
    std::string text;
    for (const terrain::Position& p : row.way) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ";", p.x(), p.y());
    }
    return text;
  };
  Table table =
      ColumnsOf<LiveRow>()
          .part(felt_columns(), [](const LiveRow& row) { return std::optional(row.step); })
          .text("way", "way", way_of)
          .text("end",
                "end",
                [](const LiveRow& row) { return row.end ? std::string(to_string(*row.end)) : ""; })
          .table("series", "Exploration, step by step", rows);
  table.synthetic = synthetic;
  return table;
}

Table measurement_table(const std::vector<TakenMeasurement>& measurements,
                        const std::optional<SyntheticLabel>& synthetic) {
  using Taken = TakenMeasurement;
  Table table = ColumnsOf<Taken>()
                    .number("x", "x", [](auto& m) { return m.measurement.at.x(); })
                    .number("y", "y", [](auto& m) { return m.measurement.at.y(); })
                    .number("value", "value", [](auto& m) { return m.measurement.value; })
                    .integer("plan", "plan", [](auto& m) { return std::int64_t{m.plan ? 1 : 0}; })
                    .table("measurements", "What was measured", measurements);
  table.synthetic = synthetic;
  return table;
}

}  // namespace tcert
