#include <cmath>
#include <stdexcept>
#include <string>
#include <terrain/explore_checks.hpp>
#include <terrain/limits.hpp>
#include <terrain/session.hpp>
#include <utility>

namespace tcert::terrain {
namespace {

constexpr const char* kLimitReached = "all measurements that the limit allows were taken";

}  // namespace

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
  require_within("kernel-length-scale", setup_.prior.length_scale);
  require_within("noise-sd", setup_.noise_sd);
  require_within("gradient-prior", setup_.gradient.sd);
  require_within("gradient-prior", setup_.gradient.places);
  if (setup_.confidence != 0.0 || setup_.rules.kind == RuleSet::band || !told_.lipschitz) {
    require_within("confidence", setup_.confidence);
  }
  (void)Footprint(setup_.body);
  ExploreSetup noise = setup_;
  settle_noise(noise, 1);
  for (const Measurement& m : setup_.known) {
    if (!is_near(m.at)) {
      throw std::invalid_argument("a known measurement lies outside the terrain");
    }
    require(nearest_cell(m.at), m.value);
    values_.emplace(grid_.index(nearest_cell(m.at)), m.value);
  }
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

void Session::require_same(const ExploreSetup& setup, Cell c, double value) const {
  const auto earlier = values_.find(grid_.index(c));
  const double error = setup.rules.kind == RuleSet::band ? std::sqrt(kTrustedBeta) * setup.noise_sd
                                                         : setup.rules.noise_bound;
  if (earlier != values_.end() && std::abs(value - earlier->second) > 2.0 * error) {
    throw std::invalid_argument("the value " + std::to_string(value) + " at (" +
                                std::to_string(c.x) + ", " + std::to_string(c.y) +
                                ") differs from the earlier " + std::to_string(earlier->second) +
                                " by more than the noise");
  }
}

void Session::take(Cell c, double value) {
  require(c, value);
  const Measurement m{position(c), value};
  if (explorer_ == nullptr) {
    ExploreSetup noise = setup_;
    settle_noise(noise, setup_.known.size() + first_.size() + 1);
    require_same(noise, c, value);
    if (!values_.contains(grid_.index(c))) {
      if (static_cast<double>(first_.size()) >= limit_of("max-steps").high) {
        throw std::invalid_argument("there are too many measurements before the first plan");
      }
      first_.push_back(m);
    }
  } else {
    require_same(*settled_, c, value);
    if (!explorer_->asks_for(c)) {
      return;
    }
    if (step_ + beside_ >= settled_->max_steps) {
      throw std::invalid_argument(kLimitReached);
    }
    explorer_->add(m);
    ++beside_;
  }
  values_.emplace(grid_.index(c), value);
}

void Session::begin(const Measurement& at_start) {
  std::vector<Measurement> first = first_;
  first.push_back(at_start);
  auto settled = std::make_unique<ExploreSetup>(setup_);
  settle_noise(*settled, settled->known.size() + first.size());
  require_same(*settled, nearest_cell(at_start.at), at_start.value);
  if (at_start.value - settled->rules.noise_bound < settled->rules.threshold) {
    const Cell c = nearest_cell(at_start.at);
    throw std::invalid_argument("the start is not safe: " + std::to_string(at_start.value) +
                                " at (" + std::to_string(c.x) + ", " + std::to_string(c.y) +
                                ") less the noise bound is below the threshold " +
                                std::to_string(settled->rules.threshold));
  }
  std::vector<Measurement> all = settled->known;
  all.insert(all.end(), first.begin(), first.end());
  settled->start = nearest_cell(at_start.at);
  settle(*settled, grid_, all, told_);
  auto explorer = std::make_unique<Explorer>(grid_, *settled);
  for (const Measurement& m : first) {
    if (explorer->asks_for(nearest_cell(m.at))) {
      explorer->add(m);
    }
  }
  settled_ = std::move(settled);
  explorer_ = std::move(explorer);
}

const Decision& Session::plan(Cell c, double value) {
  require(c, value);
  const Measurement m{position(c), value};
  if (explorer_ == nullptr) {
    begin(m);
  } else if (decision_.end == End::step_limit) {
    throw std::invalid_argument(kLimitReached);
  } else {
    require_same(*settled_, c, value);
    if (explorer_->asks_for(c)) {
      explorer_->add(m);
    }
    if (explorer_->robot() != m.at) {
      explorer_->place(m.at);
    }
    ++step_;
  }
  values_.emplace(grid_.index(c), value);
  last_ = m;
  decide();
  return decision_;
}

void Session::decide() {
  decision_.way.clear();
  decision_.row = explorer_->plan(step_, last_);
  for (;;) {
    decision_.end = explorer_->end(step_ + beside_);
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
