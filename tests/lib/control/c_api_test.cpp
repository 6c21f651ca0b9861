#include <gtest/gtest.h>

#include <tcert/tcert.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>
#include <vector>

#include "support/allocations.hpp"
#include "support/c_words.hpp"
#include "support/random_run.hpp"

namespace tcert {
namespace {

using test_support::random_run;

using test_support::CSetup;
using test_support::empty_output;
using test_support::to_c;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_same(const tcert_output& c, const CertifiedTick& tick, const GuardedTick& guarded) {
  for (const auto& [of_c, of_cpp] : {std::pair{c.travel_m, tick.travel_m},
                                     {c.left_m, tick.left_m},
                                     {c.right_m, tick.right_m},
                                     {c.width_m, tick.width_m},
                                     {c.turn_radius_m, tick.turn_radius_m},
                                     {c.margin_m, tick.margin_m},
                                     {c.edge_margin_m, tick.edge_margin_m},
                                     {c.memory, tick.memory},
                                     {c.corridor_value_m, tick.corridor_value_m},
                                     {c.certificate_m, tick.certificate_m},
                                     {c.series_m, series_value(tick)},
                                     {c.tracking_error_m, guarded.tracking_error_m},
                                     {c.robust_margin_m, guarded.robust_margin_m},
                                     {c.force_n, guarded.force_n},
                                     {c.force_limit_n, guarded.force_limit_n},
                                     {c.speed_mps, guarded.speed_mps},
                                     {c.retreat_speed_mps, guarded.retreat_speed_mps}}) {
    ASSERT_TRUE(same_bits(of_c, of_cpp)) << of_c << " and " << of_cpp;
  }
  ASSERT_EQ(c.time_ns, tick.time_ns);
  ASSERT_EQ(c.flags, tick.flags);
  ASSERT_EQ(c.contacts, tick.contacts);
  ASSERT_EQ(c.new_contacts, tick.new_contacts);
  ASSERT_EQ(c.nodes, tick.nodes);
  ASSERT_EQ(c.edges, tick.edges);
  ASSERT_EQ(c.labels_raised, tick.labels_raised);
  ASSERT_EQ(c.issued != 0, tick.issued);
  ASSERT_EQ(c.triggers, guarded.triggers);
  ASSERT_EQ(c.triggers_began, guarded.began);
}

TEST(CApi, GivesTheBitsOfTheCppInterfaceWithoutAnAllocation) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const test_support::Run run = random_run(seed, 800);
    CSetup c(run.robot, run.course);
    c.parameters.speed_law = seed % 2 == 0 ? TCERT_SQUASH : TCERT_CLIP;
    c.parameters.beta_per_m = 7.0;
    c.parameters.guard_mode = TCERT_GUARDS_ACT;
    tcert_certifier* certifier = nullptr;
    ASSERT_EQ(c.create(certifier), TCERT_OK) << c.message.data();
    Certifier expected(run.robot, run.course, {});
    SpeedLaw law;
    law.kind = seed % 2 == 0 ? SpeedLawKind::squash : SpeedLawKind::clip;
    law.beta_per_m = 7.0;
    GuardParameters guard_parameters;
    guard_parameters.mode = GuardMode::act;
    Guards guards({run.robot, {}, law, guard_parameters, TrackingErrorTable()});
    std::vector<tcert_reading> readings(run.robot.rays.size());
    for (int pass = 0; pass < 2; ++pass) {
      for (const Tick& tick : run.ticks) {
        const tcert_tick of_c = to_c(tick, readings);
        tcert_output out = empty_output();
        const std::size_t before = test_support::allocation_count();
        const std::size_t mallocs = test_support::malloc_count();
        ASSERT_EQ(tcert_update(certifier, &of_c, &out), TCERT_OK);
        ASSERT_EQ(test_support::allocation_count(), before);
        ASSERT_EQ(test_support::malloc_count(), mallocs);
        const CertifiedTick certified = expected.update(tick);
        expect_same(out, certified, guards.update(tick, certified));
      }
      tcert_bottleneck narrowest{};
      narrowest.struct_size = sizeof narrowest;
      std::int32_t found = -1;
      ASSERT_EQ(tcert_find_bottleneck(certifier, &narrowest, &found), TCERT_OK);
      const auto bottleneck = expected.bottleneck();
      ASSERT_EQ(found, bottleneck ? 1 : 0);
      if (bottleneck) {
        ASSERT_TRUE(same_bits(narrowest.margin_m, bottleneck->margin_m));
        ASSERT_EQ(narrowest.edge, bottleneck->edge);
      }
      ASSERT_EQ(tcert_reset(certifier), TCERT_OK);
      expected.reset();
      guards.reset();
    }
    tcert_destroy(certifier);
  }
}

