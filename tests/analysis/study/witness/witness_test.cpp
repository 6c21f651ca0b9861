#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>

#include "analysis/study/soundness/soundness.hpp"
#include "analysis/study/trials/certify_trial.hpp"
#include "analysis/study/truth/obstacle_distance.hpp"
#include "analysis/study/truth/truth.hpp"
#include "analysis/study/witness/felt_samples.hpp"
#include "analysis/study/witness/prove_trial.hpp"
#include "analysis/study/witness/witness_looks.hpp"
#include "datasets/bundle.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"
#include "datasets/worlds/world_problems.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::study {
namespace {

namespace fs = std::filesystem;

double truth_of_drawn(const RandomWorld& drawn) {
  return drawn.family == WorldFamily::u_turn
             ? u_turn_value(drawn.corridor_m, drawn.wall_m, corpus_robot())
             : upper_value(drawn, corpus_robot());
}

// With readings and poses that are true no witness claims more than there is, in any family.
TEST(Witness, NeverExceedsTheTruthOfRandomWorldsWithoutNoise) {
  std::size_t witnesses = 0;
  std::size_t issued = 0;
  for (std::uint64_t index = 0; index < 160; ++index) {
    const WorldFamily family = index % 4 == 3 ? WorldFamily::u_turn : mixed_family(index);
    const RandomWorld drawn = draw_random_world(family, 9, index);
    const WallIndex walls = feelable_walls(drawn);
    const TickTable felt = true_ticks(follow_legs(drawn, walls, 9, index), walls);
    const Proof proof = prove(felt_samples(felt, corpus_robot()),
                              corpus_robot(),
                              {drawn.world.start, drawn.world.goal},
                              {},
                              {});
    if (proof.witness) {
      ++witnesses;
      issued += *proof.certificate_m() > 0.0 ? 1U : 0U;
      EXPECT_LE(*proof.certificate_m(), truth_of_drawn(drawn) + 1e-9) << index;
    } else {
      EXPECT_NE(proof.reason, "") << index;
    }
  }
  EXPECT_GT(witnesses, 100U);
  EXPECT_GT(issued, 70U);
}

/// The least distance from the places of a path, about a centimetre apart, to what is not free.
double least_distance(const witness::Path& path, const ObstacleDistance& obstacles) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const witness::Piece& piece : path) {
    const double parts = std::ceil(witness::chord(piece) / 0.01);
    for (double k = 0.0; k <= parts; ++k) {
      least_m = std::min(least_m, obstacles.at(witness::point_at(piece, k / parts)));
    }
  }
  return least_m;
}

// What an edge proves is there: nothing of the world is nearer to its path than that. And no chain
// of edges proves more of S and G than there is.
TEST(Witness, EdgesProveNoMoreThanTheWorldHas) {
  std::size_t proven = 0;
  std::size_t edges = 0;
  std::size_t chains = 0;
  for (std::uint64_t index = 0; index < 48; ++index) {
    const WorldFamily family = index % 4 == 3 ? WorldFamily::u_turn : mixed_family(index);
    const RandomWorld drawn = draw_random_world(family, 9, index);
    const WallIndex walls = feelable_walls(drawn);
    const TickTable felt = true_ticks(follow_legs(drawn, walls, 9, index), walls);
    const Course course{drawn.world.start, drawn.world.goal};
    Certifier certifier(corpus_robot(), course, {});
    const TrialSeries series = certify_trial(certifier, felt);
    const Proof proof =
        prove(felt_samples(felt, corpus_robot()), corpus_robot(), course, {}, {}, &series);
    ASSERT_TRUE(proof.edges) << proof.reason;
    const ObstacleDistance obstacles(drawn.world);
    for (const auto& path : proof.edges->found.paths) {
      ++edges;
      if (path) {
        EXPECT_LE(path->checked.clearance_m, least_distance(path->path, obstacles) + 1e-9) << index;
      }
    }
    proven += proof.edges->proven();
    if (proof.edges->chain_m) {
      ++chains;
      EXPECT_LE(*proof.edges->chain_m, truth_of_drawn(drawn) + 1e-9) << index;
    }
  }
  EXPECT_GT(2 * proven, edges);
  EXPECT_GT(chains, 24U);
}

