#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>

#include "support/allocations.hpp"
#include "support/lap.hpp"
#include "support/random_run.hpp"
#include "support/widest_oracle.hpp"

namespace tcert {
namespace {

using test_support::random_run;
using RandomRun = test_support::Run;

constexpr double kNoPath = -std::numeric_limits<double>::infinity();
constexpr std::uint32_t kRuns = 60;
constexpr std::size_t kTicks = 1500;

std::vector<CertifiedTick> certify(const RandomRun& run,
                                   const CertificateParameters& parameters = {}) {
  Certifier certifier(run.robot, run.course, parameters);
  std::vector<CertifiedTick> series;
  for (const Tick& tick : run.ticks) {
    series.push_back(certifier.update(tick));
  }
  return series;
}

CertificateParameters reading(ClearanceReading clearance) {
  CertificateParameters parameters;
  parameters.clearance = clearance;
  return parameters;
}

// NaN equals NaN, and nothing else is forgiven.
bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_same(const CertifiedTick& a, const CertifiedTick& b) {
  for (const auto member : {&CertifiedTick::travel_m,
                            &CertifiedTick::left_m,
                            &CertifiedTick::right_m,
                            &CertifiedTick::width_m,
                            &CertifiedTick::turn_radius_m,
                            &CertifiedTick::margin_m,
                            &CertifiedTick::edge_margin_m,
                            &CertifiedTick::memory,
                            &CertifiedTick::corridor_value_m,
                            &CertifiedTick::certificate_m}) {
    ASSERT_TRUE(same_bits(a.*member, b.*member)) << a.*member << " and " << b.*member;
  }
  ASSERT_EQ(a.flags, b.flags);
  ASSERT_EQ(a.nodes, b.nodes);
  ASSERT_EQ(a.edges, b.edges);
  ASSERT_EQ(a.contacts, b.contacts);
}

TEST(Certifier, NeverFallsAndEqualsASearchFromScratchAtEveryTick) {
  for (const auto clearance : {ClearanceReading::width, ClearanceReading::swept}) {
    std::size_t connected = 0;
    for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
      SCOPED_TRACE(seed);
      const RandomRun run = random_run(seed, kTicks);
      Certifier certifier(run.robot, run.course, reading(clearance));
      double last = kNoPath;
      std::uint32_t last_edges = 0;
      for (const Tick& tick : run.ticks) {
        const CertifiedTick now = certifier.update(tick);
        ASSERT_GE(now.certificate_m, last);
        // A search costs; the graph changes only where an edge is new or, seldom, where one rises.
        if (now.edges != last_edges || now.certificate_m > last ||
            tick.time_ns % 1'000'000'000 == 0) {
          const bool tied = (now.flags & flag_start_outside) == 0;
          ASSERT_EQ(now.certificate_m,
                    test_support::certificate_by_search(certifier.graph(), tied));
          last_edges = now.edges;
        }
        last = now.certificate_m;
      }
      connected += last > kNoPath ? 1 : 0;
    }
    EXPECT_GT(connected, kRuns / 4) << "too few runs reach G to test anything";
  }
}

TEST(Certifier, WithoutCurvatureItIsNeverSmaller) {
  CertificateParameters no_curvature;
  no_curvature.curvature = CurvatureReading::none;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    for (const auto& [reading, clearance] :
         {std::pair{CurvatureReading::path, ClearanceReading::width},
          std::pair{CurvatureReading::contact, ClearanceReading::width},
          std::pair{CurvatureReading::contact_literal, ClearanceReading::width},
          std::pair{CurvatureReading::path, ClearanceReading::swept}}) {
      CertificateParameters full;
      full.curvature = reading;
      full.clearance = no_curvature.clearance = clearance;
      const auto with = certify(run, full);
      const auto without = certify(run, no_curvature);
      for (std::size_t k = 0; k < with.size(); ++k) {
        ASSERT_LE(with[k].certificate_m, without[k].certificate_m);
        ASSERT_LE(with[k].corridor_value_m, without[k].corridor_value_m);
      }
    }
  }
}

TEST(Certifier, TheSweptAreaChangesNothingButTheCertificate) {
  bool differs = false;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    const auto width = certify(run);
    auto swept = certify(run, reading(ClearanceReading::swept));
    for (std::size_t k = 0; k < width.size(); ++k) {
      differs = differs || swept[k].certificate_m != width[k].certificate_m;
      swept[k].certificate_m = width[k].certificate_m;
      expect_same(width[k], swept[k]);
    }
    if (testing::Test::HasFatalFailure()) {
      return;
    }
  }
  EXPECT_TRUE(differs);
}

