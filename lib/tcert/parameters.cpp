#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tcert/parameters.hpp>

namespace tcert {
namespace {

constexpr double kMostLag = 1e5;  // in dead bands: a step is kept for each

enum class Bound { above_zero, not_negative };

void require(std::string_view name, double value, Bound bound) {
  const bool in_range = bound == Bound::above_zero ? value > 0.0 : value >= 0.0;
  if (in_range && std::isfinite(value)) {
    return;
  }
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  const auto length = static_cast<std::size_t>(end - text.data());
  throw std::invalid_argument(
      std::string(name) + " is " + std::string(text.data(), length) +
      (bound == Bound::above_zero ? "; it must be above 0" : "; it must not be negative"));
}

void require_count(std::string_view name, std::uint32_t value) {
  if (value < 2U || value > (1U << 28U)) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                "; it must be from 2 to 268435456");
  }
}

}  // namespace

void validate(const CertificateParameters& p) {
  require("side_angle_rad", p.side_angle_rad, Bound::not_negative);
  require("side_window_m", p.side_window_m, Bound::not_negative);
  require("travel_deadband_m", p.travel_deadband_m, Bound::above_zero);
  require("swept_cell_m", p.swept_cell_m, Bound::above_zero);
  require("least_obstacle_m", p.least_obstacle_m, Bound::not_negative);
  require("sharpest_corner_rad", p.sharpest_corner_rad, Bound::above_zero);
  if (p.sharpest_corner_rad > 0.5 * std::numbers::pi) {
    throw std::invalid_argument("sharpest_corner_rad must be at most pi/2");
  }
  require("swept_lag_m", p.swept_lag_m, Bound::above_zero);
  if (p.swept_lag_m > kMostLag * p.travel_deadband_m) {
    throw std::invalid_argument("swept_lag_m must be at most 100000 times travel_deadband_m");
  }
  require("curvature_window_m", p.curvature_window_m, Bound::above_zero);
  require("curvature_min_travel_m", p.curvature_min_travel_m, Bound::above_zero);
  require("min_curvature_per_m", p.min_curvature_per_m, Bound::above_zero);
  require("contact_spacing_m", p.contact_spacing_m, Bound::above_zero);
  require("contact_literal_spacing_m", p.contact_literal_spacing_m, Bound::above_zero);
  require("contact_window_m", p.contact_window_m, Bound::above_zero);
  require("contact_flatness", p.contact_flatness, Bound::not_negative);
  require("sigma_contact_m", p.sigma_contact_m, Bound::not_negative);
  require("contact_on_n", p.contact_on_n, Bound::above_zero);
  require("contact_off_n", p.contact_off_n, Bound::above_zero);
  if (p.contact_off_n > p.contact_on_n) {
    throw std::invalid_argument("contact_off_n must not be above contact_on_n");
  }
  require("contact_slack_m", p.contact_slack_m, Bound::not_negative);
  require("edge_length_m", p.edge_length_m, Bound::above_zero);
  require("merge_radius_m", p.merge_radius_m, Bound::above_zero);
  require("merge_angle_rad", p.merge_angle_rad, Bound::above_zero);
  require("reversal_m", p.reversal_m, Bound::above_zero);
  require("max_step_m", p.max_step_m, Bound::above_zero);
  require("memory_weight_m", p.memory_weight_m, Bound::not_negative);
  require("memory_cell_m", p.memory_cell_m, Bound::above_zero);
  require("memory_gain", p.memory_gain, Bound::not_negative);
  if (p.memory_gain > 1.0) {
    throw std::invalid_argument("memory_gain must lie in [0, 1]");
  }
  require("force_cap_n", p.force_cap_n, Bound::above_zero);
  require("memory_sigma_m", p.memory_sigma_m, Bound::above_zero);
  require("memory_half_life_s", p.memory_half_life_s, Bound::above_zero);
  require_count("max_nodes", p.max_nodes);
  require_count("max_edges", p.max_edges);
  require_count("max_memory_cells", p.max_memory_cells);
  require_count("max_swept_cells", p.max_swept_cells);
}

}  // namespace tcert
