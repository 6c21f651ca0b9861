#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <terrain/limits.hpp>
#include <terrain/planner.hpp>
#include <utility>

namespace tcert::terrain {
Planner::Planner(const Grid& grid,
                 const Rules& rules,
                 const GpPrior& prior,
                 const std::vector<Cell>& seeds)
    : grid_(grid),
      rules_(rules),
      model_(std::make_unique<SeparableGp>(grid, prior)),
      seeds_(grid.size(), 0),
      safe_(grid.size(), 0),
      standing_(grid.size(), 0),
      expanders_(grid.size(), 0),
      considered_(grid.size(), 0),
      measured_(grid.size(), 0),
      intervals_(grid.size()),
      cone_(rules.kind == RuleSet::certified ? grid.size() : 0) {
  require_valid(rules);
  for (const Cell seed : seeds) {
    if (!grid.contains(seed)) {
      throw std::invalid_argument("a seed lies outside the grid");
    }
    seeds_[grid.index(seed)] = 1;
    intervals_.lower[grid.index(seed)] = rules.threshold;
  }
  safe_ = seeds_;
}

double Planner::steepest_to(const Measurement& m) const {
  double steepest = 0.0;
  for (const Measurement& other : measurements_) {
    const double d = (m.at - other.at).norm();
    const double rise = std::abs(m.value - other.value) - 2.0 * rules_.noise_bound;
    if (d > 0.0) {
      steepest = std::max(steepest, rise / d);
    } else if (rise > 0.0) {
      throw std::invalid_argument("two measurements of one cell differ by more than the noise");
    }
  }
  return steepest;
}

void Planner::add(const Measurement& m) {
  if (!std::isfinite(m.value) || !is_near(m.at)) {
    throw std::invalid_argument("a measurement must be finite, and within 1e6 cells");
  }
  const Cell cell = nearest_cell(m.at);
  if (rules_.kind == RuleSet::certified) {
    if (!grid_.contains(cell) || position(cell) != m.at) {
      throw std::invalid_argument("a measurement must be at a cell of the grid");
    }
    const double steepest = steepest_to(m);
    model_->add(m.at, m.value);
    measurements_.push_back(m);
    measured_[grid_.index(cell)] = 1;
    if (steepest > rules_.lipschitz * (1.0 + kSlopeSlack)) {
      ++contradictions_;
      rules_.lipschitz = steepest;
      derive_anew();
    } else {
      intersect_with_cone(cone_, grid_, cell, m.value, rules_.noise_bound, rules_.lipschitz);
    }
  } else {
    model_->add(m.at, m.value);
    measurements_.push_back(m);
    if (rules_.kind == RuleSet::band && grid_.contains(cell)) {
      measured_[grid_.index(cell)] = 1;
    }
  }
}

void Planner::derive_anew() {
  cone_ = Intervals(grid_.size());
  intervals_ = Intervals(grid_.size());
  safe_ = seeds_;
  for (const Measurement& known : measurements_) {
    intersect_with_cone(
        cone_, grid_, nearest_cell(known.at), known.value, rules_.noise_bound, rules_.lipschitz);
  }
}

void Planner::set_lipschitz(double lipschitz) {
  if (rules_.kind != RuleSet::certified) {
    throw std::invalid_argument("only the certified rules change their Lipschitz constant");
  }
  double steepest = lipschitz;
  for (const Measurement& m : measurements_) {
    steepest = std::max(steepest, steepest_to(m));
  }
  if (steepest != rules_.lipschitz) {
    rules_.lipschitz = steepest;
    derive_anew();
  }
}

void Planner::set_field_variance(double variance) {
  field_variance_ = variance;
  if (rules_.noise_sd > 0.0) {
    GpPrior prior = model_->prior();
    prior.noise_variance =
        std::min(prior.variance * (kBandNugget + rules_.noise_sd * rules_.noise_sd / variance),
                 limit_of("noise-variance").high);
    change_prior(prior);
  }
}

void Planner::set_body(const Body& body) { footprint_ = Footprint(body); }

void Planner::set_blocked(CellSet blocked) {
  if (blocked.size() != grid_.size()) {
    throw std::invalid_argument("the layer of obstacles must have the terrain's cells");
  }
  blocked_ = std::move(blocked);
}

CellSet Planner::ground() const {
  CellSet ground = safe_;
  for (std::size_t i = 0; i < blocked_.size(); ++i) {
    ground[i] = ground[i] != 0 && blocked_[i] == 0 ? 1 : 0;
  }
  return ground;
}

void Planner::change_prior(const GpPrior& prior) {
  auto model = std::make_unique<SeparableGp>(model_->begun_anew(prior));
  for (const Measurement& m : measurements_) {
    model->add(m.at, m.value);
  }
  model_ = std::move(model);
  if (rules_.kind == RuleSet::certified) {
    // What the old model said of intervals no longer binds.
    intervals_ = cone_;
  }
}

}  // namespace tcert::terrain
