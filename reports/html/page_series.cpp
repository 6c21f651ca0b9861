#include "reports/html/page_series.hpp"

#include <table/not_a_number.hpp>

#include <cmath>
#include <cstdint>

namespace tcert {
namespace {

constexpr double kSpeedWindowS = 1.0;

table::NumberOptions series_options() {
  table::NumberOptions options;
  for (const std::string& name : page_series_columns()) {
    const bool required = name != "gated_speed_mps" && name != "left_m" && name != "right_m";
    options.columns.push_back({name, required, true});
  }
  return options;
}

double seconds(std::int64_t time_ns) { return static_cast<double>(time_ns) * 1e-9; }

std::vector<double> speeds(const table::NumberTable& series) {
  const std::vector<double> travel = series_column(series, "travel_m");
  std::vector<double> speed(series.rows(), table::kNaN);
  std::size_t from = 0;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    while (seconds(series.time_ns[i] - series.time_ns[from]) > kSpeedWindowS) {
      ++from;
    }
    const double span = seconds(series.time_ns[i] - series.time_ns[from]);
    // A gap of more than the window leaves nothing to compare with.
    if (span > kSpeedWindowS / 2.0) {
      speed[i] = std::abs(travel[i] - travel[from]) / span;
    }
  }
  return speed;
}

}  // namespace

const std::vector<PageColumn>& page_columns() {
  static const std::vector<PageColumn> columns = {
      {"time_s", "time", "s", 2, 1000},
      {"x_m", "x", "m", 3, 1000},
      {"y_m", "y", "m", 3, 1000},
      {"yaw_rad", "yaw", "rad", 2, 1000},
      {"width_m", "width w_t", "m", 3, 1000},
      {"certificate_m", "certificate T_t", "m", 4, 10'000, 0, true},
      {"corridor_value_m", "corridor value V_t", "m", 4, 10'000, 0, true},
      {"edge_margin_m", "edge margin", "m", 4, 10'000, 0},
      {"margin_m", "tick margin m_t", "m", 4, 10'000, 0},
      {"speed_law_mps", "speed law", "m/s", 3, 1000, 1},
      {"speed_mps", "speed, mean of the last second", "m/s", 3, 1000, 1},
      {"gated_speed_mps", "gated speed", "m/s", 3, 1000, 1},
      {"contacts", "rays in contact", "", 0, 1, 2, true},
      {"memory", "contact memory", "", 3, 1000},
  };
  return columns;
}

const std::vector<PagePanel>& page_panels() {
  static const std::vector<PagePanel> panels = {
      {"Margin", "m"}, {"Speed", "m/s"}, {"Rays in contact", ""}};
  return panels;
}

const std::vector<std::string>& page_series_columns() {
  static const std::vector<std::string> columns = {"x_m",
                                                   "y_m",
                                                   "yaw_rad",
                                                   "width_m",
                                                   "margin_m",
                                                   "edge_margin_m",
                                                   "corridor_value_m",
                                                   "certificate_m",
                                                   "speed_law_mps",
                                                   "gated_speed_mps",
                                                   "contacts",
                                                   "memory",
                                                   "travel_m",
                                                   "issued",
                                                   "left_m",
                                                   "right_m"};
  return columns;
}

std::optional<table::NumberTable> read_page_series(const table::Bytes& bytes,
                                                   const std::string& file,
                                                   std::string& problem) {
  table::CsvOptions csv;
  csv.file = file;
  table::DiagnosticGroups problems;
  auto series = table::read_numbers(bytes, csv, series_options(), problems);
  const std::vector<table::Diagnostic> found = problems.take();
  if (!series || series->rows() == 0 || table::has_error(found)) {
    problem = found.empty() ? file + ": no ticks" : table::to_string(found.front());
    return std::nullopt;
  }
  return series;
}

std::vector<double> series_column(const table::NumberTable& series, std::string_view name) {
  std::vector<double> values(series.rows(), table::kNaN);
  for (std::size_t c = 0; c < page_series_columns().size(); ++c) {
    if (page_series_columns()[c] == name && series.present[c] != 0) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = series.at(i, c);
      }
    }
  }
  return values;
}

std::vector<double> page_column(const table::NumberTable& series, std::string_view name) {
  if (name == "time_s") {
    std::vector<double> values;
    for (const std::int64_t time_ns : series.time_ns) {
      values.push_back(seconds(time_ns - series.time_ns.front()));  // A log may count from 1970.
    }
    return values;
  }
  return name == "speed_mps" ? speeds(series) : series_column(series, name);
}

}  // namespace tcert
