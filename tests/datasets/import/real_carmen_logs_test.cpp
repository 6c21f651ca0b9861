// Public CARMEN logs as they are. They are not part of the project.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "datasets/import/import_carmen.hpp"
#include "support/carmen_text.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using test_support::messages;
using test_support::TemporaryFolder;

struct RealLog {
  const char* name;
  std::size_t records;
  std::size_t used;  ///< By its stamps; 0: they carry no order.
};

constexpr RealLog kLogs[] = {{"aces", 440, 440},
                             {"belgioioso", 395, 0},
                             {"edmonton", 340, 340},
                             {"freiburg-101", 292, 292},
                             {"infinite-corridor", 1941, 0},
                             {"orebro", 237, 0},
                             {"seattle", 241, 241}};

std::filesystem::path path_of(const RealLog& log) {
  return test_support::shared_data() / "logs" / "carmen" /
         (std::string(log.name) + "-corrected.log.gz");
}

bool says(const CarmenImportResult& result, const std::string& words) {
  return std::ranges::any_of(messages(result.diagnostics), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

TEST(RealCarmenLogs, BecomeWholeBundlesOrAreRefusedWithTheWayOut) {
  for (const RealLog& log : kLogs) {
    if (!std::filesystem::exists(path_of(log))) {
      GTEST_SKIP() << "missing: " << path_of(log);
    }
    const TemporaryFolder folder;
    const CarmenImportResult by_stamps = import_carmen(path_of(log), folder.path() / "stamps");
    EXPECT_EQ(by_stamps.summary.has_value(), log.used > 0) << log.name;
    if (by_stamps.summary) {
      EXPECT_EQ(by_stamps.summary->scans, log.used) << log.name;
    } else {
      EXPECT_FALSE(std::filesystem::exists(folder.path() / "stamps"));
      EXPECT_TRUE(says(by_stamps, "in " + std::to_string(log.records) + " scans'")) << log.name;
      EXPECT_TRUE(says(by_stamps, "--clock order --rate HZ")) << log.name;
    }
    CarmenImportOptions options;
    options.reading.clock = CarmenClock::order;
    options.reading.rate_hz = 1.0;
    const CarmenImportResult by_order =
        import_carmen(path_of(log), folder.path() / "order", options);
    ASSERT_TRUE(by_order.summary) << log.name;
    EXPECT_EQ(by_order.summary->scans, log.records) << log.name;
    EXPECT_FALSE(says(by_order, "not scan-matched")) << log.name;
  }
}

/// How spread out the ends of beams are over cells of 5 cm, as entropy, if all beams are turned by
/// `turn_rad`: small for a sharp map.
double blur(const CarmenLog& log, double turn_rad) {
  constexpr double kCell = 0.05;
  std::unordered_map<std::int64_t, int> cells;
  const std::size_t step = std::max<std::size_t>(1, log.ranges_m.size() / 90000);
  double ends = 0.0;
  for (std::size_t scan = 0; scan < log.scans(); scan += step) {
    for (std::size_t beam = 0; beam < log.beams.count; ++beam) {
      const double range = log.ranges_m[scan * log.beams.count + beam];
      if (range <= 0.2 || range >= 10.0) {
        continue;
      }
      const double yaw = log.poses[scan].yaw_rad + log.beams.bearing_rad(beam) + turn_rad;
      const Point end = log.poses[scan].position + range * Point{std::cos(yaw), std::sin(yaw)};
      ++cells[static_cast<std::int64_t>(std::floor(end.x_m / kCell)) * 1'000'000 +
              static_cast<std::int64_t>(std::floor(end.y_m / kCell))];
      ends += 1.0;
    }
  }
  double entropy = 0.0;
  for (const auto& [cell, count] : cells) {
    const double share = count / ends;
    entropy -= share * std::log(share);
  }
  return entropy;
}

/// What the bearings mean, told by the maps and not by the convention: they are sharpest where
/// beams point as they are read.
TEST(RealCarmenLogs, GiveTheSharpestMapWithTheBearingsThatAreRead) {
  constexpr double kQuarterDegree = 0.25 * std::numbers::pi / 180.0;
  for (const RealLog& log : kLogs) {
    const table::BytesResult file = table::read_file(path_of(log));
    if (!file.bytes) {
      GTEST_SKIP() << "missing: " << path_of(log);
    }
    table::DiagnosticGroups problems;
    CarmenReading reading;
    reading.clock = CarmenClock::order;
    reading.rate_hz = 1.0;
    const CarmenLog read = read_carmen_log(*file.bytes, log.name, reading, problems);
    const double as_read = blur(read, 0.0);
    for (const double quarters : {-2.0, -1.0, 1.0, 2.0}) {
      EXPECT_LT(as_read, blur(read, quarters * kQuarterDegree)) << log.name << ' ' << quarters;
    }
  }
}

}  // namespace
}  // namespace tcert
