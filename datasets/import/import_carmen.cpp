#include "datasets/import/import_carmen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <table/path_name.hpp>
#include <utility>

#include "datasets/bundle_json.hpp"
#include "datasets/tick_table.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {

namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

void require(bool holds, const char* what) {
  if (!holds) {
    throw std::invalid_argument(what);
  }
}

void validate(const CarmenImportOptions& options) {
  require(table::is_file_name(options.trial_id), "trial_id must be the name of a folder");
  require(options.body_width_m > 0.0, "body_width_m must be above 0");
  require(options.start_radius_m > 0.0, "start_radius_m must be above 0");
  require(options.reach_m > 0.0, "reach_m must be above 0");
  require(!options.goal || options.goal->radius_m > 0.0, "the goal's radius must be above 0");
  const CarmenReading& reading = options.reading;
  require(!reading.fov_rad || (*reading.fov_rad > 0.0 && *reading.fov_rad <= kWholeTurn),
          "fov_rad must be above 0 and at most one turn");
  require(reading.clock != CarmenClock::order || reading.rate_hz > 0.0,
          "rate_hz must be above 0 where the order is the clock");
}

TickTable to_ticks(const CarmenLog& log, CarmenSummary& summary) {
  TickTable ticks;
  ticks.rays = log.beams.count;
  ticks.time_ns = log.time_ns;
  ticks.poses = log.poses;
  ticks.stale.assign(log.scans(), 0);
  ticks.segment_start.assign(log.scans(), 0);
  for (const double range : log.ranges_m) {
    summary.clamped_readings += range >= summary.reach_m ? 1 : 0;
    summary.missing_readings += std::isnan(range) ? 1 : 0;
    ticks.readings.push_back({std::min(range, summary.reach_m), kMissing});
  }
  return ticks;
}

void write_bundle(const std::filesystem::path& output,
                  const BundleInfo& info,
                  const TrialRow& trial,
                  const TickTable& ticks) {
  table::AtomicFolder folder(output);
  table::write_file_atomically(folder.staging() / "bundle.json", to_bundle_json(info));
  table::write_file_atomically(folder.staging() / "trials.csv", to_trials_csv({trial}, {}));
  table::write_file_atomically(folder.staging() / "logs" / trial.trial_id / "ticks.csv",
                               to_ticks_csv(info.robot, ticks));
  folder.commit();
}

void say(CarmenImportResult& result,
         table::Severity severity,
         const std::string& file,
         std::string value,
         std::string expectation) {
  result.diagnostics.push_back(
      {severity, file, 0, "", std::move(value), std::move(expectation), 1});
}

/// What is worth knowing of the poses.
void say_poses(CarmenImportResult& result, const std::string& file, const CarmenLog& log) {
  const std::string odometry = std::to_string(log.odometry_records) + " ODOM records";
  if (log.origin == CarmenPoses::odometry) {
    say(result,
        table::Severity::warning,
        file,
        "poses that lie on the way of its " + odometry,
        "scan-matched poses: these poses are the odometry: not scan-matched; it drifts, and a "
        "certificate that closes loops drifts with it; match the scans first (GMapping, "
        "Cartographer)");
  } else if (log.odometry_records > 0) {
    say(result,
        table::Severity::note,
        file,
        odometry,
        "poses from " + log.kind + " records; raw odometry is in another frame and is not used");
  }
  if (log.kind == "ROBOTLASER1" && !log.mount) {
    say(result,
        table::Severity::warning,
        file,
        "laser poses at no fixed place on the robot",
        "one place, to 5 mm and within 1 m; the poses of the laser are taken for the robot's");
  }
}

}  // namespace

CarmenImportResult import_carmen(const std::filesystem::path& log_path,
                                 const std::filesystem::path& output,
                                 const CarmenImportOptions& options) {
  validate(options);
  CarmenImportResult result;
  table::BytesResult file = table::read_file(log_path);
  if (!file.bytes) {
    say(result, table::Severity::error, log_path.string(), file.problem, "a readable file");
    return result;
  }
  table::DiagnosticGroups problems;
  const CarmenLog log = read_carmen_log(*file.bytes, log_path.string(), options.reading, problems);
  result.diagnostics = problems.take();
  if (log.scans() > 0 && keeps_most_scans(log)) {
    say_poses(result, log_path.string(), log);
  }
  if (table::has_error(result.diagnostics)) {
    return result;
  }
  CarmenSummary summary = summarise(log, options);
  const TickTable ticks = to_ticks(log, summary);
  TrialRow trial;
  trial.trial_id = options.trial_id;
  trial.time_s = summary.duration_s;
  trial.distance_m = summary.distance_m;
  const BundleInfo info = carmen_bundle_info(log, log_path.filename().string(), options);
  write_bundle(output, info, trial, ticks);
  result.summary = summary;
  return result;
}

}  // namespace tcert
