#include "analysis/study/soundness/soundness_tally.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "analysis/study/truth/truth.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert::study {
namespace {

std::vector<WorldOutcome> study(const std::vector<SoundnessMethod>& methods,
                                std::size_t worlds,
                                WorldFamily (*family)(std::uint64_t) = mixed_family) {
  SoundnessOptions options;
  options.family = family;
  options.seed = 3;
  std::vector<WorldOutcome> outcomes(worlds);
  tbb::parallel_for(std::size_t{0}, worlds, [&](std::size_t i) {
    outcomes[i] = study_world(methods, options, i);
  });
  return outcomes;
}

SoundnessTally tally_of(const std::vector<WorldOutcome>& worlds) {
  SoundnessTally tally(worlds.front().outcomes.size(), {});
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    tally.add(worlds[i], i);
  }
  return tally;
}

SoundnessSummary summarise(const std::vector<WorldOutcome>& worlds, std::size_t method) {
  return tally_of(worlds).of_all(method);
}

std::size_t number_of(const std::vector<SoundnessMethod>& methods,
                      std::string_view name,
                      bool noise) {
  const auto found = std::find_if(methods.begin(), methods.end(), [&](const SoundnessMethod& m) {
    return m.name == name && m.noise == noise;
  });
  return static_cast<std::size_t>(found - methods.begin());
}

TEST(Soundness, OfTheSweptAreaIsNeverBrokenWithoutNoise) {
  const auto methods = mixed_methods();
  const auto hard = study(methods, 140, hard_family);
  EXPECT_EQ(summarise(hard, number_of(methods, "swept", false)).violations, 0U);
  EXPECT_GT(summarise(hard, number_of(methods, "width", false)).violations, 10U)
      << "tight ends, if nothing else";
  const auto worlds = study(methods, 300);
  const SoundnessSummary swept = summarise(worlds, number_of(methods, "swept", false));
  EXPECT_EQ(swept.violations, 0U);
  EXPECT_EQ(swept.spurious, 0U);
  EXPECT_GT(swept.issued, 100U);
  EXPECT_GT(swept.ticks, 50'000U);
  const SoundnessSummary optimistic =
      summarise(worlds, number_of(methods, "A2 (unknown=free)", false));
  EXPECT_GT(optimistic.violations, 200U);
  EXPECT_GT(optimistic.spurious, 0U);
}

TEST(Soundness, WithoutCurvatureTightTurnsAreCertifiedThatCannotBeDriven) {
  const auto methods = u_turn_methods();
  const auto worlds = study(methods, 60, u_turn_family);
  const SoundnessSummary full = summarise(worlds, number_of(methods, "width", false));
  const SoundnessSummary without = summarise(worlds, number_of(methods, "A3, width", false));
  EXPECT_GT(full.untraversable, 10U);
  EXPECT_EQ(full.spurious, 0U);
  EXPECT_GT(without.spurious, 5U);
  EXPECT_EQ(summarise(worlds, number_of(methods, "swept", false)).violations, 0U);
}

TEST(Soundness, OfWitnessesIsNeverBrokenWithoutNoise) {
  const auto methods = witness_methods();
  const auto worlds = study(methods, 60);
  const auto turns = study(methods, 12, u_turn_family);
  const auto hard = study(methods, 42, hard_family);
  for (const char* const name : {"witness", "witness, native rates"}) {
    EXPECT_EQ(summarise(hard, number_of(methods, name, false)).violations, 0U) << name;
    EXPECT_GT(summarise(hard, number_of(methods, name, false)).issued, 12U) << name;
  }
  const SoundnessSummary exact = summarise(worlds, number_of(methods, "witness", false));
  EXPECT_EQ(exact.violations, 0U);
  EXPECT_EQ(exact.spurious, 0U);
  EXPECT_GT(exact.issued, 30U);
  EXPECT_EQ(summarise(turns, number_of(methods, "witness", false)).violations, 0U);
  // What is taken off only lowers it, within what another path of the search may make of it.
  const SoundnessSummary noisy = summarise(worlds, number_of(methods, "witness", true));
  const SoundnessSummary lowered =
      summarise(worlds, number_of(methods, "witness, 10 mm off", true));
  EXPECT_LE(lowered.issued, noisy.issued);
  EXPECT_LE(lowered.violations, noisy.violations);
}

TEST(Soundness, IsTheSameForAnyNumberOfThreads) {
  const auto methods = mixed_methods();
  const auto many = study(methods, 40);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = study(methods, 40);
  for (std::size_t i = 0; i < many.size(); ++i) {
    ASSERT_EQ(many[i].truth_m, one[i].truth_m);
    ASSERT_EQ(many[i].ticks, one[i].ticks);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      ASSERT_EQ(many[i].outcomes[m].certificate_m, one[i].outcomes[m].certificate_m);
      ASSERT_EQ(many[i].outcomes[m].excess_m, one[i].outcomes[m].excess_m);
    }
  }
}

