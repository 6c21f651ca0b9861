#pragma once
/// \file
/// One trial as the page's viewer reads it: its series, fewer ticks of it, and its map.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

/// How a column of the series is shown.
struct PageColumn {
  std::string_view name;
  std::string_view heading;
  std::string_view unit;
  int decimals = 3;    ///< In the read-out.
  int scale = 10'000;  ///< Values are carried as whole numbers of 1/scale.
  int panel = -1;      ///< Of the time series; -1: in the read-out only.
  bool steps = false;  ///< Holds until the next tick.
};

/// The columns, in the order of the read-out. `speed_mps` is made here: the way of the last second
/// by its time, from travel_m.
[[nodiscard]] const std::vector<PageColumn>& page_columns();

/// Titles and units of the panels that PageColumn::panel counts.
struct PagePanel {
  std::string_view title;
  std::string_view unit;
};
[[nodiscard]] const std::vector<PagePanel>& page_panels();

/// How ticks were chosen, for the reader.
[[nodiscard]] std::string_view decimation_rule() noexcept;

/// An edge of the corridor graph, drawn straight between its nodes.
struct MapEdge {
  Point a;
  Point b;
  double margin_m = 0.0;
};

struct TrialMap {
  std::vector<MapEdge> edges;
  std::optional<Point> bottleneck;
  bool felt = false;  ///< Show what the rays proved free on either side, where no world is known.
  std::string note;   ///< What is not shown, and why; or empty.
};

/// The columns that read_page_series() reads, in the order of its values; the time is apart.
[[nodiscard]] const std::vector<std::string>& page_series_columns();

/// The columns of a series file that the page shows. Empty iff the file cannot be used; then
/// `problem` says why.
[[nodiscard]] std::optional<table::NumberTable> read_page_series(const table::Bytes& bytes,
                                                                 const std::string& file,
                                                                 std::string& problem);

/// packed() JSON of a trial, at most `limit` ticks of it (kept_ticks()). The place of issuance is
/// the first tick with issued = 1; the extreme ticks of every column are exact to 1/scale. \pre
/// `series` is of read_page_series() and has a row.
[[nodiscard]] std::string trial_block(const table::NumberTable& series,
                                      const TrialMap& map,
                                      const std::string& facts,
                                      std::size_t limit);

/// packed() JSON of a world: what is not free, and S and G.
[[nodiscard]] std::string world_block(const World& world);

}  // namespace tcert
