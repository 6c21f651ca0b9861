// Plausibility of the checks of values: nothing to say of any good trial, and every fault that is
// put into a good trial named.

#include "datasets/values/check_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/check_trial.hpp"
#include "datasets/corpus/corpus.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/simulated_trial.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/trial_course.hpp"
#include "datasets/import/import_carmen.hpp"
#include "datasets/values/check_sides.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

struct Trial {
  BundleInfo info;
  TrialRow row;
  TickTable ticks;
};

Trial made_of(const SimulatedTrial& simulated) {
  Trial trial;
  trial.info.robot = corpus_robot();
  trial.info.course = {simulated.world.start, simulated.world.goal};
  trial.row = simulated.row;
  trial.row.trial_id = "t";
  trial.ticks = resample(simulated.log);
  return trial;
}

Trial corpus_trial(std::uint64_t index, std::uint64_t seed = 1, double effect = 1.0) {
  CorpusOptions options;
  options.seed = seed;
  options.effect = effect;
  return made_of(simulate_trial(design_trial(options, index)));
}

std::vector<ValueFinding> found_in(const Trial& trial) {
  return check_values(trial.info, trial.row, {}, trial.ticks);
}

std::string text_of(const std::vector<ValueFinding>& found) {
  std::string text;
  for (const ValueFinding& finding : found) {
    text += table::to_string(finding.diagnostic) + '\n';
  }
  return text;
}

bool has(const std::vector<ValueFinding>& found, ValueKind kind) {
  return std::ranges::any_of(found, [kind](const ValueFinding& f) { return f.kind == kind; });
}

TEST(CheckValues, HaveNothingToSayOfTheCorpora) {
  for (const std::uint64_t seed : {1U, 2U, 7U}) {
    for (const double effect : {1.0, 0.0, 2.0}) {
      for (std::uint64_t index = 0; index < 660; index += 11) {
        EXPECT_EQ(text_of(found_in(corpus_trial(index, seed, effect))), "") << seed << ' ' << index;
      }
    }
  }
  for (std::uint64_t index = 0; index < kGatePasses; ++index) {
    EXPECT_EQ(text_of(found_in(made_of(simulate_gate_pass(1, index)))), "") << index;
  }
}

TEST(CheckValues, HaveNothingToSayOfRealLaserLogs) {
  const auto folder = test_support::shared_data() / "logs" / "carmen";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "missing: " << folder;
  }
  std::size_t logs = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const test_support::TemporaryFolder out;
    const CarmenImportResult imported = import_carmen(file.path(), out.path() / "b");
    if (!imported.summary || imported.summary->scans < 50) {
      continue;  // stamps without order
    }
    const BundleResult opened = open_bundle(out.path() / "b");
    ASSERT_TRUE(opened.bundle);
    for (const table::Diagnostic& one :
         check_trial(*opened.bundle, opened.bundle->trials[0]).diagnostics) {
      // Gaps of the clock are the log's own.
      EXPECT_EQ(one.column, "time_s") << file.path() << ": " << table::to_string(one);
    }
    ++logs;
  }
  EXPECT_GE(logs, 3U);
}

/// A fault in the values of a trial, and the sign by which it is to be named.
struct Fault {
  const char* name;
  ValueKind kind;
  std::function<void(Trial&)> put_in;
};

void scale_poses(Trial& trial, double by) {
  for (Pose& pose : trial.ticks.poses) {
    pose.position = by * pose.position;
  }
}

const double kDegrees = 180.0 / std::numbers::pi;