// What is known of a world by how it is built, against the distance transform of its obstacles.
TEST(Soundness, KnownValuesOfRandomWorldsAgreeWithTheGrid) {
  const Robot& robot = corpus_robot();
  for (std::size_t k = 0; k < kWorldFamilies; ++k) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const RandomWorld drawn = draw_random_world(static_cast<WorldFamily>(k), 5, i);
      const ClearanceValue grid = grid_clearance(drawn.world, 0.02).value;
      const double known = 0.5 * (upper_value(drawn, robot) + robot.body_width_m);
      EXPECT_LE(known, grid.upper_m + 3e-4) << drawn.world.name;
      EXPECT_GE(known, grid.lower_m) << drawn.world.name;
    }
  }
}

TEST(Soundness, ValueOfAUTurnIsTheBestClearance) {
  const Robot& robot = corpus_robot();
  for (double width = 0.46; width < 1.0; width += 0.03) {
    double best = ClearanceValue::kNoPath;
    for (int i = 0; i <= 20000; ++i) {
      const double d = 0.5 * width * i / 20000;
      best = std::max(
          best, std::min(2.0 * d - robot.body_width_m, width + 0.05 - d - robot.min_turn_radius_m));
    }
    EXPECT_NEAR(u_turn_value(width, 0.1, robot), best, 1e-4);
  }
  // Without a thickness: negative between the body's width and R_min + r_B.
  EXPECT_LT(u_turn_value(0.57, 0.0, robot), 0.0);
  EXPECT_GT(u_turn_value(0.58, 0.0, robot), 0.0);
}

// A path that the search with the turning limit finds round the wall is no better than the formula.
TEST(Soundness, NoPathThatIsFoundBeatsTheValueOfAUTurn) {
  const Robot& robot = corpus_robot();
  for (const std::uint64_t i : {0, 1, 2}) {
    const RandomWorld drawn = draw_random_world(WorldFamily::u_turn, 5, i);
    const Truth found = truth_of(drawn.world, robot, {});
    EXPECT_LE(found.lower_m, u_turn_value(drawn.corridor_m, drawn.wall_m, robot) + 1e-9)
        << drawn.world.name;
  }
}

TEST(Soundness, SummaryCountsWorlds) {
  const auto world = [](double truth, double certificate, std::uint32_t over, bool issued) {
    WorldOutcome outcome;
    outcome.truth_m = truth;
    outcome.ticks = 10;
    outcome.reached = true;
    outcome.outcomes = {{certificate, certificate - truth, over, issued}};
    return outcome;
  };
  const std::vector<WorldOutcome> worlds{world(0.1, 0.08, 0, true),
                                         world(0.1, 0.13, 4, true),
                                         world(-0.1, 0.02, 2, true),
                                         world(-0.1, ClearanceValue::kNoPath, 0, false)};
  const SoundnessSummary summary = summarise(worlds, 0);
  EXPECT_EQ(summary.worlds, 4U);
  EXPECT_EQ(summary.ticks, 40U);
  EXPECT_EQ(summary.issued, 3U);
  EXPECT_EQ(summary.untraversable, 2U);
  EXPECT_EQ(summary.spurious, 1U);
  EXPECT_EQ(summary.violations, 2U);
  EXPECT_EQ(summary.violating_ticks, 6U);
  EXPECT_NEAR(summary.largest_excess_m, 0.12, 1e-12);
  EXPECT_EQ(summary.worst_world, 2U);
  EXPECT_NEAR(
      summary.violation_bound(), 0.9024, 1e-4);  // R: binom.test(2, 4, alternative = "less")
  const auto tightness = tally_of(worlds).tightness(0);
  ASSERT_EQ(tightness.size(), 1U);
  EXPECT_EQ(tightness[0].worlds, 3U);
  EXPECT_NEAR(tightness[0].median_m, -0.03, 1e-12);
}

TEST(Soundness, TheWorstWorldIsTheOneOfTheLargestExcess) {
  const auto methods = mixed_methods();
  const SoundnessTally tally = tally_of(study(methods, 40));
  SoundnessOptions options;
  options.seed = 3;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const SoundnessSummary& all = tally.of_all(m);
    ASSERT_EQ(all.worst_world.has_value(), all.violations > 0) << methods[m].name;
    if (all.worst_world) {
      const WorldOutcome again = study_world({methods[m]}, options, *all.worst_world);
      EXPECT_EQ(again.outcomes.front().excess_m, all.largest_excess_m) << methods[m].name;
    }
  }
}

TEST(Soundness, AnOutcomeReadsBackFromItsRow) {
  const auto methods = mixed_methods();
  for (const WorldOutcome& world : study(methods, 20)) {
    const std::string text = table::row_text(world);
    EXPECT_EQ(table::row_text(table::from_row<WorldOutcome>(text)), text);
    EXPECT_THROW(static_cast<void>(table::from_row<WorldOutcome>(text + ",1")), table::RowError);
    EXPECT_THROW(static_cast<void>(table::from_row<WorldOutcome>(text.substr(0, text.rfind(',')))),
                 table::RowError);
  }
}

}  // namespace
}  // namespace tcert::study
