#include "reports/world_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tcert {

Table world_table(const Robot& robot, const study::TruthOptions& options) {
  Table table;
  table.name = "worlds";
  table.title = "Truth of known worlds";
  const auto metres = [](std::string name, std::string heading) {
    return Column{std::move(name), std::move(heading), "m", ColumnKind::number, 4};
  };
  table.columns = {{"world", "world", "", ColumnKind::text},
                   metres("T_lower_m", "T at least"),
                   metres("T_upper_m", "T at most"),
                   metres("clearance_m", "clearance"),
                   metres("clearance_error_m", "error at most"),
                   {"connected", "connected", "", ColumnKind::integer},
                   metres("bottleneck_x_m", "bottleneck x"),
                   metres("bottleneck_y_m", "y"),
                   {"obstacles", "obstacles", "", ColumnKind::integer}};
  table.footnotes = {
      fmt::format("T = sup over paths from S to G of min({}, turn radius - {} m).",
                  options.convention == study::SlackConvention::width
                      ? fmt::format("2 clearance - {} m", robot.body_width_m)
                      : fmt::format("clearance - {} m", 0.5 * robot.body_width_m),
                  robot.min_turn_radius_m),
      options.curvature
          ? "At least: of a path with that turn radius. At most: of the clearance alone."
          : "The turn radius is left out: both are of the clearance alone.",
      "Clearance: of the widest path; exact for discs (error 0), else from a grid. Connected: 1 if "
      "there is a path of a point, 0 if none was found; then nothing is stated, never 0."};
  return table;
}

std::vector<TableCell> world_row(const World& world, const study::Truth& truth) {
  const study::ClearanceValue& clearance = truth.clearance;
  const bool connected = std::isfinite(clearance.clearance_m);
  std::vector<TableCell> cells = {
      world.name,
      Number{truth.lower_m},
      Number{truth.upper_m},
      Number{clearance.clearance_m},
      Number{connected ? clearance.upper_m - clearance.clearance_m : std::nan("")},
      std::int64_t{connected ? 1 : 0}};
  if (clearance.bottleneck) {
    cells.emplace_back(Number{clearance.bottleneck->x_m});
    cells.emplace_back(Number{clearance.bottleneck->y_m});
  } else {
    cells.insert(cells.end(), 2, TableCell{});
  }
  cells.emplace_back(static_cast<std::int64_t>(world.obstacles.size()));
  return cells;
}

}  // namespace tcert