const std::vector<Fault> kFaults{
    {"bends in degrees",
     ValueKind::bend_unit,
     [](Trial& trial) {
       for (RayReading& reading : trial.ticks.readings) {
         reading.value *= kDegrees;
       }
     }},
    {"forces in grams",
     ValueKind::force_unit,
     [](Trial& trial) {
       for (RayReading& reading : trial.ticks.readings) {
         reading.fsr_n *= 101.97;
       }
     }},
    {"yaw in degrees",
     ValueKind::yaw,
     [](Trial& trial) {
       for (Pose& pose : trial.ticks.poses) {
         pose.yaw_rad *= kDegrees;
       }
     }},
    {"yaw in degrees that turn on",
     ValueKind::yaw,
     [](Trial& trial) {
       for (Pose& pose : trial.ticks.poses) {
         pose.yaw_rad = pose.yaw_rad * kDegrees + 360.0;
       }
     }},
    {"yaw of a frame turned by a quarter",
     ValueKind::yaw,
     [](Trial& trial) {
       for (Pose& pose : trial.ticks.poses) {
         pose.yaw_rad -= 0.5 * std::numbers::pi;
       }
     }},
    {"poses in millimetres", ValueKind::speed, [](Trial& trial) { scale_poses(trial, 1000.0); }},
    {"poses in centimetres", ValueKind::speed, [](Trial& trial) { scale_poses(trial, 100.0); }},
    {"times too short by a thousand",
     ValueKind::speed,
     [](Trial& trial) {
       for (std::int64_t& time_ns : trial.ticks.time_ns) {
         time_ns /= 1000;
       }
     }},
    {"times in milliseconds",
     ValueKind::duration,
     [](Trial& trial) {
       for (std::int64_t& time_ns : trial.ticks.time_ns) {
         time_ns *= 1000;
       }
     }},
    {"poses of another origin",
     ValueKind::start_outside,
     [](Trial& trial) {
       for (Pose& pose : trial.ticks.poses) {
         pose.position.x_m += 3.0;
       }
     }},
    {"a ray that hangs",
     ValueKind::ray_stuck,
     [](Trial& trial) {
       for (std::size_t i = 0; i < trial.ticks.readings.size(); i += 3) {
         trial.ticks.readings[i].value = 0.31;
       }
     }},
    {"a ray that hangs half-way",
     ValueKind::ray_hung,
     [](Trial& trial) {
       const std::size_t rays = 3;
       for (std::size_t i = trial.ticks.size() / 3; i < trial.ticks.size(); ++i) {
         trial.ticks.readings[i * rays].value = 0.31;
       }
     }},
    {"a mount in millimetres",
     ValueKind::mount_unit,
     [](Trial& trial) { trial.info.robot.rays[0].mount.x_m = 160.0; }},
    {"a ray without readings",
     ValueKind::ray_silent,
     [](Trial& trial) {
       for (std::size_t i = 0; i < trial.ticks.readings.size(); i += 3) {
         trial.ticks.readings[i] = {};
       }
     }},
    {"one ray twice",
     ValueKind::ray_twin,
     [](Trial& trial) {
       for (std::size_t i = 0; i < trial.ticks.readings.size(); i += 3) {
         trial.ticks.readings[i + 1] = trial.ticks.readings[i];
       }
     }},
    {"ranges in centimetres",
     ValueKind::range_unit,
     [](Trial& trial) {
       for (Ray& ray : trial.info.robot.rays) {
         ray.kind = RayKind::range;
       }
       for (RayReading& reading : trial.ticks.readings) {
         reading.value = std::max(0.0, 45.0 - 30.0 * reading.value);
       }
     }},
    {"ranges in millimetres", ValueKind::range_unit, [](Trial& trial) {
       for (Ray& ray : trial.info.robot.rays) {
         ray.kind = RayKind::range;
       }
       for (RayReading& reading : trial.ticks.readings) {
         reading.value = std::max(0.0, 450.0 - 300.0 * reading.value);
       }
     }}};

TEST(CheckValues, NameEveryFaultPutIntoATrialOfTheCorpus) {
  for (const Fault& fault : kFaults) {
    std::size_t trials = 0;
    std::size_t named = 0;
    for (std::uint64_t index = 0; index < 660; index += 23) {
      Trial trial = corpus_trial(index);
      fault.put_in(trial);
      ++trials;
      named += has(found_in(trial), fault.kind) ? 1 : 0;
    }
    EXPECT_EQ(named, trials) << fault.name;
  }
}

TEST(CheckValues, GuessTheUnit) {
  Trial trial = corpus_trial(5);
  const auto says = [&](std::string_view name, const std::string& words) {
    Trial spoilt = trial;
    const auto fault = std::ranges::find(kFaults, name, &Fault::name);
    ASSERT_NE(fault, kFaults.end()) << name;
    fault->put_in(spoilt);
    const std::string text = text_of(found_in(spoilt));
    EXPECT_NE(text.find(words), std::string::npos) << name << ": " << text;
  };
  says("bends in degrees", "radians within the calibration, 0 to 1.2: degrees?");
  says("forces in grams", "newtons at the tip of a ray: grams?");
  says("yaw in degrees", "radians: degrees?");
  says("yaw of a frame turned by a quarter", "over 45 degrees off the motion");
  says("poses in millimetres", "millimetres");
  says("poses in centimetres", "centimetres?");
  says("times in milliseconds", "s that trials.csv says: milliseconds or another unit?");
  says("ranges in centimetres", "centimetres?");
  says("ranges in millimetres", "millimetres?");
}

