#include <algorithm>
#include <cmath>
#include <terrain/components.hpp>
#include <terrain/disc_growth.hpp>
#include <terrain/distance_transform.hpp>
#include <terrain/frontier.hpp>
#include <terrain/planner.hpp>
#include <terrain/selection.hpp>
#include <utility>

namespace tcert::terrain {
namespace {

/// `band` certifies where the measurements explain half of the field's variance at least. Where
/// they explain little the band is that of the field as a whole, whose mean and variance are known
/// from few places, and of one that is rougher than believed from too few.
constexpr double kMostUnexplained = 0.5;

}  // namespace

const Plan& Planner::plan(std::optional<Cell> goal, std::optional<Cell> robot) {
  plan_ = {};
  switch (rules_.kind) {
    case RuleSet::thesis:
      plan_thesis(goal, robot);
      break;
    case RuleSet::published:
      plan_published(goal, robot);
      break;
    case RuleSet::certified:
      plan_certified(goal, robot);
      break;
    case RuleSet::band:
      plan_band(goal, robot);
      break;
  }
  plan_.safe = count(ground());
  if (plan_.next) {
    const std::size_t i = grid_.index(*plan_.next);
    plan_.lower = intervals_.lower[i];
    plan_.upper = intervals_.upper[i];
  }
  return plan_;
}

CellSet Planner::unmeasured_expanders(const Intervals& by,
                                      const CellSet& reachable,
                                      const std::vector<std::int64_t>& depth2) const {
  CellSet set = expanders(safe_, by.upper, rules_.threshold, rules_.lipschitz, depth2);
  for (std::size_t i = 0; i < set.size(); ++i) {
    set[i] = set[i] != 0 && reachable[i] != 0 && measured_[i] == 0 ? 1 : 0;
  }
  return set;
}

void Planner::consider(const std::vector<std::size_t>& cells) {
  considered_.assign(grid_.size(), 0);
  for (const std::size_t i : cells) {
    considered_[i] = 1;
  }
}

void Planner::choose(std::vector<std::size_t> candidates,
                     const Intervals& by,
                     std::optional<Cell> goal,
                     Ties ties) {
  const auto n = static_cast<std::size_t>(rules_.expanders);
  candidates = goal ? nearest_cells(grid_, std::move(candidates), *goal, n)
                    : widest_cells(std::move(candidates), by, n);
  consider(candidates);
  if (const auto best = widest_cell(grid_, candidates, by, goal, ties)) {
    plan_.next = grid_.cell(*best);
  }
}

CellSet Planner::reachable_ground(std::optional<Cell> robot) {
  standing_ = standing_cells(grid_, ground(), footprint_);
  return robot ? component_of(grid_, standing_, *robot) : standing_;
}

void Planner::leave_out_blocked(std::optional<Cell> robot) {
  const CellSet reachable = reachable_ground(robot);
  if (blocked_.empty() && footprint_.is_point()) {
    return;
  }
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    expanders_[i] = expanders_[i] & reachable[i];
  }
}

void Planner::plan_thesis(std::optional<Cell> goal, std::optional<Cell> robot) {
  if (model_->measurements() > 0) {
    // An empty intersection keeps lower > upper: its width is negative and it is never chosen
    // first.
    empty_ = intersect_with_band(intervals_,
                                 model_->mean(),
                                 model_->variance(),
                                 rules_.band(),
                                 rules_.model_everywhere ? nullptr : &safe_);
  }
  safe_ = grow_discs(grid_,
                     safe_,
                     intervals_.lower,
                     rules_.threshold,
                     rules_.lipschitz,
                     squared_depth(grid_, safe_));
  expanders_ = expanders(
      safe_, intervals_.upper, rules_.threshold, rules_.lipschitz, squared_depth(grid_, safe_));
  leave_out_blocked(robot);
  plan_.expanders = count(expanders_);
  choose(members(expanders_), intervals_, goal, Ties::nearest_first);
}

void Planner::plan_published(std::optional<Cell> goal, std::optional<Cell> robot) {
  set_to_band(intervals_, model_->mean(), model_->variance(), rules_.band());
  double highest_lower = -kUnbounded;
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    safe_[i] = intervals_.lower[i] > rules_.threshold ? 1 : 0;
    if (safe_[i] != 0) {
      highest_lower = std::max(highest_lower, intervals_.lower[i]);
    }
  }
  // Maximisers, and the widest of them: what remains must be wider.
  CellSet candidates = safe_;
  double widest = 0.0;
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    if (safe_[i] != 0 && intervals_.upper[i] >= highest_lower) {
      ++plan_.maximisers;
      candidates[i] = 0;
      widest = std::max(widest, intervals_.width(i));
    }
  }
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    candidates[i] = candidates[i] != 0 && intervals_.width(i) > widest ? 1 : 0;
  }
  plan_.candidates = count(candidates);
  expanders_ = expanders(
      safe_, intervals_.upper, rules_.threshold, rules_.lipschitz, squared_depth(grid_, safe_));
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    expanders_[i] = expanders_[i] & candidates[i];
  }
  leave_out_blocked(robot);
  plan_.expanders = count(expanders_);
  choose(members(expanders_), intervals_, goal, Ties::row_major_first);
}

