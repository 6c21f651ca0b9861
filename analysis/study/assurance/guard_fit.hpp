#pragma once
/// \file
/// The guards' law and thresholds fitted to driven trials (paper 5): least unsafe dwell at a
/// progress that is nearly that of the unguarded robot, chosen on some days and judged on others.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tcert/guards.hpp>
#include <vector>

#include "analysis/study/assurance/unsafe_episodes.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

/// Speed law and guards, as a candidate.
struct GuardChoice {
  SpeedLaw law;
  GuardParameters guards;
};

/// What a guarded robot comes to along logged paths. Sums, so that trials add up.
struct GuardDwell {
  double way_m = 0.0;
  double time_s = 0.0;
  double unsafe_s = 0.0;  ///< Driven towards a wall within its stopping way.
  std::size_t trials = 0;
  std::size_t stalled =
      0;  ///< Of them those that halt over stall_m of way or more, as in a replay.

  GuardDwell& operator+=(const GuardDwell& other) noexcept;
  [[nodiscard]] double metres_per_minute() const noexcept;
  [[nodiscard]] double unsafe_per_metre() const noexcept;  ///< s/m.
  [[nodiscard]] double stalled_share() const noexcept;
};

/// One trial, as far as its guards are judged by it.
struct GuardedPath {
  std::size_t day = 0;
  TickTable ticks;
  std::vector<CertifiedTick> series;
  std::vector<double> way_m;         ///< From each tick to the next, where the log moves forward.
  std::vector<double> logged_s;      ///< As long as that took.
  std::vector<double> free_ahead_m;  ///< The truth at each tick.
};

/// `truth` by the newest sample at or before each tick. Standing, reversing and breaks are left
/// out: no law has a part in them.
[[nodiscard]] GuardedPath guarded_path(TickTable ticks,
                                       std::vector<CertifiedTick> series,
                                       std::span<const TruthSample> truth,
                                       std::size_t day);

/// At the logged speed.
[[nodiscard]] GuardDwell unguarded_dwell(const GuardedPath& path, const UnsafeRule& unsafe);

/// At the speed that guards of `setup` grant, on the same path; where they halt the way is driven
/// at the least speed and counts as safe: somebody looks. A trial that halts over `stall_m` of
/// forward way would not have got through: it is stalled. \pre `setup` is of the path's robot.
[[nodiscard]] GuardDwell guarded_dwell(const GuardedPath& path,
                                       const GuardSetup& setup,
                                       const UnsafeRule& unsafe,
                                       double stall_m);

struct GuardFitOptions {
  /// delta: progress may fall to (1 - delta) of the unguarded one, and that share of trials stall.
  double most_lost = 0.1;
  double stall_m = 0.05;
  std::size_t folds = 5;   ///< Of whole days, dealt in their order.
  double risk = 0.1;       ///< alpha of conformal risk control.
  GuardChoice declared{};  ///< Whose epsilon that is for: law, beta and F_min are not chosen by it.
};

struct GuardScore {
  std::size_t choice = 0;
  GuardDwell all;
  bool on_front = false;  ///< No other has more progress, less unsafe dwell and fewer stalls.
};

struct GuardFold {
  std::size_t days = 0;
  std::size_t choice = 0;  ///< Of the other folds.
  GuardDwell unguarded;    ///< On its own days.
  GuardDwell guarded;
};

/// epsilon_replan with a promise for a new day: the smallest epsilon with
/// n/(n + 1) R(epsilon) + 1/(n + 1) <= alpha, R the mean over days of the share of the guarded time
/// that is unsafe (Angelopoulos et al. 2022). Of the declared law, beta and F_min alone: what is
/// chosen by the same days has no such promise.
struct RiskControl {
  std::optional<double> epsilon_m;
  std::vector<std::pair<double, double>> risk;  ///< epsilon and R, made to fall.
  double least_alpha = 0.0;                     ///< That so many days can promise: 1/(n + 1).
};

struct GuardFit {
  std::vector<GuardChoice> choices;
  std::vector<GuardScore> scores;  ///< One a choice.
  GuardDwell unguarded;
  std::optional<std::size_t> best;  ///< Of all days; none keeps the progress if empty.
  std::vector<GuardFold> folds;
  std::size_t folds_without = 0;  ///< In which no choice was good enough: they are in no figure.
  std::size_t days = 0;
  RiskControl control;
};

/// The grid: each law of `laws` at each beta, alone (G2 and G3 are stated and do nothing) and with
/// guards that act at each epsilon and force envelope. The rest as in `base`.
[[nodiscard]] std::vector<GuardChoice> guard_choices(const GuardChoice& base,
                                                     const std::vector<SpeedLawKind>& laws,
                                                     const std::vector<double>& betas,
                                                     const std::vector<double>& epsilons_m,
                                                     const std::vector<double>& forces_n);

/// O(choices x ticks). The same for any number of threads. \pre paths, choices are not empty.
[[nodiscard]] GuardFit fit_guards(const std::vector<GuardedPath>& paths,
                                  std::size_t days,
                                  const GuardSetup& setup,
                                  std::vector<GuardChoice> choices,
                                  const UnsafeRule& unsafe,
                                  const GuardFitOptions& options);

}  // namespace tcert::study