TEST(CApi, FlagsWhatItRefusesAndNeverFails) {
  const test_support::Run run = random_run(1, 10);
  CSetup c(run.robot, run.course);
  tcert_certifier* certifier = nullptr;
  ASSERT_EQ(c.create(certifier), TCERT_OK);
  std::vector<tcert_reading> readings;
  tcert_tick tick = to_c(run.ticks[0], readings);
  tick.stale = 0;
  tcert_output out = empty_output();
  ASSERT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_EQ(out.flags & (TCERT_BAD_INPUT | TCERT_STALE), 0U);

  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_EQ(out.flags & TCERT_BAD_INPUT, TCERT_BAD_INPUT) << "time stood still";
  EXPECT_EQ(out.speed_mps, 0.0);
  EXPECT_EQ(out.triggers, static_cast<std::uint32_t>(TCERT_TRIGGER_NO_EVIDENCE));

  tick.time_ns += 100'000'000;
  tick.x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_EQ(out.flags & TCERT_BAD_INPUT, TCERT_BAD_INPUT) << "no pose";

  tick.time_ns += 100'000'000;
  tick.x_m = -1.01e9;
  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_EQ(out.flags & TCERT_BAD_INPUT, TCERT_BAD_INPUT) << "too far";

  tick = to_c(run.ticks[0], readings);
  tick.stale = 0;
  tick.time_ns += 100'000'000;
  readings.resize(9);
  tick.readings = readings.data();
  for (const std::uint32_t count : {0U, 2U, 4U, 9U}) {
    tick.reading_count = count;
    EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
    EXPECT_EQ(out.flags & TCERT_BAD_INPUT, TCERT_BAD_INPUT) << count << " readings";
  }

  tick.reading_count = 3;
  readings[0].value = std::numeric_limits<double>::infinity();
  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_EQ(out.flags & (TCERT_BAD_INPUT | TCERT_MISSING_RAY), TCERT_MISSING_RAY);

  tick.readings = nullptr;
  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_ERROR_ARGUMENT);
  EXPECT_EQ(tcert_update(nullptr, &tick, &out), TCERT_ERROR_ARGUMENT);
  out.struct_size = 8;
  tick.reading_count = 0;
  EXPECT_EQ(tcert_update(certifier, &tick, &out), TCERT_ERROR_VERSION);
  tcert_destroy(certifier);
  tcert_destroy(nullptr);
}

