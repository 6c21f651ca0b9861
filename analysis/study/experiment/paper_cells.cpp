#include "analysis/study/experiment/paper_cells.hpp"

#include <string>
#include <utility>

namespace tcert::study {
namespace {

using Overrides = std::vector<std::pair<std::string, std::string>>;

}  // namespace

std::vector<Cell> ablation_cells() {
  const std::vector<std::pair<std::string, Overrides>> single = {
      {"A1", {{"memory_weight_m", "0"}}},
      {"A2", {{"unknown", "free"}}},
      {"A3", {{"curvature", "none"}}},
  };
  std::vector<Cell> cells;
  for (const auto& members :
       std::vector<std::vector<std::size_t>>{{0}, {1}, {2}, {0, 1}, {0, 2}, {1, 2}, {0, 1, 2}}) {
    Cell cell;
    for (const std::size_t member : members) {
      cell.name += (cell.name.empty() ? "" : "+") + single[member].first;
      cell.overrides.insert(
          cell.overrides.end(), single[member].second.begin(), single[member].second.end());
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

Cell footing_ablation() { return {"A4", {{"footing", "ignored"}}}; }

std::vector<Cell> sensitivity_cells() {
  const std::vector<GridAxis> choices = {
      {"tick_s", {"0.05", "0.2"}},
      {"median_samples", {"1", "5"}},
      {"max_hold_s", {"0.25", "1"}},
      {"clearance", {"radial"}},
      {"curvature", {"contact", "contact_literal", "none"}},
      {"unknown", {"free"}},
      {"side_angle_rad", {"0.35", "0.79"}},
      {"side_window_m", {"0.1", "0.225", "0.9"}},
      {"travel_deadband_m", {"0.005", "0.02"}},
      {"curvature_window_m", {"0.15", "0.5"}},
      {"curvature_min_travel_m", {"0.05", "0.2"}},
      {"edge_length_m", {"0.15", "0.5"}},
      {"merge_radius_m", {"0.1", "0.25"}},
      {"merge_angle_rad", {"0.17", "0.52"}},
      {"reversal_m", {"0.03", "0.1"}},
      {"max_step_m", {"0.15", "0.5"}},
      {"memory_weight_m", {"0", "0.025", "0.1", "0.2"}},
      {"memory_gain", {"0.05", "0.2"}},
      {"memory_sigma_m", {"0.1", "0.25"}},
      {"memory_half_life_s", {"5", "60"}},
      {"early_window", {"landmark", "fraction"}},
      {"early_time_s", {"10", "20"}},
      {"early_distance_m", {"3", "8"}},
      {"early_distance_cap_s", {"30", "120"}},
      {"early_min_ticks", {"5", "30"}},
      {"early_quantile", {"0", "0.05", "0.25", "0.5"}},
      {"early_dwell_speed_mps", {"0.01", "0.05"}},
      {"early_dwell_window_s", {"0.3", "1"}},
  };
  std::vector<Cell> cells;
  for (const GridAxis& choice : choices) {
    const std::vector<Cell> of_choice = grid_cells(std::vector{choice});
    cells.insert(cells.end(), of_choice.begin(), of_choice.end());
  }
  return cells;
}

}  // namespace tcert::study
