#include <algorithm>
#include <terrain/explore.hpp>
#include <terrain/explore_checks.hpp>
#include <terrain/explorer.hpp>

namespace tcert::terrain {
namespace {

/// An explorer on a terrain that is known, which is felt for it.
class Run {
 public:
  Run(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe)
      : terrain_(terrain), setup_(setup), observe_(observe), explorer_(terrain.grid, setup) {
    result_.path.push_back(explorer_.robot());
  }

  ExploreResult run() {
    for (const Cell c : setup_.first_cells) {
      if (setup_.known.empty() || explorer_.asks_for(c)) {
        explorer_.add({position(c), terrain_.felt_at(c)});
      }
    }
    measure();
    for (int step = 0;; ++step) {
      record(step);
      if (const auto end = finished(step)) {
        result_.end = *end;
        result_.frontier = explorer_.frontier();
        if (setup_.wants_layers) {
          result_.layers = explorer_.layers();
        }
        result_.goal = explorer_.goal().value_or(Cell{});
        return std::move(result_);
      }
      take(explorer_.go());
      measure();
    }
  }

 private:
  void measure() {
    const Cell c = nearest_cell(explorer_.robot());
    last_ = {explorer_.robot(), terrain_.felt_at(c)};
    if (explorer_.asks_for(c)) {
      visit(c);
      explorer_.add(last_);
    }
  }

  void visit(Cell c) {
    if (terrain_.at(c) < setup_.rules.threshold) {
      ++unsafe_visits_;
    }
  }

  void record(int step) {
    ExploreStep s = explorer_.plan(step, last_);
    s.unsafe_visits = unsafe_visits_;
    const CellSet ground = explorer_.planner().ground();
    for (std::size_t i = 0; i < terrain_.values.size(); ++i) {
      const bool unsafe = ground[i] != 0 && terrain_.values[i] < setup_.rules.threshold;
      s.unsafe_certified += unsafe ? 1U : 0U;
    }
    result_.most_unsafe_certified = std::max(result_.most_unsafe_certified, s.unsafe_certified);
    if (result_.steps.empty() || result_.steps.back().step != step) {
      result_.steps.push_back(s);
    } else {
      result_.steps.back() = s;  // Planned anew, for the next goal.
    }
    if (observe_) {
      observe_(explorer_.planner(), result_.steps.back(), result_);
    }
  }

  [[nodiscard]] std::optional<End> finished(int step) {
    for (;;) {
      const std::optional<End> end = explorer_.end(step);
      if (end == End::exhausted) {
        return what_forbids(terrain_, setup_, explorer_.leg_start(), *explorer_.goal());
      }
      if (end != End::reached) {
        return end;
      }
      take(explorer_.go_to_goal());
      ++result_.goals_reached;
      if (!explorer_.take_next_goal()) {
        result_.steps.back().travelled = explorer_.travelled();
        result_.steps.back().unsafe_visits = unsafe_visits_;
        return end;
      }
      record(step);
    }
  }

  void take(const Way& way) {
    std::for_each(way.cells.begin(), way.cells.end(), [&](Cell c) { visit(c); });
    result_.path.insert(result_.path.end(), way.points.begin(), way.points.end());
    result_.free_space = way.free_space;
    ++result_.ways;
    result_.controller_fallbacks += way.fell_back ? 1U : 0U;
    for (const double step : way.driven) {
      result_.controller_cells += step;
    }
    result_.route_cells += way.walked;
  }

  const Terrain& terrain_;
  const ExploreSetup& setup_;
  const Observer& observe_;
  Explorer explorer_;
  ExploreResult result_;
  Measurement last_;
  std::size_t unsafe_visits_ = 0;
};

}  // namespace

ExploreResult explore(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe) {
  require_explorable(terrain, setup);
  return Run(terrain, setup, observe).run();
}

}  // namespace tcert::terrain
