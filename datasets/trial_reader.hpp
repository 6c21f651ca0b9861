#pragma once
/// \file
/// The raw streams of one trial, as logged.

#include <cstdint>
#include <optional>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/ticks.hpp"

namespace tcert {

// `arrival_ns` of a stream is when each sample was there to be seen, not before its time; empty:
// each at its time.

struct PoseStream {
  std::vector<std::int64_t> time_ns;
  std::vector<Pose> poses;
  std::vector<std::int64_t> arrival_ns{};
  std::vector<Footing> footing{};  ///< Empty if nothing of it is measured.
};

struct ControlStream {
  std::vector<std::int64_t> time_ns;
  std::vector<double> speed_cmd_mps;  ///< NaN where missing, as in the other two.
  std::vector<double> yaw_rate_cmd_rps;
  std::vector<double> loop_latency_ms;
  std::vector<std::int64_t> arrival_ns{};
};

/// `readings` is row-major, samples x rays of the robot.
struct TactileStream {
  std::size_t rays = 0;
  std::vector<std::int64_t> time_ns;
  std::vector<RayReading> readings;
  std::vector<std::int64_t> arrival_ns{};
};

/// The log of one trial: three streams, or ticks that were merged by whoever logged them.
struct TrialLog {
  PoseStream pose;
  TactileStream tactile;
  ControlStream control;  ///< Empty if the trial has none: it is not required.
  std::optional<TickTable> merged;
  std::vector<std::int64_t>
      breaks_ns;                  ///< Clock jumps: the path breaks at the first tick at or after.
  bool starts_with_pose = false;  ///< Ticks begin with the poses, stale until there is a touch.
  std::size_t bytes = 0;          ///< Read from disk, decompressed.
};

struct ReadOptions {
  bool repair = false;  ///< Drop or merge bad rows, counted, instead of rejecting the trial.
};

struct TrialResult {
  std::optional<TrialLog> log;  ///< Empty iff the trial is rejected.
  std::vector<table::Diagnostic> diagnostics;
};

/// Reads the logs of one trial. Never throws on bad content. Thread-safe: several trials of one
/// bundle may be read at once.
[[nodiscard]] TrialResult read_trial(const Bundle& bundle,
                                     const TrialRow& trial,
                                     const ReadOptions& options = {});

/// See resample.def.
struct ResampleOptions {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include "datasets/resample.def"
};

/// See <tcert/parameter_fields.hpp>; the first argument only names the list.
template <class Visit>
void visit_fields(const ResampleOptions& /*list*/, Visit&& visit) {
  using Group = ResampleOptions;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include "datasets/resample.def"
}

/// \throws std::invalid_argument naming the option and what it must be.
void validate(const ResampleOptions& options);

/// Ticks t_k = t_0 + k tick_s, t_0 = the first instant at which pose and tactile have a sample,
/// until the first of them ends. Pose and command by zero-order hold, of slope, step and slip the
/// worst since the tick before; bend, range and force by the
/// median of the newest samples at or before t_k. Of each stream a tick sees only samples that have
/// arrived by then; how old they are is told by their times, and ticks before the first of them are
/// left out. A merged log is handed back as it is.
[[nodiscard]] TickTable resample(const TrialLog& log, const ResampleOptions& options = {});

}  // namespace tcert
