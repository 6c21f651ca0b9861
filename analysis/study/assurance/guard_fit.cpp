#include "analysis/study/assurance/guard_fit.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tcert::study {
namespace {

constexpr double kStandsStill = 1e-3;  // m in a tick

/// Choices that keep enough progress, the least unsafe dwell first; ties by place.
std::optional<std::size_t> best_of(const std::vector<GuardDwell>& of_choices,
                                   const GuardDwell& unguarded,
                                   double most_lost) {
  const double least = (1.0 - most_lost) * unguarded.metres_per_minute();
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < of_choices.size(); ++i) {
    if (of_choices[i].metres_per_minute() >= least && of_choices[i].stalled_share() <= most_lost &&
        (!best || of_choices[i].unsafe_per_metre() < of_choices[*best].unsafe_per_metre())) {
      best = i;
    }
  }
  return best;
}

/// What is left of `all` without one fold.
GuardDwell without(const GuardDwell& all, const GuardDwell& fold) {
  return {all.way_m - fold.way_m,
          all.time_s - fold.time_s,
          all.unsafe_s - fold.unsafe_s,
          all.trials - fold.trials,
          all.stalled - fold.stalled};
}

void mark_front(std::vector<GuardScore>& scores) {
  for (GuardScore& one : scores) {
    one.on_front = std::ranges::none_of(scores, [&](const GuardScore& other) {
      const double progress = other.all.metres_per_minute() - one.all.metres_per_minute();
      const double dwell = other.all.unsafe_per_metre() - one.all.unsafe_per_metre();
      const double stalls = other.all.stalled_share() - one.all.stalled_share();
      return progress >= 0.0 && dwell <= 0.0 && stalls <= 0.0 &&
             (progress > 0.0 || dwell < 0.0 || stalls < 0.0);
    });
  }
}

/// Of the choices that act and differ from `like` in epsilon alone.
RiskControl control_risk(const std::vector<GuardChoice>& choices,
                         const GuardChoice& like,
                         const std::vector<std::vector<GuardDwell>>& by_choice_and_day,
                         double alpha) {
  RiskControl control;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const GuardChoice& one = choices[i];
    if (one.guards.mode != GuardMode::act || one.law.kind != like.law.kind ||
        one.law.beta_per_m != like.law.beta_per_m ||
        one.guards.min_force_n != like.guards.min_force_n) {
      continue;
    }
    double sum = 0.0;
    for (const GuardDwell& day : by_choice_and_day[i]) {
      sum += day.time_s > 0.0 ? day.unsafe_s / day.time_s : 0.0;
    }
    control.risk.emplace_back(one.guards.replan_margin_m,
                              sum / static_cast<double>(by_choice_and_day[i].size()));
  }
  std::ranges::sort(control.risk);
  // The promise needs a risk that does not rise with epsilon: each counts as the largest from it
  // on.
  for (std::size_t i = control.risk.size(); i-- > 1;) {
    control.risk[i - 1].second = std::max(control.risk[i - 1].second, control.risk[i].second);
  }
  const auto days = static_cast<double>(by_choice_and_day.front().size());
  control.least_alpha = 1.0 / (days + 1.0);
  for (const auto& [epsilon_m, risk] : control.risk) {
    if (!control.epsilon_m && days / (days + 1.0) * risk + 1.0 / (days + 1.0) <= alpha) {
      control.epsilon_m = epsilon_m;
    }
  }
  return control;
}

}  // namespace

GuardDwell& GuardDwell::operator+=(const GuardDwell& other) noexcept {
  way_m += other.way_m;
  time_s += other.time_s;
  unsafe_s += other.unsafe_s;
  trials += other.trials;
  stalled += other.stalled;
  return *this;
}

double GuardDwell::metres_per_minute() const noexcept {
  return time_s > 0.0 ? 60.0 * way_m / time_s : 0.0;
}

double GuardDwell::unsafe_per_metre() const noexcept {
  return way_m > 0.0 ? unsafe_s / way_m : 0.0;
}

double GuardDwell::stalled_share() const noexcept {
  return trials > 0 ? static_cast<double>(stalled) / static_cast<double>(trials) : 0.0;
}

GuardedPath guarded_path(TickTable ticks,
                         std::vector<CertifiedTick> series,
                         std::span<const TruthSample> truth,
                         std::size_t day) {
  GuardedPath path;
  path.day = day;
  path.ticks = std::move(ticks);
  path.series = std::move(series);
  const std::size_t size = path.ticks.size();
  path.way_m.assign(size, 0.0);
  path.logged_s.assign(size, 0.0);
  path.free_ahead_m.assign(size, kTruthAhead);
  std::size_t at = 0;
  for (std::size_t i = 0; i < size; ++i) {
    while (at + 1 < truth.size() && truth[at + 1].time_ns <= path.ticks.time_ns[i]) {
      ++at;
    }
    if (at < truth.size() && truth[at].time_ns <= path.ticks.time_ns[i]) {
      path.free_ahead_m[i] = truth[at].free_ahead_m;
    }
    if (i + 1 == size || path.ticks.segment_start[i + 1] != 0) {
      continue;
    }
    const Point step = path.ticks.poses[i + 1].position - path.ticks.poses[i].position;
    const double forward_m = dot(step, direction(path.ticks.poses[i].yaw_rad));
    if (forward_m > kStandsStill) {
      path.way_m[i] = forward_m;
      path.logged_s[i] = elapsed_s(path.ticks.time_ns[i], path.ticks.time_ns[i + 1]);
    }
  }
  return path;
}

