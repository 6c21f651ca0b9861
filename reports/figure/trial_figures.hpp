#pragma once
/// \file
/// The figures of one trial: its margins and speed over time, and its map.

#include <optional>
#include <string>
#include <table/data_table.hpp>
#include <vector>

#include "datasets/world.hpp"
#include "reports/figure/figure.hpp"

namespace tcert {

/// What is drawn of a trial. Tables are as `certify` writes them.
struct TrialPicture {
  std::string trial_id;
  table::DataTable series;                ///< series/<trial_id>.csv
  std::optional<table::DataTable> edges;  ///< edges/<trial_id>.csv
  std::optional<World> world;  ///< Where it is known; else the map has what the rays felt.
  std::optional<double> bottleneck_x_m;
  std::optional<double> bottleneck_y_m;
  std::optional<double> issued_s;
  std::optional<SyntheticLabel> synthetic;
};

/// Seconds since the first tick, of each row: a log may count from 1970.
[[nodiscard]] std::vector<double> trial_times(const table::DataTable& series);

/// T_t, V_t, the edge margin and the tick margin over time since the first tick; below it the
/// speed, measured over the last second and as the law allows. Empty if the series has no value.
[[nodiscard]] std::optional<Figure> trial_series_figure(const TrialPicture& trial);

/// Course or what the rays felt, odometry, corridor graph by edge margin, bottleneck, place of
/// issuance. Empty without a pose.
[[nodiscard]] std::optional<Figure> trial_map_figure(const TrialPicture& trial);

}  // namespace tcert