TEST(CheckValues, NameASuccessThatNeverEnteredTheGoal) {
  Trial trial = corpus_trial(0);
  for (std::uint64_t index = 1; !trial.row.success.value_or(false); ++index) {
    trial = corpus_trial(index);
  }
  const double end_x_m = trial.ticks.poses.back().position.x_m;
  trial.info.course.goal = Disc{{end_x_m + 60.0, trial.ticks.poses.back().position.y_m}, 1.0};
  const auto found = found_in(trial);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ValueKind::goal_missed);
  EXPECT_NE(found[0].diagnostic.value.find("m off at the nearest"), std::string::npos);
  trial.row.success = false;
  EXPECT_TRUE(found_in(trial).empty()) << "a failure need not arrive";
}

TEST(CheckValues, LeaveAFastCarAloneThatDoesWhatItIsTold) {
  TickTable ticks;
  ticks.rays = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    ticks.time_ns.push_back(static_cast<std::int64_t>(i) * 100'000'000);
    ticks.poses.push_back({{1.2 * static_cast<double>(i), 0.0}, 0.0});
    ticks.speed_cmd_mps.push_back(11.0);
  }
  ticks.stale.assign(400, 0);
  ticks.segment_start.assign(400, 0);
  BundleInfo info;
  EXPECT_TRUE(check_values(info, {}, {}, ticks).empty());
  ticks.speed_cmd_mps.assign(400, 0.5);
  EXPECT_TRUE(has(check_values(info, {}, {}, ticks), ValueKind::speed));
  ticks.speed_cmd_mps.assign(400, kMissing);
  EXPECT_TRUE(has(check_values(info, {}, {}, ticks), ValueKind::speed));
}

TEST(CheckSides, NameRaysWhoseNamesSayAnotherSideThanTheirPlace) {
  Robot robot = corpus_robot();
  EXPECT_FALSE(check_sides(robot));
  for (Ray& ray : robot.rays) {
    ray.bearing_rad = -ray.bearing_rad;  // clockwise, as a compass
    ray.mount.y_m = -ray.mount.y_m;
  }
  const auto found = check_sides(robot);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, "left, right on the other sides");
  robot = corpus_robot();
  robot.rays[0].bearing_rad = -1.5;
  EXPECT_FALSE(check_sides(robot)) << "mounted on the left, it looks across the body";
  robot.rays[0].mount.y_m = 0.0;
  EXPECT_TRUE(check_sides(robot));
  robot = corpus_robot();
  for (Ray& ray : robot.rays) {
    ray.name = "ray " + std::to_string(robot.rays.size());
    ray.bearing_rad = -ray.bearing_rad;
  }
  EXPECT_TRUE(check_sides(robot)) << "all look over the body";
}

// Standing, turning on the spot and driving back are no other frame.
TEST(CheckValues, JudgeHeadingsByWhatWasDriven) {
  TickTable ticks;
  ticks.rays = 0;
  double x_m = 0.0;
  for (std::size_t i = 0; i < 600; ++i) {
    const bool turns = i % 200 >= 100;
    x_m += turns ? 0.0 : (i / 200 % 2 == 0 ? 0.02 : -0.02);
    ticks.time_ns.push_back(static_cast<std::int64_t>(i) * 100'000'000);
    ticks.poses.push_back({{x_m, 0.004 * std::sin(1.7 * static_cast<double>(i))},
                           turns ? 0.12 * static_cast<double>(i % 100) : 0.0});
  }
  ticks.stale.assign(600, 0);
  ticks.segment_start.assign(600, 0);
  EXPECT_EQ(text_of(check_values({}, {}, {}, ticks)), "");
}

TEST(ValueSummary, SaysEachKindOnceWithTheTrialsThatHaveIt) {
  ValueSummary summary;
  EXPECT_TRUE(summary.lines().empty());
  for (std::uint64_t index = 0; index < 3; ++index) {
    Trial trial = corpus_trial(index);
    trial.row.trial_id = "t" + std::to_string(index);
    summary.add(found_in(trial));
    kFaults[index == 0 ? 1 : 0].put_in(trial);
    summary.add(found_in(trial));
  }
  const std::vector<std::string> lines = summary.lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].find("logs/t1: warning: column 'left_bend_rad"), 0U) << lines[0];
  EXPECT_TRUE(lines[0].ends_with("(and 1 more trial)")) << lines[0];
  EXPECT_EQ(lines[1].find("logs/t0: warning"), 0U) << lines[1];
  EXPECT_TRUE(lines[1].ends_with("grams?")) << lines[1];
}

}  // namespace
}  // namespace tcert
