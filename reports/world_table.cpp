#include "reports/world_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

constexpr int kWorldDecimals = 4;

struct KnownWorld {
  const World& world;
  const study::Truth& truth;

  [[nodiscard]] bool is_connected() const { return std::isfinite(truth.clearance.clearance_m); }
};

ColumnsOf<KnownWorld> world_columns() {
  const auto bottleneck =
      ColumnsOf<Point>()
          .fixed("bottleneck_x_m", "bottleneck x", "m", kWorldDecimals, &Point::x_m)
          .fixed("bottleneck_y_m", "y", "m", kWorldDecimals, &Point::y_m);
  return ColumnsOf<KnownWorld>()
      .text("world", "world", [](auto& r) { return r.world.name; })
      .fixed(
          "T_lower_m", "T at least", "m", kWorldDecimals, [](auto& r) { return r.truth.lower_m; })
      .fixed("T_upper_m", "T at most", "m", kWorldDecimals, [](auto& r) { return r.truth.upper_m; })
      .fixed("clearance_m",
             "clearance",
             "m",
             kWorldDecimals,
             [](auto& r) { return r.truth.clearance.clearance_m; })
      .fixed("clearance_error_m",
             "error at most",
             "m",
             kWorldDecimals,
             [](auto& r) { return r.truth.clearance.upper_m - r.truth.clearance.clearance_m; })
      .integer("connected", "connected", &KnownWorld::is_connected)
      .part(bottleneck, [](auto& r) { return r.truth.clearance.bottleneck; })
      .integer("obstacles", "obstacles", [](auto& r) { return r.world.obstacles.size(); });
}

}  // namespace

Table world_table(const Robot& robot, const study::TruthOptions& options) {
  Table table = world_columns().table("worlds", "Truth of known worlds");
  table.footnotes = {
      fmt::format("T = sup over paths from S to G of min({}, turn radius - {} m).",
                  options.convention == study::SlackConvention::width
                      ? fmt::format("2 clearance - {} m", robot.body_width_m)
                      : fmt::format("clearance - {} m", 0.5 * robot.body_width_m),
                  robot.min_turn_radius_m),
      options.curvature
          ? std::string("At least: of a path with that turn radius. At most: ") +
                (options.turn_cell_m > 0.0
                     ? fmt::format("no way was left that turns no more sharply, in cells of {} m.",
                                   options.turn_cell_m)
                     : "of the clearance alone.")
          : "The turn radius is left out: both are of the clearance alone.",
      "Clearance: of the widest path; exact for discs (error 0), else from a grid. Connected: 1 if "
      "there is a path of a point, 0 if none was found; then T at least is not stated, and on a "
      "grid "
      "T at most is what its error leaves open."};
  return table;
}

std::vector<TableCell> world_row(const World& world, const study::Truth& truth) {
  return world_columns().row({world, truth});
}

}  // namespace tcert
