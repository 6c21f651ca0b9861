#include "datasets/driven/driven_trial.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "datasets/corpus/figure_eight.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr std::int64_t kLoggerPeriod = 50'000'000;  // ns

/// The first sample of each period of a logger at 20 Hz.
std::vector<std::size_t> kept_by_logger(const std::vector<std::int64_t>& time_ns) {
  std::vector<std::size_t> kept;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < time_ns.size(); ++i) {
    if (time_ns[i] / kLoggerPeriod != last) {
      last = time_ns[i] / kLoggerPeriod;
      kept.push_back(i);
    }
  }
  return kept;
}

template <class T>
std::vector<T> picked(const std::vector<T>& values,
                      const std::vector<std::size_t>& rows,
                      std::size_t width = 1) {
  std::vector<T> some;
  some.reserve(rows.size() * width);
  for (const std::size_t row : rows) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * width);
    some.insert(some.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  return some;
}

TrialLog thinned(const TrialLog& log) {
  TrialLog thin;
  const auto poses = kept_by_logger(log.pose.time_ns);
  thin.pose = {picked(log.pose.time_ns, poses), picked(log.pose.poses, poses)};
  if (!log.pose.footing.empty()) {
    thin.pose.footing = picked(log.pose.footing, poses);
  }
  const auto touches = kept_by_logger(log.tactile.time_ns);
  thin.tactile = {log.tactile.rays,
                  picked(log.tactile.time_ns, touches),
                  picked(log.tactile.readings, touches, log.tactile.rays)};
  const auto commands = kept_by_logger(log.control.time_ns);
  thin.control = {picked(log.control.time_ns, commands),
                  picked(log.control.speed_cmd_mps, commands),
                  picked(log.control.yaw_rate_cmd_rps, commands),
                  picked(log.control.loop_latency_ms, commands)};
  return thin;
}

TrialRow row_of(const DrivenRun& run) {
  const DrivenDesign& design = run.design();
  const Referee& referee = run.referee();
  TrialRow row;
  row.trial_id = design.trial_id;
  row.algorithm = design.algorithm;
  row.lighting = name_of(design.lighting);
  row.day = fmt::format("D{:02}", design.world.day + 1);
  row.batch = fmt::format("B{:02}", design.world.day + 1);
  row.end_reason = referee.end_reason();
  if (row.end_reason != EndReason::unknown) {
    row.success = row.end_reason == EndReason::goal;
    row.time_s = referee.time_s();
    row.distance_m = referee.distance_m();
  }
  const DrivenEvents events = referee.events();
  const auto& margin = design.world.margin_m;
  row.extra = {design.world.world.name,
               margin ? fmt::format("{:.4f}", *margin) : "NA",
               fmt::format("{:.2f}", events.peak_force_n),
               fmt::format("{:.2f}", events.time_above_s),
               fmt::format("{}", events.bumps),
               fmt::format("{}", events.stalls),
               fmt::format("{}", events.recoveries),
               fmt::format("{:.2f}", events.crash_force_n),
               fmt::format("{}", design.world.redraws)};
  return row;
}

}  // namespace

std::span<const DrivenColumn> driven_columns() noexcept {
  static constexpr std::array kColumns{
      DrivenColumn{"world", "", "file of the world in worlds/, which other trials may share"},
      DrivenColumn{"true_margin_m", "m", "T(E; A) by clearance of the widest way; NA if unknown"},
      DrivenColumn{"peak_force_n", "N", "largest contact force on the body"},
      DrivenColumn{"time_above_force_s", "s", "time in which that was above drive_watched_force_n"},
      DrivenColumn{"bumps", "", "contacts of the body, 0.25 s or more after the last"},
      DrivenColumn{
          "stalls", "", "times that the body got nowhere for drive_stall_s of forward commands"},
      DrivenColumn{"recoveries", "", "commands to reverse after the body touched, whoever drives"},
      DrivenColumn{"crash_force_n", "N", "force at which this trial would end as a collision"},
      DrivenColumn{"redraws", "", "worlds that were drawn before one that can be passed"}};
  return kColumns;
}

std::vector<std::string> driven_extra_columns() {
  std::vector<std::string> names;
  for (const DrivenColumn& column : driven_columns()) {
    names.emplace_back(column.name);
  }
  return names;
}

DrivenTrial trial_of(const DrivenRun& run) {
  DrivenTrial driven;
  driven.events = run.referee().events();
  driven.trial.row = row_of(run);
  driven.trial.log = run.design().native_rates ? run.log() : thinned(run.log());
  if (run.truth() != nullptr) {
    driven.trial.more_logs.emplace_back("truth.csv", truth_csv(run.truth()->samples()));
  }
  driven.trial.world = run.design().world.world;
  driven.trial.true_margin_m =
      run.design().world.margin_m.value_or(std::numeric_limits<double>::quiet_NaN());
  return driven;
}

BundleInfo driven_info(std::uint64_t seed, const DriveParameters& parameters, bool native_rates) {
  BundleInfo info;
  info.synthetic = true;
  info.seed = seed;
  info.provenance = fmt::format(
      "synthetic, seed {}: driven by tcert in closed loop, not logged by a robot; what ends a "
      "trial "
      "comes out of the drive; streams at {}",
      seed,
      native_rates ? "83 (tactile), 50 (control) and 20 Hz (pose)" : "20 Hz");
  info.robot = corpus_robot();
  info.course = {course_start(), course_goal()};
  for (const Lighting lighting : {Lighting::dark, Lighting::indoor, Lighting::outdoor}) {
    info.lighting_tiers.emplace_back(name_of(lighting));
  }
  info.trial_limit_s = parameters.time_limit_s;
  return info;
}

}  // namespace tcert
