#pragma once
/// \file
/// Which columns of a series the page shows, and how they are read.

#include <optional>
#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <vector>

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

/// The columns that read_page_series() reads, in the order of its values; the time is apart.
[[nodiscard]] const std::vector<std::string>& page_series_columns();

/// The columns of a series file that the page shows. Empty iff the file cannot be used; then
/// `problem` says why.
[[nodiscard]] std::optional<table::NumberTable> read_page_series(const table::Bytes& bytes,
                                                                 const std::string& file,
                                                                 std::string& problem);

/// A column of a series file; NaN if it has none.
[[nodiscard]] std::vector<double> series_column(const table::NumberTable& series,
                                                std::string_view name);

/// What the page shows as a column.
[[nodiscard]] std::vector<double> page_column(const table::NumberTable& series,
                                              std::string_view name);

}  // namespace tcert
