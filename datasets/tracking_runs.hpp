#pragma once
/// \file
/// Runs of a robot beside the paths that they were to follow: what tracking buffers are measured
/// on.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <tcert/geometry.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert {

/// One row.
struct TrackedSample {
  double time_s = 0.0;
  Pose executed;
  Point nominal;
  double curvature_per_m = kMissing;  ///< Anticlockwise above 0, as that of the next.
  double nominal_curvature_per_m = kMissing;
};

struct TrackingRun {
  std::string run;
  std::string day;                     ///< Empty without a column day.
  std::vector<TrackedSample> samples;  ///< Times rise.
};

struct TrackingRuns {
  std::vector<TrackingRun> runs;  ///< In the order in which they begin in the file.
  std::size_t days = 0;           ///< Distinct ones; 0 without a column day.
  bool has_curvature = false;     ///< The executed one is stated.
  bool has_nominal_curvature = false;
  std::size_t missing = 0;            ///< Rows without a position or time: not among the samples.
  bool synthetic = false;             ///< There is a column synthetic_seed.
  std::optional<std::uint64_t> seed;  ///< In its first row.
};

struct TrackingRunsResult {
  std::optional<TrackingRuns> runs;  ///< Empty iff there is an error.
  std::vector<table::Diagnostic> diagnostics;
};

/// A table with the columns run, time_s, x_m, y_m, yaw_rad, nominal_x_m, nominal_y_m, and if they
/// are there day, curvature_per_m, nominal_curvature_per_m; others are not looked at. A run is what
/// has one name on one day. Rows without a number that is needed are left out and counted. Errors:
/// a cell that is no number, a time that does not rise within its run, a run without a name.
/// O(size).
[[nodiscard]] TrackingRunsResult read_tracking_runs(const table::Bytes& bytes,
                                                    const table::CsvOptions& csv);

/// The same from a file, expanded if it is compressed.
[[nodiscard]] TrackingRunsResult read_tracking_runs(const std::filesystem::path& path,
                                                    table::CsvOptions csv = {});

}  // namespace tcert