/// True if every free cell of the one is free in the other.
bool is_within(const witness::FreeCells& less, const witness::FreeCells& more) {
  const witness::Lattice& box = less.lattice();
  const auto right = static_cast<int>(box.first_x - more.lattice().first_x);
  const auto up = static_cast<int>(box.first_y - more.lattice().first_y);
  for (int row = 0; row < box.rows; ++row) {
    for (int column = 0; column < box.columns; ++column) {
      if (less.is_free(column, row) && !more.is_free(column + right, row + up)) {
        return false;
      }
    }
  }
  return true;
}

// What was free is free later, though glitches are told by what is felt after them; so a path found
// then proves at least as much of all that was felt, and no look exceeds the truth.
TEST(Witness, WhatWasProvedWhileARunWentOnStaysProved) {
  std::mt19937_64 engine(11);
  witness::WitnessParameters parameters;
  parameters.witness_every = 12;
  std::size_t looks = 0;
  std::size_t glitches = 0;
  for (std::uint64_t index = 0; index < 24; ++index) {
    const WorldFamily family = index % 4 == 3 ? WorldFamily::u_turn : mixed_family(index);
    const RandomWorld drawn = draw_random_world(family, 9, index);
    const WallIndex walls = feelable_walls(drawn);
    TickTable felt = true_ticks(follow_legs(drawn, walls, 9, index), walls);
    for (RayReading& reading : felt.readings) {
      if (engine() % 50 == 0) {  // a glitch, which is too small
        reading.value *= 0.3;
        ++glitches;
      }
    }
    const Course course{drawn.world.start, drawn.world.goal};
    Certifier certifier(corpus_robot(), course, {});
    const TrialSeries series = certify_trial(certifier, felt);
    const witness::Samples samples = felt_samples(felt, corpus_robot());
    witness::Samples ready = samples;
    witness::drop_glitches(
        ready, corpus_robot(), witness::free_space_options(parameters, {}).strips.lost_share);
    Proof proof = prove(ready, corpus_robot(), course, parameters, {});
    witness::FreeCells before;
    for (std::size_t i = 11; i + 1 < series.ticks.size(); i += 60) {
      const Proof now =
          prove_so_far(samples, series.ticks[i].time_ns, corpus_robot(), course, parameters, {});
      EXPECT_TRUE(is_within(before, now.cells)) << index << " at tick " << i;
      EXPECT_TRUE(is_within(now.cells, proof.cells)) << index << " at tick " << i;
      before = now.cells;
    }
    for (const WitnessLook& look :
         witness_looks(samples, series.ticks, corpus_robot(), course, parameters, {})) {
      ++looks;
      EXPECT_EQ((look.tick + 1) % 12, 0U);
      EXPECT_LE(look.found.checked.margin_m, truth_of_drawn(drawn) + 1e-9) << index;
      std::vector<WitnessLook> one{look};
      keep_best(one, corpus_robot(), course, proof);
      EXPECT_EQ(one.size(), 1U) << "it is within what was felt in the end";
      ASSERT_TRUE(proof.certificate_m());
      EXPECT_GE(*proof.certificate_m(), look.found.checked.margin_m) << index;
    }
  }
  EXPECT_GT(looks, 40U);
  EXPECT_GT(glitches, 100U);
}

// What the whole run has no room for is claimed at no time: no file could hold it.
TEST(Witness, ALookCountsOnlyWithAWitnessInTheEnd) {
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 9, 2);
  const WallIndex walls = feelable_walls(drawn);
  const TickTable felt = true_ticks(follow_legs(drawn, walls, 9, 2), walls);
  const Course course{drawn.world.start, drawn.world.goal};
  Proof proof = prove(felt_samples(felt, corpus_robot()), corpus_robot(), course, {}, {});
  ASSERT_TRUE(proof.witness);
  std::vector<WitnessLook> looks{{3, *proof.witness}};
  Proof none;
  none.start = proof.start;
  none.reason = "no room";
  keep_best(looks, corpus_robot(), course, none);
  EXPECT_TRUE(looks.empty());
  EXPECT_FALSE(none.witness);
  EXPECT_EQ(none.reason, "no room");
}