TEST(Certifier, WithoutMemoryTheCorridorValueIsNeverSmaller) {
  CertificateParameters no_memory;
  no_memory.memory_weight_m = 0.0;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    const auto with = certify(run);
    const auto without = certify(run, no_memory);
    bool differs = false;
    for (std::size_t k = 0; k < with.size(); ++k) {
      ASSERT_LE(with[k].corridor_value_m, without[k].corridor_value_m);
      ASSERT_EQ(with[k].certificate_m, without[k].certificate_m);
      differs = differs || with[k].corridor_value_m < without[k].corridor_value_m;
    }
    EXPECT_TRUE(differs || with.back().corridor_value_m == kNoPath);
  }
}

void expect_same_later_and_in_the_mirror(const CertificateParameters& parameters) {
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    const auto plain = certify(run, parameters);
    const auto later =
        certify(test_support::shifted_in_time(run, 1'700'000'000'123'456'789), parameters);
    const auto mirror = certify(test_support::mirrored(run), parameters);
    for (std::size_t k = 0; k < plain.size(); ++k) {
      expect_same(plain[k], later[k]);
      ASSERT_TRUE(same_bits(plain[k].left_m, mirror[k].right_m));
      ASSERT_TRUE(same_bits(plain[k].margin_m, mirror[k].margin_m));
      ASSERT_TRUE(same_bits(plain[k].corridor_value_m, mirror[k].corridor_value_m));
      ASSERT_TRUE(same_bits(plain[k].certificate_m, mirror[k].certificate_m));
    }
    if (testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(Certifier, IsTheSameAtAnotherTimeAndInTheMirror) {
  expect_same_later_and_in_the_mirror({});
  expect_same_later_and_in_the_mirror(reading(ClearanceReading::swept));
}

void expect_near_series(const std::vector<CertifiedTick>& plain,
                        const std::vector<CertifiedTick>& other,
                        double scale) {
  for (std::size_t k = 0; k < plain.size(); ++k) {
    if (plain[k].certificate_m == kNoPath) {
      ASSERT_EQ(other[k].certificate_m, kNoPath) << "tick " << k;
    } else {
      ASSERT_NEAR(other[k].certificate_m, scale * plain[k].certificate_m, 1e-9) << "tick " << k;
    }
    if (plain[k].corridor_value_m != kNoPath) {
      ASSERT_NEAR(other[k].corridor_value_m, scale * plain[k].corridor_value_m, 1e-9);
    }
  }
}

TEST(Certifier, IsTheSameInAnotherFrameOfReference) {
  for (const auto clearance : {ClearanceReading::width, ClearanceReading::swept}) {
    CertificateParameters no_memory = reading(clearance);
    no_memory.memory_weight_m = 0.0;
    for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
      SCOPED_TRACE(seed);
      const RandomRun run = random_run(seed, kTicks);
      expect_near_series(certify(run, no_memory),
                         certify(test_support::moved(run, 0.7, {12.0, -5.0}), no_memory),
                         1.0);
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

// Ticks exactly one dead band apart, and windows that are whole numbers of them: in another frame
// each comparison is of lengths that differ in their last bits.
TEST(Certifier, AStepOfExactlyTheDeadBandIsTheSameInEveryFrame) {
  RandomRun run = random_run(5, 400);
  for (std::size_t k = 0; k < run.ticks.size(); ++k) {
    Tick& tick = run.ticks[k];
    tick.pose = {{0.0037 + 0.01 * static_cast<double>(k), 0.0}, 0.0};  // on no border of S or G
    tick.stale = tick.segment_start = false;
  }
  CertificateParameters no_memory;
  no_memory.memory_weight_m = 0.0;
  for (const double yaw_rad : {0.1, 0.7, 1.3, 2.9}) {
    SCOPED_TRACE(yaw_rad);
    const auto plain = certify(run, no_memory);
    const auto other = certify(test_support::moved(run, yaw_rad, {3.0, -1.0}), no_memory);
    expect_near_series(plain, other, 1.0);
    for (std::size_t k = 0; k < plain.size(); ++k) {
      ASSERT_NEAR(plain[k].margin_m, other[k].margin_m, 1e-9) << "tick " << k;
      ASSERT_NEAR(plain[k].travel_m, other[k].travel_m, 1e-9);
      ASSERT_EQ(plain[k].nodes, other[k].nodes);
    }
  }
}

TEST(Certifier, ScalesWithEveryLength) {
  CertificateParameters plain;
  plain.memory_weight_m = 0.0;
  CertificateParameters doubled = plain;
  for (const auto member : {&CertificateParameters::side_window_m,
                            &CertificateParameters::travel_deadband_m,
                            &CertificateParameters::swept_cell_m,
                            &CertificateParameters::least_obstacle_m,
                            &CertificateParameters::swept_lag_m,
                            &CertificateParameters::curvature_window_m,
                            &CertificateParameters::curvature_min_travel_m,
                            &CertificateParameters::contact_spacing_m,
                            &CertificateParameters::contact_literal_spacing_m,
                            &CertificateParameters::contact_window_m,
                            &CertificateParameters::sigma_contact_m,
                            &CertificateParameters::contact_slack_m,
                            &CertificateParameters::edge_length_m,
                            &CertificateParameters::merge_radius_m,
                            &CertificateParameters::reversal_m,
                            &CertificateParameters::max_step_m,
                            &CertificateParameters::memory_cell_m,
                            &CertificateParameters::memory_sigma_m}) {
    doubled.*member *= 3.0;
  }
  doubled.min_curvature_per_m /= 3.0;
  for (const auto& [curvature, clearance] :
       {std::pair{CurvatureReading::path, ClearanceReading::width},
        std::pair{CurvatureReading::contact, ClearanceReading::width},
        std::pair{CurvatureReading::path, ClearanceReading::swept}}) {
    plain.curvature = doubled.curvature = curvature;
    plain.clearance = doubled.clearance = clearance;
    for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
      SCOPED_TRACE(seed);
      const RandomRun run = random_run(seed, kTicks);
      expect_near_series(
          certify(run, plain), certify(test_support::scaled(run, 3.0), doubled), 3.0);
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(Certifier, KnowsNothingOfTheFuture) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    const auto parameters = reading(seed < 10 ? ClearanceReading::width : ClearanceReading::swept);
    const auto whole = certify(run, parameters);
    for (const std::size_t cut : {std::size_t{1}, std::size_t{17}, kTicks / 3, kTicks - 1}) {
      RandomRun start = run;
      start.ticks.resize(cut);
      const auto part = certify(start, parameters);
      for (std::size_t k = 0; k < cut; ++k) {
        expect_same(part[k], whole[k]);
      }
    }
  }
}

TEST(Certifier, ResetForgetsTheTrial) {
  const RandomRun first = random_run(1, kTicks);
  const RandomRun second = random_run(2, kTicks);
  for (const auto clearance : {ClearanceReading::width, ClearanceReading::swept}) {
    const auto fresh = certify(second, reading(clearance));
    Certifier certifier(first.robot, first.course, reading(clearance));
    for (const Tick& tick : first.ticks) {
      certifier.update(tick);
    }
    certifier.reset();
    for (std::size_t k = 0; k < kTicks; ++k) {
      // Both runs have the same robot and course.
      expect_same(certifier.update(second.ticks[k]), fresh[k]);
    }
  }
}

TEST(Certifier, ASmallCapacityNeverCertifiesMore) {
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    const auto large = certify(run);
    for (const auto& [nodes, edges] : {std::pair{20U, 1000U}, std::pair{1000U, 20U}}) {
      CertificateParameters parameters;
      parameters.max_nodes = nodes;
      parameters.max_edges = edges;
      const auto small = certify(run, parameters);
      for (std::size_t k = 0; k < kTicks; ++k) {
        ASSERT_LE(small[k].certificate_m, large[k].certificate_m) << "tick " << k;
      }
      ASSERT_EQ((small.back().flags & flag_capacity_exceeded) != 0,
                large.back().nodes > nodes || large.back().edges > edges);
    }
  }
}

TEST(Certifier, RaisesNoMoreLabelsATickThanTheGraphBounds) {
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    for (const CertifiedTick& tick : certify(random_run(seed, kTicks))) {
      ASSERT_LE(tick.labels_raised, 8 * (tick.edges + 2));
    }
  }
}

// The worst case: one narrow place at the start of a long corridor turns out to be wide, and every
// label behind it rises at one tick.
TEST(Certifier, RaisesAWholeCorridorAtOneTickAndStaysWithinTheBound) {
  const test_support::Lap lap = test_support::make_lap(500);
  Certifier certifier(lap.robot, lap.course, {});
  std::uint32_t most = 0;
  for (std::size_t k = 0; k < 2 * lap.poses.size() + 100; ++k) {
    const bool narrow = k >= 40 && k < 60;
    const double range_m = narrow ? 0.3 : 0.5;
    const std::array<RayReading, 3> readings{{{range_m, 0.0}, {range_m, 0.0}, {0.5, 0.0}}};
    const auto time_ns = static_cast<std::int64_t>(k) * 100'000'000;
    const CertifiedTick tick =
        certifier.update({time_ns, lap.poses[k % lap.poses.size()], readings, false, false});
    ASSERT_LE(tick.labels_raised, 8 * (tick.edges + 2));
    most = std::max(most, tick.labels_raised);
  }
  EXPECT_GT(most, 900U) << "not the worst case";
}

TEST(Certifier, SaysWhenContactMemoryGaveWay) {
  const test_support::Lap lap = test_support::make_lap(200);
  CertificateParameters parameters;
  parameters.max_memory_cells = 256;
  Certifier certifier(lap.robot, lap.course, parameters);
  Certifier roomy(lap.robot, lap.course, {});
  std::uint32_t flags = 0;
  for (std::size_t k = 0; k < lap.poses.size(); ++k) {
    const std::array<RayReading, 3> readings{{{0.4, 1.0}, {0.4, 1.0}, {0.5, 0.0}}};
    const Tick tick{
        static_cast<std::int64_t>(k) * 100'000'000, lap.poses[k], readings, false, false};
    const CertifiedTick now = certifier.update(tick);
    const CertifiedTick expected = roomy.update(tick);
    ASSERT_EQ(expected.flags & flag_memory_evicted, 0U);
    ASSERT_EQ(now.certificate_m, expected.certificate_m);
    ASSERT_EQ(flags & ~now.flags & flag_memory_evicted, 0U) << "it stays set";
    flags = now.flags;
  }
  EXPECT_NE(flags & flag_memory_evicted, 0U);
  certifier.reset();
  EXPECT_EQ(certifier.update({0, lap.poses[0], {}, false, false}).flags, flag_bad_input);
}

TEST(Certifier, SmallRoomForSweptCellsNeverCertifiesMore) {
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    auto parameters = reading(ClearanceReading::swept);
    const auto large = certify(run, parameters);
    parameters.max_swept_cells = 2048;
    const auto small = certify(run, parameters);
    for (std::size_t k = 0; k < kTicks; ++k) {
      ASSERT_LE(small[k].certificate_m, large[k].certificate_m) << "tick " << k;
    }
    ASSERT_NE(small.back().flags & flag_capacity_exceeded, 0U);
    ASSERT_EQ(large.back().flags & flag_capacity_exceeded, 0U);
  }
}

TEST(Certifier, UpdateAllocatesNothing) {
  const RandomRun run = random_run(3, 5000);
  for (const auto& [curvature, clearance] :
       {std::pair{CurvatureReading::path, ClearanceReading::width},
        std::pair{CurvatureReading::contact, ClearanceReading::width},
        std::pair{CurvatureReading::path, ClearanceReading::swept}}) {
    CertificateParameters parameters = reading(clearance);
    parameters.curvature = curvature;
    Certifier certifier(run.robot, run.course, parameters);
    const std::size_t before = test_support::allocation_count();
    const std::size_t mallocs = test_support::malloc_count();
    for (const Tick& tick : run.ticks) {
      certifier.update(tick);
    }
    certifier.reset();
    EXPECT_EQ(test_support::allocation_count(), before);
    EXPECT_EQ(test_support::malloc_count(), mallocs);
  }
}

TEST(Certifier, AnOptimisticCertificateIsThereFromTheStartAndMayFall) {
  CertificateParameters optimistic;
  optimistic.unknown = UnknownSpace::free;
  bool falls = false;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    const RandomRun run = random_run(seed, kTicks);
    const auto pessimist = certify(run);
    const auto optimist = certify(run, optimistic);
    for (std::size_t k = 1; k < kTicks; ++k) {
      ASSERT_GE(optimist[k].certificate_m, pessimist[k].certificate_m);
      falls = falls || optimist[k].certificate_m < optimist[k - 1].certificate_m;
    }
    if ((optimist[0].flags & (flag_start_outside | flag_stale)) == 0) {
      // Reach 0.8 on both sides, mounted 0.1 out, less the body.
      EXPECT_NEAR(optimist[0].certificate_m, 1.8 - 0.45, 1e-12);
    }
  }
  EXPECT_TRUE(falls);
}

TEST(Certifier, NamesTheBottleneckOfItsCertificate) {
  std::size_t found = 0;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRun run = random_run(seed, kTicks);
    Certifier certifier(run.robot, run.course, {});
    CertifiedTick last;
    for (const Tick& tick : run.ticks) {
      last = certifier.update(tick);
    }
    const auto bottleneck = certifier.bottleneck();
    ASSERT_EQ(bottleneck.has_value(), last.certificate_m > kNoPath);
    if (bottleneck) {
      ++found;
      EXPECT_EQ(bottleneck->margin_m, last.certificate_m);
      EXPECT_EQ(bottleneck->margin_m, certifier.graph().edges()[bottleneck->edge].pass.margin_m);
    }
  }
  EXPECT_GT(found, 0U);
}

}  // namespace
}  // namespace tcert
