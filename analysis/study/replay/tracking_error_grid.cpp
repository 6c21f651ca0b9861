#include "analysis/study/replay/tracking_error_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

namespace tcert::study {
namespace {

const std::vector<double>& finite_column(const table::DataTable& table, const std::string& name) {
  const table::DataColumn* column = table.find(name);
  if (column == nullptr || column->is_text) {
    throw std::invalid_argument("tracking error: needs a column of numbers '" + name + "'");
  }
  for (const double value : column->numbers) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument("tracking error: a cell of '" + name + "' is missing");
    }
  }
  return column->numbers;
}

std::vector<double> knots_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t place_of(const std::vector<double>& knots, double value) {
  return static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), value) -
                                  knots.begin());
}

}  // namespace

TrackingErrorGrid tracking_error_grid(const table::DataTable& table) {
  const bool has_left = table.find("speed_left_mps") != nullptr;
  const auto& speed = finite_column(table, "speed_mps");
  const auto& second = finite_column(table, has_left ? "speed_left_mps" : "acceleration_mps2");
  const auto& disturbance = finite_column(table, "disturbance");
  const auto& radius = finite_column(table, "radius_m");
  TrackingErrorGrid grid{knots_of(speed), {}, knots_of(disturbance), {}};
  std::vector<double>& axis = has_left ? grid.speed_left_mps : grid.acceleration_mps2;
  axis = knots_of(second);
  const std::size_t knots = grid.speed_mps.size() * axis.size() * grid.disturbance.size();
  if (has_left) {
    grid.hold_s.assign(axis.size(), std::numeric_limits<double>::quiet_NaN());
    const auto& hold = finite_column(table, "hold_s");
    for (std::size_t i = 0; i < table.rows; ++i) {
      double& of_speed = grid.hold_s[place_of(axis, second[i])];
      if (!std::isnan(of_speed) && of_speed != hold[i]) {
        throw std::invalid_argument("tracking error: row " + std::to_string(i + 1) +
                                    " has another hold_s for the same speed_left_mps");
      }
      of_speed = hold[i];
    }
  }
  grid.radius_m.assign(knots, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < table.rows; ++i) {
    const std::size_t row =
        place_of(grid.speed_mps, speed[i]) * axis.size() + place_of(axis, second[i]);
    double& knot =
        grid.radius_m[row * grid.disturbance.size() + place_of(grid.disturbance, disturbance[i])];
    if (!std::isnan(knot)) {
      throw std::invalid_argument("tracking error: row " + std::to_string(i + 1) +
                                  " repeats a knot of the grid");
    }
    knot = radius[i];
  }
  if (table.rows != knots) {
    throw std::invalid_argument("tracking error: " + std::to_string(knots - table.rows) +
                                " knots of the grid have no row");
  }
  return grid;
}

}  // namespace tcert::study