TEST(Witness, AReadingBoundOnlyLowersIt) {
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 9, 2);
  const WallIndex walls = feelable_walls(drawn);
  const TickTable felt = true_ticks(follow_legs(drawn, walls, 9, 2), walls);
  const Course course{drawn.world.start, drawn.world.goal};
  witness::WitnessParameters parameters;
  const auto margin = [&] {
    return prove(felt_samples(felt, corpus_robot()), corpus_robot(), course, parameters, {})
        .certificate_m();
  };
  const auto exact = margin();
  parameters.reading_bound_m = 0.01;
  const auto lowered = margin();
  ASSERT_TRUE(exact && lowered);
  EXPECT_LT(*lowered, *exact - 0.010);
  EXPECT_GT(*lowered, *exact - 0.035);  // twice the bound, and cells
}

TEST(Witness, ItsBitsAreThoseOfAnyOtherRun) {
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 9, 2);
  const WallIndex walls = feelable_walls(drawn);
  const TickTable felt = true_ticks(follow_legs(drawn, walls, 9, 2), walls);
  const Course course{drawn.world.start, drawn.world.goal};
  const witness::Samples samples = felt_samples(felt, corpus_robot());
  const Proof one = prove(samples, corpus_robot(), course, {}, {});
  const Proof two = prove(samples, corpus_robot(), course, {}, {});
  ASSERT_TRUE(one.witness && two.witness);
  EXPECT_TRUE(one.cells == two.cells);
  EXPECT_EQ(one.witness->path, two.witness->path);
}

TEST(Witness, TellsWhatIsMissing) {
  const Robot& robot = corpus_robot();
  const Disc goal{{2.0, 0.0}, 0.2};
  EXPECT_EQ(prove({}, robot, {std::nullopt, goal}, {}, {}).reason, "no touch has a pose");
  EXPECT_EQ(prove({}, robot, {goal, std::nullopt}, {}, {}).reason, "the course has no goal");
  const RandomWorld drawn = draw_random_world(WorldFamily::discs, 9, 2);
  const WallIndex walls = feelable_walls(drawn);
  const witness::Samples samples =
      felt_samples(true_ticks(follow_legs(drawn, walls, 9, 2), walls), robot);
  witness::WitnessParameters parameters;
  parameters.max_witness_cells = 1000;
  EXPECT_NE(prove(samples, robot, {drawn.world.start, goal}, parameters, {})
                .reason.find("max_witness_cells"),
            std::string::npos);
  EXPECT_EQ(prove(samples, robot, {drawn.world.start, drawn.world.start}, {}, {}).reason,
            "S and G overlap");
}

/// Cases in which another reading exceeded the truth: beside the folder of real data.
fs::path cases_folder() {
  return test_support::shared_data().parent_path() / "cases" / "certificate";
}

// T by clearance alone, no turn limit: an upper bound of T with it.
TEST(Witness, NeverExceedsTheTruthOfTheCases) {
  if (!fs::exists(cases_folder())) {
    GTEST_SKIP() << "there is no " << cases_folder();
  }
  std::size_t checked = 0;
  for (const auto& entry : fs::recursive_directory_iterator(cases_folder())) {
    if (entry.path().filename() != "bundle.json") {
      continue;
    }
    const fs::path folder = entry.path().parent_path();
    const BundleResult opened = open_bundle(folder);
    if (!opened.bundle) {
      continue;  // nothing is issued for a bundle that is refused
    }
    const Bundle& bundle = *opened.bundle;
    for (const TrialRow& row : bundle.trials) {
      const TrialResult read = read_trial(bundle, row);
      ASSERT_TRUE(read.log) << folder;
      CertificateParameters certificate;
      if (folder.filename().string().find("20deg") != std::string::npos) {
        certificate.sharpest_corner_rad = 0.349;  // what its wedges keep
      }
      const Proof proof = prove(witness_samples(*read.log, bundle.info.robot, {}, certificate),
                                bundle.info.robot,
                                bundle.info.course,
                                {},
                                certificate);
      const fs::path world_file = folder / "worlds" / (row.trial_id + ".json");
      if (!proof.certificate_m() || *proof.certificate_m() <= 0.0 || !fs::exists(world_file)) {
        continue;
      }
      TruthOptions options;
      options.curvature = false;
      options.step_m = 0.005;
      const Truth truth = truth_of(
          world_from_json(test_support::read_text(world_file)), bundle.info.robot, options);
      ++checked;
      EXPECT_LE(*proof.certificate_m(), truth.upper_m) << folder;
    }
  }
  EXPECT_GT(checked, 0U);
}

}  // namespace
}  // namespace tcert::study
