#include "datasets/import_carmen.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <table/path_name.hpp>
#include <utility>

#include "datasets/bundle_json.hpp"
#include "datasets/tick_table.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {

namespace {

constexpr double kLongestStop = 60.0;

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
}

std::string ray_name(std::size_t beam) {
  std::string digits = std::to_string(beam);
  digits.insert(0, 3 - std::min<std::size_t>(digits.size(), 3), '0');
  return "b" + digits;
}

CarmenSummary summarise(const CarmenLog& log) {
  CarmenSummary summary;
  summary.scans = log.scans();
  summary.beams = log.beams;
  summary.odometry_records = log.odometry_records;
  summary.duration_s = static_cast<double>(log.time_ns.back() - log.time_ns.front()) * 1e-9;
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.scans(); ++i) {
    const double step = distance(log.poses[i - 1].position, log.poses[i].position);
    const double silence = static_cast<double>(log.time_ns[i] - log.time_ns[i - 1]) * 1e-9;
    summary.distance_m += step;
    summary.longest_step_m = std::max(summary.longest_step_m, step);
    summary.longest_silence_s = std::max(summary.longest_silence_s, silence);
    steps.push_back(step);
  }
  if (!steps.empty()) {
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    summary.median_step_m = *middle;
  }
  return summary;
}

/// With centimetres.
std::string metres(double value) {
  const auto hundredths = static_cast<long>(std::lround(100.0 * value));
  const std::string cents = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) + (cents.size() == 1 ? ".0" : ".") + cents;
}

std::string provenance(const CarmenLog& log, const std::string& source) {
  return "Imported from the CARMEN log " + source + ": " + std::to_string(log.scans()) +
         " scans with corrected poses; its " + std::to_string(log.odometry_records) +
         " odometry records are in another frame and are not used. The parameters suit scans up to "
         "about a metre apart (the median of all steps is " +
         metres(summarise(log).median_step_m) +
         " m here): edges of 1 m hold two or three, steps up to 1.5 m do not break the path, "
         "sides look 46 degrees off square and back over the last scan, laps merge within 0.75 m; "
         "the robot turns on the spot, and a beam's return is not a contact.";
}

TickTable to_ticks(const CarmenLog& log, double reach_m, CarmenSummary& summary) {
  TickTable ticks;
  ticks.rays = log.beams;
  ticks.time_ns = log.time_ns;
  ticks.poses = log.poses;
  ticks.stale.assign(log.scans(), 0);
  ticks.segment_start.assign(log.scans(), 0);
  for (const double range : log.ranges_m) {
    summary.clamped_readings += range >= reach_m ? 1 : 0;
    ticks.readings.push_back({std::min(range, reach_m), kMissing});
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

}  // namespace

BundleInfo carmen_bundle_info(const CarmenLog& log,
                              const std::string& source,
                              const CarmenImportOptions& options) {
  BundleInfo info;
  info.provenance = provenance(log, source);
  info.robot.body_width_m = options.body_width_m;
  info.robot.min_turn_radius_m = 0.0;
  for (std::size_t beam = 0; beam < log.beams; ++beam) {
    info.robot.rays.push_back({ray_name(beam),
                               {},
                               carmen_bearing_rad(beam, log.beams),
                               options.reach_m,
                               RayKind::range,
                               {}});
  }
  info.course.start = Disc{log.poses.front().position, options.start_radius_m};
  if (options.goal) {
    info.course.goal = *options.goal;
  }
  info.max_gap_s = kLongestStop;
  info.parameters = {{"curvature", "none"},
                     {"edge_length_m", "1.0"},
                     {"max_step_m", "1.5"},
                     {"memory_weight_m", "0.0"},
                     {"merge_radius_m", "0.75"},
                     {"reversal_m", "0.3"},
                     {"side_angle_rad", "0.8"},
                     {"side_window_m", "0.7"},
                     {"travel_deadband_m", "0.02"}};
  return info;
}

CarmenImportResult import_carmen(const std::filesystem::path& log_path,
                                 const std::filesystem::path& output,
                                 const CarmenImportOptions& options) {
  validate(options);
  CarmenImportResult result;
  table::BytesResult file = table::read_file(log_path);
  if (!file.bytes) {
    result.diagnostics.push_back(
        {table::Severity::error, log_path.string(), 0, "", file.problem, "a readable file", 1});
    return result;
  }
  table::DiagnosticGroups problems;
  const CarmenLog log = read_carmen_log(*file.bytes, log_path.string(), problems);
  result.diagnostics = problems.take();
  if (table::has_error(result.diagnostics)) {
    return result;
  }
  if (log.odometry_records > 0) {
    result.diagnostics.push_back(
        {table::Severity::note,
         log_path.string(),
         0,
         "",
         std::to_string(log.odometry_records) + " ODOM records",
         "poses from FLASER records; raw odometry is in another frame and is not used",
         1});
  }
  CarmenSummary summary = summarise(log);
  const TickTable ticks = to_ticks(log, options.reach_m, summary);
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