GuardDwell unguarded_dwell(const GuardedPath& path, const UnsafeRule& unsafe) {
  GuardDwell dwell;
  dwell.trials = 1;
  for (std::size_t i = 0; i < path.way_m.size(); ++i) {
    if (path.way_m[i] > 0.0) {
      const double speed_mps = path.way_m[i] / path.logged_s[i];
      dwell.way_m += path.way_m[i];
      dwell.time_s += path.logged_s[i];
      const bool is_unsafe =
          is_collision_ahead({0, {}, 0.0, 0.0, path.free_ahead_m[i]}, speed_mps, unsafe);
      dwell.unsafe_s += is_unsafe ? path.logged_s[i] : 0.0;
    }
  }
  return dwell;
}

GuardDwell guarded_dwell(const GuardedPath& path,
                         const GuardSetup& setup,
                         const UnsafeRule& unsafe,
                         double stall_m) {
  Guards guards(setup);
  GuardDwell dwell;
  dwell.trials = 1;
  double halted_m = 0.0;
  for (std::size_t i = 0; i < path.way_m.size(); ++i) {
    const Command commanded = path.ticks.commanded(i);
    const GuardedTick now =
        guards.update(path.ticks[i], path.series[i], {kMissing, commanded.yaw_rate_rps});
    if (!(path.way_m[i] > 0.0)) {
      continue;
    }
    const double speed_mps = now.halted() ? now.retreat_speed_mps : now.speed_mps;
    halted_m = now.halted() ? halted_m + path.way_m[i] : 0.0;
    dwell.stalled = halted_m >= stall_m ? 1 : dwell.stalled;
    const double time_s = path.way_m[i] / speed_mps;
    dwell.way_m += path.way_m[i];
    dwell.time_s += time_s;
    const bool is_unsafe =
        !now.halted() &&
        is_collision_ahead({0, {}, 0.0, 0.0, path.free_ahead_m[i]}, speed_mps, unsafe);
    dwell.unsafe_s += is_unsafe ? time_s : 0.0;
  }
  return dwell;
}

std::vector<GuardChoice> guard_choices(const GuardChoice& base,
                                       const std::vector<SpeedLawKind>& laws,
                                       const std::vector<double>& betas,
                                       const std::vector<double>& epsilons_m,
                                       const std::vector<double>& forces_n) {
  std::vector<GuardChoice> choices;
  for (const SpeedLawKind law : laws) {
    for (const double beta : betas) {
      GuardChoice alone = base;
      alone.law.kind = law;
      alone.law.beta_per_m = beta;
      alone.guards.mode = GuardMode::watch;
      choices.push_back(alone);
      for (const double epsilon_m : epsilons_m) {
        for (const double force_n : forces_n) {
          GuardChoice choice = base;
          choice.law.kind = law;
          choice.law.beta_per_m = beta;
          choice.guards.mode = GuardMode::act;
          choice.guards.replan_margin_m = epsilon_m;
          choice.guards.min_force_n = force_n;
          choices.push_back(choice);
        }
      }
    }
  }
  return choices;
}

GuardFit fit_guards(const std::vector<GuardedPath>& paths,
                    std::size_t days,
                    const GuardSetup& setup,
                    std::vector<GuardChoice> choices,
                    const UnsafeRule& unsafe,
                    const GuardFitOptions& options) {
  GuardFit fit;
  fit.choices = std::move(choices);
  fit.days = days;
  std::vector<GuardDwell> unguarded(days);
  for (const GuardedPath& path : paths) {
    unguarded[path.day] += unguarded_dwell(path, unsafe);
  }
  std::vector<std::vector<GuardDwell>> guarded(fit.choices.size(), std::vector<GuardDwell>(days));
  tbb::parallel_for(std::size_t{0}, fit.choices.size(), [&](std::size_t c) {
    GuardSetup of_choice = setup;
    of_choice.law = fit.choices[c].law;
    of_choice.parameters = fit.choices[c].guards;
    for (const GuardedPath& path : paths) {
      guarded[c][path.day] += guarded_dwell(path, of_choice, unsafe, options.stall_m);
    }
  });
  std::vector<GuardDwell> all(fit.choices.size());
  for (std::size_t c = 0; c < all.size(); ++c) {
    for (const GuardDwell& day : guarded[c]) {
      all[c] += day;
    }
    fit.scores.push_back({c, all[c], false});
  }
  for (const GuardDwell& day : unguarded) {
    fit.unguarded += day;
  }
  mark_front(fit.scores);
  fit.best = best_of(all, fit.unguarded, options.most_lost);
  const std::size_t folds = std::min(options.folds, days);
  for (std::size_t k = 0; k < folds && folds > 1; ++k) {
    GuardFold fold;
    std::vector<GuardDwell> of_fold(fit.choices.size());
    for (std::size_t day = k; day < days; day += folds) {
      ++fold.days;
      fold.unguarded += unguarded[day];
      for (std::size_t c = 0; c < of_fold.size(); ++c) {
        of_fold[c] += guarded[c][day];
      }
    }
    std::vector<GuardDwell> others(fit.choices.size());
    for (std::size_t c = 0; c < others.size(); ++c) {
      others[c] = without(all[c], of_fold[c]);
    }
    if (const auto best =
            best_of(others, without(fit.unguarded, fold.unguarded), options.most_lost)) {
      fold.choice = *best;
      fold.guarded = of_fold[*best];
      fit.folds.push_back(fold);
    } else {
      ++fit.folds_without;
    }
  }
  fit.control = control_risk(fit.choices, options.declared, guarded, options.risk);
  return fit;
}

}  // namespace tcert::study