void Planner::plan_certified(std::optional<Cell> goal, std::optional<Cell> robot) {
  // C_t: history, the model's band and the Lipschitz bound; where they exclude one another the
  // model is wrong, and the Lipschitz bound alone is kept.
  intersect_with_band(intervals_, model_->mean(), model_->variance(), rules_.band(), nullptr);
  empty_ = 0;
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    double& lower = intervals_.lower[i];
    double& upper = intervals_.upper[i];
    lower = std::max(lower, cone_.lower[i]);
    upper = std::min(upper, cone_.upper[i]);
    if (lower > upper) {
      lower = cone_.lower[i];
      upper = cone_.upper[i];
      ++empty_;
    }
    safe_[i] = safe_[i] != 0 || cone_.lower[i] >= rules_.threshold ? 1 : 0;
  }
  if (rules_.trust_model) {
    safe_ = grow_discs(grid_,
                       safe_,
                       intervals_.lower,
                       rules_.threshold,
                       rules_.lipschitz,
                       squared_depth(grid_, safe_));
  }
  const std::vector<std::int64_t> depth2 = squared_depth(grid_, safe_);
  const CellSet reachable = reachable_ground(robot);
  expanders_ = unmeasured_expanders(intervals_, reachable, depth2);
  plan_.expanders = count(expanders_);
  if (plan_.expanders == 0) {
    // That nothing more can grow is the model's word; the Lipschitz bound alone may end the search.
    expanders_ = unmeasured_expanders(cone_, reachable, depth2);
    plan_.expanders = count(expanders_);
    plan_.against_the_model = plan_.expanders > 0;
  }
  select(plan_.against_the_model ? cone_ : intervals_, goal, robot, depth2);
}

void Planner::plan_band(std::optional<Cell> goal, std::optional<Cell> robot) {
  intervals_ = Intervals(grid_.size());
  if (field_variance_ < kUnbounded && model_->measurements() > 0) {
    set_to_band(intervals_,
                model_->mean(),
                model_->variance(),
                rules_.band() * std::sqrt(field_variance_ / model_->prior().variance));
  }
  const double most = kMostUnexplained * model_->prior().variance;
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    const bool is_explained = model_->variance()[i] <= most;
    safe_[i] = seeds_[i] != 0 || (is_explained && intervals_.lower[i] >= rules_.threshold) ? 1 : 0;
  }
  expanders_ = borders(reachable_ground(robot));
  plan_.expanders = count(expanders_);
  select(intervals_, goal, robot, squared_depth(grid_, safe_));
}

CellSet Planner::borders(const CellSet& reachable) const {
  CellSet set(grid_.size(), 0);
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    if (reachable[i] == 0 || measured_[i] != 0) {
      continue;
    }
    const Cell c = grid_.cell(i);
    const bool grows = std::any_of(kSteps.begin(), kSteps.end(), [&](Cell step) {
      const Cell next{c.x + step.x, c.y + step.y};
      if (!grid_.contains(next)) {
        return false;
      }
      const std::size_t n = grid_.index(next);
      return standing_[n] == 0 && intervals_.upper[n] >= rules_.threshold &&
             (blocked_.empty() || blocked_[n] == 0);
    });
    set[i] = grows ? 1 : 0;
  }
  return set;
}

void Planner::select(const Intervals& by,
                     std::optional<Cell> goal,
                     std::optional<Cell> robot,
                     const std::vector<std::int64_t>& depth2) {
  const std::vector<std::size_t> candidates = members(expanders_);
  // Without discs nothing is expected to grow by more in one place than in another.
  const bool in_order = rules_.kind == RuleSet::band && !goal;
  if (rules_.selection == Selection::thesis || !robot || in_order) {
    choose(candidates, by, goal, Ties::nearest_first);
    return;
  }
  const FrontierView view{
      grid_,
      rules_,
      model_->mean(),
      model_->variance(),
      rules_.kind == RuleSet::band ? field_variance_ / model_->prior().variance : 1.0,
      intervals_,
      safe_,
      blocked_,
      depth2};
  switch (rules_.selection) {
    case Selection::horizon:
      plan_.next = best_sequence(view, candidates, goal, *robot);
      break;
    case Selection::pareto:
      plan_.next = best_of_front(view, candidates, goal, *robot);
      break;
    default:
      plan_.next = look_ahead(view, candidates, goal, *robot);
      break;
  }
  // All were looked at; those nearest to the goal are shown.
  const auto n = static_cast<std::size_t>(rules_.expanders);
  consider(goal ? nearest_cells(grid_, candidates, *goal, n)
                : widest_cells(candidates, intervals_, n));
}

}  // namespace tcert::terrain
