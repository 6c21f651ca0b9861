#include "reports/series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace tcert {
namespace {

constexpr double kMinusInfinity = -std::numeric_limits<double>::infinity();

Tick tick_at(std::int64_t time_ns) { return {time_ns, {{1.5, -0.25}, 0.1}, {}, false, false}; }

CertifiedTick certified_tick() {
  CertifiedTick tick;
  tick.travel_m = 2.0;
  tick.left_m = 0.5;
  tick.right_m = 0.25;
  tick.width_m = 0.75;
  tick.turn_radius_m = 1000.0;
  tick.margin_m = 0.1;
  tick.edge_margin_m = 0.05;
  tick.corridor_value_m = 0.04;
  tick.certificate_m = kMinusInfinity;
  tick.nodes = 3;
  tick.edges = 2;
  return tick;
}

TEST(SeriesRow, HasOneCellAColumn) {
  const SeriesFormat format;
  std::string row;
  append_series_row(row, tick_at(1'500'000'001), certified_tick(), {}, format);
  // Speed law: 0.08 + (0.22 - 0.08) / 2 at beta 10 and margin 0.1, one ulp above 0.15 in binary.
  EXPECT_EQ(row,
            "1.500000001,1.5,-0.25,0.1,2,0.5,0.25,0.75,1000,0.1,0.05,0,0.04,,0.04,0."
            "15000000000000002,0,0,3,2,,0\n");
  const std::string header = series_header(format, {});
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(header.begin(), header.end(), ','));
}

TEST(SeriesRow, LeavesTheUnknownEmpty) {
  CertifiedTick certified;
  certified.corridor_value_m = kMinusInfinity;
  certified.certificate_m = kMinusInfinity;
  certified.flags = flag_stale | flag_goal_reached;
  std::string row;
  append_series_row(row, tick_at(0), certified, {}, {});
  EXPECT_EQ(row, "0,1.5,-0.25,0.1,0,,,,,,,0,,,,,0,0,0,0,stale+goal_reached,0\n");
}

TEST(SeriesRow, CarriesRayMarginsAndTheSyntheticLabel) {
  Robot robot;
  robot.rays = {{"left", {}, 0.0, 1.0, RayKind::range, {}},
                {"right", {}, 0.0, 1.0, RayKind::range, {}}};
  SeriesFormat format;
  format.ray_margins = true;
  format.synthetic = SyntheticLabel{5};
  EXPECT_NE(
      series_header(format, robot).find(",issued,left_margin_m,right_margin_m,synthetic_seed\n"),
      std::string::npos);
  const std::array<double, 2> margins = {0.25, kMissing};
  std::string row;
  append_series_row(row, tick_at(0), certified_tick(), margins, format);
  EXPECT_NE(row.find(",0,0.25,,5\n"), std::string::npos) << row;
}

}  // namespace
}  // namespace tcert
