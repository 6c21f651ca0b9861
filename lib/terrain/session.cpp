#include <cmath>
#include <stdexcept>
#include <string>
#include <terrain/explore_checks.hpp>
#include <terrain/limits.hpp>
#include <terrain/session.hpp>
#include <utility>

namespace tcert::terrain {

std::vector<Cell> cells_round(const Grid& grid, const CellSet& blocked, Cell start, int radius) {
  std::vector<Cell> cells;
  for (int x = start.x - radius; x <= start.x + radius; ++x) {
    for (int y = start.y - radius; y <= start.y + radius; ++y) {
      const Cell c{x, y};
      if (grid.contains(c) && !(c == start) && squared_distance(c, start) <= radius * radius &&
          (blocked.empty() || blocked[grid.index(c)] == 0)) {
        cells.push_back(c);
      }
    }
  }
  return cells;
}

Session::Session(const Grid& grid, ExploreSetup setup, const Told& told)
    : grid_(grid), setup_(std::move(setup)), told_(told) {
  if (setup_.rules.kind != RuleSet::certified && setup_.rules.kind != RuleSet::band) {
    throw std::invalid_argument("a robot explores by the rules 'certified' or 'band'");
  }
  setup_.first_cells.clear();
  require_valid(grid_, setup_);
  require_valid(setup_.rules);
}

std::vector<Cell> Session::first_cells(int radius) const {
  std::vector<Cell> cells = cells_round(grid_, setup_.blocked, setup_.start, radius);
  cells.push_back(setup_.start);
  return cells;
}

void Session::require(Cell c, double value) const {
  const std::string place = "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
  if (!grid_.contains(c)) {
    throw std::invalid_argument("the cell " + place + " lies outside the terrain of " +
                                std::to_string(grid_.rows) + " x " + std::to_string(grid_.columns) +
                                " cells");
  }
  if (!setup_.blocked.empty() && setup_.blocked[grid_.index(c)] != 0) {
    throw std::invalid_argument("the cell " + place + " is blocked");
  }
  if (!(std::abs(value) <= kLargestValue)) {
    throw std::invalid_argument("the value at " + place + " is not a number within +-1e30");
  }
}

void Session::take(Cell c, double value) {
  require(c, value);
  const Measurement m{position(c), value};
  if (explorer_ == nullptr) {
    first_.push_back(m);
  } else if (explorer_->asks_for(c)) {
    explorer_->add(m);
  }
}

void Session::begin(const Measurement& at_start) {
  first_.push_back(at_start);
  for (const Measurement& m : first_) {
    if (m.value - setup_.rules.noise_bound < setup_.rules.threshold) {
      const Cell c = nearest_cell(m.at);
      throw std::invalid_argument(
          "the ground round the start is not safe: " + std::to_string(m.value) + " at (" +
          std::to_string(c.x) + ", " + std::to_string(c.y) +
          ") less the noise bound is below the "
          "threshold " +
          std::to_string(setup_.rules.threshold));
    }
  }
  std::vector<Measurement> all = setup_.known;
  all.insert(all.end(), first_.begin(), first_.end());
  setup_.start = nearest_cell(at_start.at);
  settle(setup_, grid_, all, told_);
  explorer_ = std::make_unique<Explorer>(grid_, setup_);
  for (const Measurement& m : first_) {
    if (setup_.known.empty() || explorer_->asks_for(nearest_cell(m.at))) {
      explorer_->add(m);
    }
  }
}

const Decision& Session::plan(Cell c, double value) {
  require(c, value);
  last_ = {position(c), value};
  if (explorer_ == nullptr) {
    begin(last_);
  } else {
    if (explorer_->asks_for(c)) {
      explorer_->add(last_);
    }
    if (explorer_->robot() != last_.at) {
      explorer_->place(last_.at);
    }
    ++step_;
  }
  decide();
  return decision_;
}

void Session::decide() {
  decision_.way.clear();
  decision_.row = explorer_->plan(step_, last_);
  for (;;) {
    decision_.end = explorer_->end(step_);
    const bool reached = decision_.end == End::reached;
    if (decision_.end && !reached) {
      return;
    }
    const Way way = reached ? explorer_->go_to_goal() : explorer_->go();
    decision_.way.insert(decision_.way.end(), way.points.begin(), way.points.end());
    if (!reached) {
      return;
    }
    ++decision_.goals_reached;
    if (!explorer_->take_next_goal()) {
      decision_.row.travelled = explorer_->travelled();
      return;
    }
    decision_.row = explorer_->plan(step_, last_);
  }
}

}  // namespace tcert::terrain
