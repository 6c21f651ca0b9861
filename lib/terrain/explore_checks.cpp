#include <cmath>
#include <stdexcept>
#include <string>
#include <terrain/components.hpp>
#include <terrain/explore_checks.hpp>
#include <terrain/limits.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] std::string text_of(Cell c) {
  return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
}

void require_inside(const Grid& grid, const CellSet& blocked, Cell c, const std::string& who) {
  if (!grid.contains(c)) {
    throw std::invalid_argument("the " + who + " " + text_of(c) + " lies outside the terrain of " +
                                std::to_string(grid.rows) + " x " + std::to_string(grid.columns) +
                                " cells");
  }
  if (!blocked.empty() && blocked[grid.index(c)] != 0) {
    throw std::invalid_argument("the " + who + " " + text_of(c) +
                                " lies in a physical obstacle or a gap of the terrain");
  }
}

}  // namespace

void require_valid(const Grid& grid, const ExploreSetup& setup) {
  if (!setup.blocked.empty() && setup.blocked.size() != grid.size()) {
    throw std::invalid_argument("terrain and obstacles need one value a cell");
  }
  require_within("max-steps", setup.max_steps);
  require_within("robot-radius", setup.robot_radius);
  require_within("simplification", setup.simplification);
  require_within("sub-goal-depth", setup.sub_goal_depth);
  require_inside(grid, setup.blocked, setup.start, "start");
  if (setup.goal) {
    require_inside(grid, setup.blocked, *setup.goal, "goal");
  }
  for (const Cell c : setup.more_goals) {
    require_inside(grid, setup.blocked, c, "goal");
  }
  for (const Cell c : setup.first_cells) {
    require_inside(grid, setup.blocked, c, "first measurement");
  }
}

void require_explorable(const Terrain& terrain, const ExploreSetup& setup) {
  const Grid& grid = terrain.grid;
  if (terrain.values.size() != grid.size() ||
      (!terrain.felt.empty() && terrain.felt.size() != grid.size()) ||
      (!setup.blocked.empty() && setup.blocked.size() != grid.size())) {
    throw std::invalid_argument("terrain and obstacles need one value a cell");
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool felt = setup.blocked.empty() || setup.blocked[i] == 0;
    if (felt && !(std::abs(terrain.values[i]) <= kLargestValue)) {
      throw std::invalid_argument("the value at " + text_of(grid.cell(i)) +
                                  " is not a number within +-1e30; block the cell if it is a gap");
    }
  }
  require_valid(grid, setup);
  const bool certifies =
      setup.rules.kind == RuleSet::certified || setup.rules.kind == RuleSet::band;
  if (certifies && terrain.felt_at(setup.start) - setup.rules.noise_bound < setup.rules.threshold) {
    throw std::invalid_argument(
        "the start " + text_of(setup.start) +
        " stands on unsafe ground: " + std::to_string(terrain.at(setup.start)) +
        " less the noise bound is below the threshold " + std::to_string(setup.rules.threshold));
  }
}

End what_forbids(const Terrain& terrain, const ExploreSetup& setup, Cell from, Cell goal) {
  CellSet good(terrain.grid.size());
  for (std::size_t i = 0; i < good.size(); ++i) {
    // What a gap holds is not known: it may be good.
    good[i] = terrain.values[i] < setup.rules.threshold ? 0 : 1;
  }
  if (!are_joined(terrain.grid, good, from, goal)) {
    return End::not_reachable;
  }
  for (std::size_t i = 0; i < setup.blocked.size(); ++i) {
    good[i] = setup.blocked[i] != 0 ? 0 : good[i];
  }
  if (!are_joined(terrain.grid, good, from, goal)) {
    return End::past_obstacles;
  }
  if (!are_joined(
          terrain.grid, standing_cells(terrain.grid, good, Footprint(setup.body)), from, goal)) {
    return End::only_body;
  }
  return setup.rules.kind == RuleSet::certified ? End::only_lipschitz : End::only_rules;
}

}  // namespace tcert::terrain
