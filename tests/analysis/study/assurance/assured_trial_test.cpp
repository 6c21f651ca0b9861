#include <gtest/gtest.h>

#include <random>

#include "analysis/study/assurance/assurance.hpp"
#include "analysis/study/assurance/guard_fit.hpp"

namespace tcert::study {
namespace {

constexpr std::int64_t kTick = 100'000'000;

TickTable ticks_of(std::size_t count, double step_m = 0.02) {
  TickTable ticks;
  for (std::size_t i = 0; i < count; ++i) {
    ticks.time_ns.push_back(static_cast<std::int64_t>(i) * kTick);
    ticks.poses.push_back({{step_m * static_cast<double>(i), 0.0}, 0.0});
    ticks.stale.push_back(0);
    ticks.segment_start.push_back(0);
  }
  return ticks;
}

/// 20 samples a second; `free_ahead` says how much way there is at a time.
template <class FreeAhead>
std::vector<TruthSample> truth_of(double seconds, double speed_mps, FreeAhead free_ahead) {
  std::vector<TruthSample> truth;
  for (std::int64_t i = 0; static_cast<double>(i) * 0.05 <= seconds; ++i) {
    const double now_s = 0.05 * static_cast<double>(i);
    truth.push_back({i * 50'000'000, {}, speed_mps, 0.0, free_ahead(now_s)});
  }
  return truth;
}

double near_wall(double now_s) { return now_s >= 5.0 && now_s < 6.0 ? 0.01 : 0.4; }

TEST(UnsafeEpisodes, AreTimesAtWhichAWallIsWithinTheStoppingWay) {
  const UnsafeRule rule;
  // 0.2 m/s: 0.04 m of reaction and 0.02 m of braking.
  EXPECT_NEAR(stopping_way_m(0.2, rule), 0.06, 1e-12);
  EXPECT_EQ(stopping_way_m(-0.2, rule), 0.0);
  const auto truth = truth_of(10.0, 0.2, near_wall);
  const auto episodes = unsafe_episodes(truth, rule);
  ASSERT_EQ(episodes.size(), 1U);
  EXPECT_NEAR(episodes[0].time.begin_s, 5.0, 1e-9);
  EXPECT_NEAR(episodes[0].time.end_s, 6.0, 1e-9);
  EXPECT_TRUE(episodes[0].ahead);
  EXPECT_FALSE(episodes[0].force);
  EXPECT_TRUE(unsafe_episodes(truth_of(10.0, 0.02, near_wall), rule).empty())
      << "slowly it can stop";
  EXPECT_TRUE(unsafe_episodes(truth_of(10.0, -0.2, near_wall), rule).empty()) << "it backs away";
}

TEST(UnsafeEpisodes, JoinGapsAndLeaveOutWhatIsShort) {
  const UnsafeRule rule;
  const auto at = [&](auto unsafe_at) {
    return unsafe_episodes(truth_of(10.0, 0.2, [&](double t) { return unsafe_at(t) ? 0.0 : 0.4; }),
                           rule);
  };
  EXPECT_EQ(at([](double t) { return t > 2.0 && (t < 2.5 || (t > 2.9 && t < 3.2)); }).size(), 1U);
  EXPECT_EQ(at([](double t) { return t > 2.0 && (t < 2.5 || (t > 3.1 && t < 3.5)); }).size(), 2U);
  EXPECT_TRUE(at([](double t) { return t > 2.0 && t < 2.12; }).empty());
}

std::vector<ActedTick> alarms_at(std::size_t count, std::vector<std::pair<double, double>> spans) {
  std::vector<ActedTick> acted(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double now_s = 0.1 * static_cast<double>(i);
    for (const auto& [begin_s, end_s] : spans) {
      acted[i].alarms |= now_s >= begin_s && now_s < end_s ? 1U : 0U;
    }
  }
  return acted;
}

TEST(AssuredTrial, AnAlarmTellsOfWhatBeginsSoon) {
  const TickTable ticks = ticks_of(101);
  const auto truth = truth_of(10.0, 0.2, near_wall);
  const auto judged = [&](std::vector<std::pair<double, double>> spans) {
    return assure_trial(ticks, alarms_at(101, std::move(spans)), 1, truth, {}, 0.4, {}).monitors[1];
  };
  EXPECT_TRUE(judged({{4.0, 4.2}}).episodes[0].detected);
  EXPECT_NEAR(judged({{4.0, 4.2}}).episodes[0].delay_s, -1.0, 1e-9);
  EXPECT_NEAR(judged({{5.3, 5.5}}).episodes[0].delay_s, 0.3, 1e-9);
  EXPECT_FALSE(judged({{5.7, 6.0}}).episodes[0].detected) << "too late";
  EXPECT_EQ(judged({{5.7, 6.0}}).false_alarms, 0U) << "but not false";
  EXPECT_FALSE(judged({{2.0, 2.5}}).episodes[0].detected);
  EXPECT_EQ(judged({{2.0, 2.5}, {2.7, 2.8}, {8.0, 8.1}}).false_alarms, 2U);
  // Always on: it detects everything, and all of the way is driven under it.
  const MonitorRecord always = judged({{0.0, 20.0}});
  EXPECT_TRUE(always.episodes[0].detected);
  EXPECT_NEAR(always.episodes[0].delay_s, -2.0, 1e-9);
  EXPECT_NEAR(always.alarmed_m, 2.0, 1e-9);
  EXPECT_EQ(always.false_alarms, 2U) << "before the episode's time and after it";
  EXPECT_NEAR(always.false_s, 3.0 + 3.5, 0.11);
}

TEST(AssuredTrial, AFaultIsSeenWhileItLastsOrJustAfter) {
  const TickTable ticks = ticks_of(101);
  const std::vector<InjectedFault> faults{{"wide", {3.0, 4.0}}, {"freeze", {7.0, 8.0}}};
  const AssuredTrial trial =
      assure_trial(ticks, alarms_at(101, {{4.4, 4.6}}), 1, std::nullopt, {}, 0.4, faults);
  EXPECT_TRUE(trial.monitors[0].faults[0].detected);
  EXPECT_NEAR(trial.monitors[0].faults[0].delay_s, 1.4, 1e-9);
  EXPECT_FALSE(trial.monitors[0].faults[1].detected);
  EXPECT_FALSE(trial.has_truth);
  EXPECT_EQ(trial.monitors[0].false_alarms, 0U) << "without truth none is called false";
  EXPECT_EQ(trial.monitors[0].controls[0], Control::none) << "there is no time before the first";
  const std::vector<InjectedFault> late{{"wide", {9.0, 9.3}}};
  const auto control = [&](double begin_s) {
    return assure_trial(
               ticks, alarms_at(101, {{begin_s, begin_s + 0.2}}), 1, std::nullopt, {}, 0.4, late)
        .monitors[0]
        .controls[0];
  };
  EXPECT_EQ(control(3.5), Control::alarmed);
  EXPECT_EQ(control(1.0), Control::quiet);
}

std::vector<AssuredTrial> trials_of(std::size_t count, double detected) {
  std::mt19937 random(1);
  std::vector<AssuredTrial> trials;
  for (std::size_t i = 0; i < count; ++i) {
    AssuredTrial trial;
    trial.trial_id = "t" + std::to_string(i);
    trial.cluster = "D" + std::to_string(i / 10);
    trial.hours = 0.02;
    trial.has_truth = true;
    trial.episodes.resize(3);
    MonitorRecord record;
    for (int k = 0; k < 3; ++k) {
      record.episodes.push_back({std::bernoulli_distribution(detected)(random), 0.1});
    }
    trial.monitors = {record, record};
    trials.push_back(trial);
  }
  return trials;
}

TEST(Assurance, TheClaimStandsOrFallsByItsInterval) {
  const auto verdict = [](double detected) {
    return assurance_of(trials_of(300, detected), {"rule"}, {}).monitors.back().claim;
  };
  EXPECT_EQ(verdict(0.97), Verdict::supported);
  EXPECT_EQ(verdict(0.5), Verdict::contradicted);
  EXPECT_EQ(verdict(0.9), Verdict::not_decided);
  const Assurance few = assurance_of(trials_of(50, 0.99), {"rule"}, {});
  EXPECT_FALSE(few.monitors.back().episodes.interval) << "five days";
  EXPECT_EQ(few.monitors.back().claim, Verdict::not_decided);
}

TEST(Assurance, AShareWithoutAMissHasAnIntervalAllTheSame) {
  const Assurance whole = assurance_of(trials_of(300, 1.0), {"rule"}, {});
  const ShareEstimate& share = whole.monitors.back().episodes;
  EXPECT_EQ(share.value, 1.0);
  ASSERT_TRUE(share.interval);
  EXPECT_LT(share.interval->low, 0.95) << "thirty days without a miss";
  EXPECT_EQ(share.interval->high, 1.0);
}

/// A run at 0.2 m/s with a wall near for one second, and a margin that says so if `tells`.
GuardedPath path_of(std::size_t day, bool tells) {
  TickTable ticks = ticks_of(101);
  std::vector<CertifiedTick> series(101);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double now_s = 0.1 * static_cast<double>(i);
    series[i].margin_m = tells && now_s >= 4.5 && now_s < 6.5 ? 0.0 : 0.3;
    series[i].corridor_value_m = series[i].margin_m;
  }
  return guarded_path(std::move(ticks), std::move(series), truth_of(10.0, 0.2, near_wall), day);
}

GuardSetup setup_of_test() { return {{}, {}, {}, {}, TrackingErrorTable()}; }

TEST(GuardFit, DwellIsTheTimeThatIsDrivenAtAWall) {
  const GuardedPath path = path_of(0, true);
  const GuardDwell before = unguarded_dwell(path, {});
  EXPECT_NEAR(before.way_m, 2.0, 1e-9);
  EXPECT_NEAR(before.time_s, 10.0, 1e-9);
  EXPECT_NEAR(before.unsafe_s, 1.0, 1e-9);
  EXPECT_NEAR(before.metres_per_minute(), 12.0, 1e-9);
  GuardSetup setup = setup_of_test();
  setup.parameters.mode = GuardMode::act;
  const GuardDwell after = guarded_dwell(path, setup, {}, 0.05);
  EXPECT_EQ(after.unsafe_s, 0.0);
  EXPECT_EQ(after.stalled, 1U) << "it halts over 0.4 m";
  EXPECT_EQ(guarded_dwell(path, setup, {}, 0.5).stalled, 0U);
  EXPECT_NEAR(after.way_m, 2.0, 1e-9);
}

TEST(GuardFit, ChoosesTheLeastDwellThatKeepsTheProgress) {
  std::vector<GuardedPath> paths;
  for (std::size_t day = 0; day < 12; ++day) {
    paths.push_back(path_of(day, true));
  }
  const auto choices = guard_choices({}, {SpeedLawKind::squash}, {5.0, 20.0}, {0.0, 0.4}, {5.0});
  // At beta 20 a fifth of the way takes two and a half times as long: 77 % of the progress is left.
  GuardFitOptions options;
  options.most_lost = 0.4;
  options.stall_m = 0.5;
  options.declared.law.beta_per_m = 20.0;
  const GuardFit fit = fit_guards(paths, 12, setup_of_test(), choices, {}, options);
  ASSERT_TRUE(fit.best);
  const GuardScore& best = fit.scores[*fit.best];
  EXPECT_NE(fit.choices[best.choice].guards.replan_margin_m, 0.4) << "0.4 m halts everywhere";
  EXPECT_EQ(best.all.unsafe_s, 0.0) << "its margin tells of the wall";
  EXPECT_GE(best.all.metres_per_minute(), 0.6 * fit.unguarded.metres_per_minute());
  GuardFitOptions strict = options;
  strict.most_lost = 0.01;
  EXPECT_FALSE(fit_guards(paths, 12, setup_of_test(), choices, {}, strict).best)
      << "who slows down at all is slower";
  GuardFitOptions stalling = options;
  stalling.stall_m = 0.05;
  EXPECT_FALSE(fit_guards(paths, 12, setup_of_test(), choices, {}, stalling).best)
      << "squash halts where there is no margin";
  EXPECT_EQ(fit.folds.size(), 5U);
  std::size_t days = 0;
  for (const GuardFold& fold : fit.folds) {
    days += fold.days;
  }
  EXPECT_EQ(days, 12U) << "each day is held out once";
  EXPECT_NEAR(fit.control.least_alpha, 1.0 / 13.0, 1e-12);
  EXPECT_TRUE(std::ranges::any_of(fit.scores, &GuardScore::on_front));
}

TEST(GuardFit, PromisesNothingWithTooFewDays) {
  const std::vector<GuardedPath> paths{path_of(0, false), path_of(1, false)};
  const auto choices = guard_choices({}, {SpeedLawKind::squash}, {20.0}, {0.0}, {5.0});
  GuardFitOptions options;
  options.most_lost = 1.0;
  options.risk = 0.3;
  options.declared.law.beta_per_m = 20.0;
  const GuardFit fit = fit_guards(paths, 2, setup_of_test(), choices, {}, options);
  EXPECT_FALSE(fit.control.epsilon_m) << "1/(n + 1) alone is above it";
}

}  // namespace
}  // namespace tcert::study