TEST(CApi, SaysWhatIsWrongWithWhatItIsMadeFrom) {
  const test_support::Run run = random_run(1, 1);
  const auto expect_refused = [&](const auto& change, tcert_status status, const char* reason) {
    CSetup c(run.robot, run.course);
    change(c);
    auto* certifier = reinterpret_cast<tcert_certifier*>(&c);
    EXPECT_EQ(c.create(certifier), status) << reason;
    EXPECT_EQ(certifier, nullptr);
    EXPECT_NE(std::string(c.message.data()).find(reason), std::string::npos) << c.message.data();
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  expect_refused(
      [](CSetup& c) { c.robot.body_width_m = -1.0; }, TCERT_ERROR_PARAMETER, "body_width_m");
  expect_refused([](CSetup& c) { c.rays[1].reach_m = 0.0; }, TCERT_ERROR_PARAMETER, "ray 'right'");
  expect_refused([](CSetup& c) { c.rays[0].kind = TCERT_BEND; }, TCERT_ERROR_PARAMETER, "knots");
  expect_refused([](CSetup& c) { c.rays[0].kind = 7; }, TCERT_ERROR_PARAMETER, "ray kind");
  expect_refused([](CSetup& c) { c.robot.rays = nullptr; }, TCERT_ERROR_PARAMETER, "rays is null");
  expect_refused(
      [](CSetup& c) { c.course.goal.radius_m = 0.0; }, TCERT_ERROR_PARAMETER, "goal.radius_m is 0");
  expect_refused(
      [](CSetup& c) { c.course.start.centre.x_m = kNaN; }, TCERT_ERROR_PARAMETER, "start");
  expect_refused([](CSetup& c) { c.course.start.kind = TCERT_POLYGON; },
                 TCERT_ERROR_PARAMETER,
                 "at least three vertices");
  expect_refused(
      [](CSetup& c) { c.parameters.max_nodes = 1; }, TCERT_ERROR_PARAMETER, "max_nodes is 1");
  expect_refused([](CSetup& c) { c.parameters.clearance = 9; }, TCERT_ERROR_PARAMETER, "clearance");
  expect_refused(
      [](CSetup& c) { c.parameters.guard_mode = -1; }, TCERT_ERROR_PARAMETER, "guard_mode");
  // A word that would become a known one if it were cut to the width of the enumeration.
  expect_refused(
      [](CSetup& c) { c.parameters.guard_mode = 257; }, TCERT_ERROR_PARAMETER, "guard_mode is 257");
  // What would size a table beyond any memory, or a tick beyond any time.
  expect_refused([](CSetup& c) { c.parameters.memory_cell_m = 1e-300; },
                 TCERT_ERROR_PARAMETER,
                 "memory_cell_m is 1e-300; it must be from 0.0001 to 10000");
  expect_refused([](CSetup& c) { c.parameters.memory_cell_m = 1e-4; },
                 TCERT_ERROR_PARAMETER,
                 "memory_sigma_m is 0.15; it must be at most 32 times memory_cell_m");
  expect_refused([](CSetup& c) { c.parameters.side_window_m = 1e300; },
                 TCERT_ERROR_PARAMETER,
                 "side_window_m");
  expect_refused([](CSetup& c) { c.parameters.side_window_m = 5000.0; },
                 TCERT_ERROR_PARAMETER,
                 "at most 100000 times travel_deadband_m");
  expect_refused([](CSetup& c) { c.robot.body_width_m = 1e300; }, TCERT_ERROR_PARAMETER, "body");
  expect_refused(
      [](CSetup& c) {
        c.parameters.clearance = TCERT_CLEARANCE_SWEPT;
        c.rays[1].reach_m = 1e4;
      },
      TCERT_ERROR_PARAMETER,
      "ray 'right': mount and reach_m together");
  expect_refused(
      [](CSetup& c) { c.parameters.beta_per_m = 0.0; }, TCERT_ERROR_PARAMETER, "beta_per_m");
  expect_refused([](CSetup& c) { c.parameters.tracking_radius_m = &c.parameters.beta_per_m; },
                 TCERT_ERROR_PARAMETER,
                 "tracking error: speed_mps must start at 0 and rise");
  expect_refused(
      [](CSetup& c) { c.parameters.curvature_window_m = 0.05; },
      TCERT_ERROR_PARAMETER,
      "curvature_min_travel_m is 0.1; it must be at most curvature_window_m, which is 0.05");
  expect_refused([](CSetup& c) { c.course.reserved = 1; }, TCERT_ERROR_PARAMETER, "reserved");
  expect_refused([](CSetup& c) { c.parameters.reserved_1 = 9; }, TCERT_ERROR_PARAMETER, "reserved");
  expect_refused(
      [](CSetup& c) { c.parameters.struct_size = 8; }, TCERT_ERROR_VERSION, "struct_size is 8");
  expect_refused([](CSetup& c) { c.course.struct_size = 0; }, TCERT_ERROR_VERSION, "course");
  tcert_certifier* certifier = nullptr;
  EXPECT_EQ(tcert_create(nullptr, nullptr, nullptr, &certifier, nullptr, 0), TCERT_ERROR_ARGUMENT);
}

TEST(CApi, TakesCalibrationPolygonsAndATrackingErrorTable) {
  const test_support::Run run = random_run(1, 1);
  CSetup c(run.robot, run.course);
  const std::array<double, 2> bend{0.0, 1.0};
  const std::array<double, 2> clearance{0.6, 0.0};
  c.rays[0].kind = TCERT_BEND;
  c.rays[0].knots = 2;
  c.rays[0].bend_rad = bend.data();
  c.rays[0].clearance_m = clearance.data();
  const std::array<tcert_point, 4> square{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
  c.course.start = {TCERT_POLYGON, 4, {}, 0.0, square.data()};
  c.course.goal = {};
  const std::array<double, 2> axis{0.0, 1.0};
  const double level = 0.0;
  const std::array<double, 4> radius{0.01, 0.02, 0.03, 0.04};
  c.parameters.tracking_speeds = 2;
  c.parameters.tracking_accelerations = 2;
  c.parameters.tracking_disturbances = 1;
  c.parameters.tracking_speed_mps = axis.data();
  c.parameters.tracking_acceleration_mps2 = axis.data();
  c.parameters.tracking_disturbance = &level;
  c.parameters.tracking_radius_m = radius.data();
  tcert_certifier* certifier = nullptr;
  ASSERT_EQ(c.create(certifier), TCERT_OK) << c.message.data();
  const std::array<tcert_reading, 3> readings{{{0.5, 0.0}, {0.4, 0.0}, {0.4, 0.0}}};
  const tcert_tick tick{
      sizeof tick, 3, readings.data(), 0, 0.0, 0.0, 0.0, 0, 0, nullptr, 0.0, 0.0, 0.0, 0.0};
  tcert_output out = empty_output();
  ASSERT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_DOUBLE_EQ(out.left_m, 0.1 + 0.3);
  EXPECT_EQ(out.flags, 0U);
  EXPECT_DOUBLE_EQ(out.tracking_error_m, 0.01 + 0.02 * out.speed_mps);
  std::array<double, 5> margins{};
  ASSERT_EQ(tcert_ray_margins(certifier, margins.data(), 5), TCERT_OK);
  EXPECT_FALSE(std::isnan(margins[2]));
  EXPECT_TRUE(std::isnan(margins[3]));
  tcert_destroy(certifier);
}

TEST(CApi, KnowsItsWords) {
  EXPECT_EQ(tcert_abi_version(), static_cast<std::uint32_t>(TCERT_ABI_VERSION));
  EXPECT_EQ(std::string(tcert_flag_text(TCERT_MISSING_RAY)), "missing_ray");
  EXPECT_EQ(std::string(tcert_flag_text(1U << 30U)), "");
  EXPECT_NE(std::string(tcert_version()), "");
}

TEST(CApi, TakesTheFootingOfACallerThatHasItAndNoneOfAnOlderOne) {
  Robot robot;
  robot.rays = {{"left", {}, 1.5707963, 1.0, RayKind::range, {}}};
  CSetup setup(robot, {});
  const tcert_reading reading{0.5, kMissing};
  tcert_tick tick{sizeof tick, 1, &reading, 0, 0.0, 0.0, 0.0, 0, 0, nullptr, 0.0, 0.0, 0.15, 0.0};
  tcert_output now{};
  now.struct_size = sizeof now;
  for (const bool is_older : {false, true}) {
    tcert_certifier* certifier = nullptr;
    ASSERT_EQ(tcert_create(&setup.robot, &setup.course, &setup.parameters, &certifier, nullptr, 0),
              TCERT_OK);
    tick.struct_size =
        is_older ? static_cast<std::uint32_t>(offsetof(tcert_tick, pitch_rad)) : sizeof tick;
    ASSERT_EQ(tcert_update(certifier, &tick, &now), TCERT_OK);
    EXPECT_EQ(std::isnan(now.footing_slack_m), is_older);
    if (!is_older) {
      EXPECT_LT(now.footing_slack_m, 0.0) << "a step of 0.15 m, and 0.12 is the most";
    }
    EXPECT_TRUE(std::isnan(now.valid_for_s)) << "nothing moves";
    tcert_destroy(certifier);
  }
}

/// Of a caller that knows bearings and of one that was compiled before there were any.
TEST(CApi, TakesTheBearingsOfAJoint) {
  Robot robot;
  robot.rays = {{"whisker", {0.1, 0.05}, 0.0, 0.6, RayKind::range, {}}};
  CSetup c(robot, {});
  tcert_certifier* certifier = nullptr;
  ASSERT_EQ(c.create(certifier), TCERT_OK) << c.message.data();
  const tcert_reading reading{0.3, 0.0};
  const double to_the_left = 0.5 * std::numbers::pi;
  tcert_tick tick{
      sizeof tick, 1, &reading, 0, 0.0, 0.0, 0.0, 0, 0, &to_the_left, 0.0, 0.0, 0.0, 0.0};
  tcert_output out = empty_output();
  ASSERT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_DOUBLE_EQ(out.left_m, 0.05 + 0.3);
  ASSERT_EQ(tcert_reset(certifier), TCERT_OK);
  tick.struct_size = offsetof(tcert_tick, bearings_rad);
  ASSERT_EQ(tcert_update(certifier, &tick, &out), TCERT_OK);
  EXPECT_DOUBLE_EQ(out.left_m, 0.5 * robot.body_width_m);
  tcert_destroy(certifier);
}

}  // namespace
}  // namespace tcert
