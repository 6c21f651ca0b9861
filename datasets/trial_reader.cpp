#include "datasets/trial_reader.hpp"

#include <algorithm>
#include <iterator>
#include <table/csv_write.hpp>
#include <tuple>
#include <utility>

#include "datasets/bundle_files.hpp"
#include "datasets/stream_clock.hpp"
#include "datasets/tick_columns.hpp"
#include "datasets/tick_table.hpp"

namespace tcert {

namespace {

/// A file of the trial, read and in order of time.
struct Stream {
  table::NumberTable table;
  std::string file;
};

enum class Presence { required, optional };

/// Reads the files of one trial one after another, collecting the problems of all of them.
class StreamReader {
 public:
  StreamReader(const Bundle& bundle, const TrialRow& trial, const ReadOptions& options)
      : bundle_(bundle),
        files_(bundle.path),
        folder_("logs/" + trial.trial_id + "/"),
        options_(options) {
    if (!files_.problem().empty()) {
      report(
          {table::Severity::error, bundle.path.string(), 0, "", files_.problem(), "a bundle", 1});
    }
  }

  [[nodiscard]] bool has(const std::string& name) const {
    return files_.find(folder_ + name).has_value();
  }

  void report(table::Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }

  /// Numbers of the file `name` of the trial.
  [[nodiscard]] std::optional<Stream> read(const std::string& name,
                                           table::NumberOptions columns,
                                           Presence presence,
                                           EqualTimes equal_times) {
    const auto found = files_.find(folder_ + name);
    if (!found) {
      if (presence == Presence::required) {
        report({table::Severity::error,
                folder_ + name,
                0,
                "",
                "",
                "this file, or it with .gz or .zst, or ticks.csv instead",
                1});
      }
      return std::nullopt;
    }
    table::BytesResult file = files_.read(*found);
    if (!file.bytes) {
      report({table::Severity::error, *found, 0, "", file.problem, "a readable file", 1});
      return std::nullopt;
    }
    bytes_ += file.bytes->size();
    table::DiagnosticGroups problems;
    columns.repair = options_.repair;
    std::optional<table::NumberTable> table =
        table::read_numbers(*file.bytes, csv_options(name, *found), columns, problems);
    if (table) {
      put_in_order(*table, *found, columns.time_column, options_.repair, equal_times, problems);
    }
    const bool good = table && !problems.has_error();
    take(problems);
    return good ? std::optional(Stream{std::move(*table), *found}) : std::nullopt;
  }

  /// Breaks of a stream's clock.
  [[nodiscard]] std::vector<std::int64_t> breaks_of(const Stream& stream) {
    table::DiagnosticGroups problems;
    const ClockLimits limits{bundle_.info.max_gap_s, bundle_.info.trial_limit_s};
    auto breaks = find_breaks(stream.table, stream.file, "time_s", limits, problems);
    take(problems);
    return breaks;
  }

  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] bool has_error() const noexcept { return tcert::table::has_error(diagnostics_); }
  [[nodiscard]] std::vector<table::Diagnostic> take_diagnostics() {
    return std::move(diagnostics_);
  }

 private:
  [[nodiscard]] table::CsvOptions csv_options(const std::string& name,
                                              const std::string& file) const {
    table::CsvOptions csv;
    csv.file = file;
    csv.decimal_comma = bundle_.decimal_comma;
    csv.fold_names = true;
    if (const auto renames = bundle_.info.columns.find(name);
        renames != bundle_.info.columns.end()) {
      csv.rename = renames->second;
    }
    return csv;
  }

  void take(table::DiagnosticGroups& problems) {
    std::vector<table::Diagnostic> more = problems.take();
    std::move(more.begin(), more.end(), std::back_inserter(diagnostics_));
  }

  const Bundle& bundle_;
  BundleFiles files_;
  std::string folder_;
  ReadOptions options_;
  std::vector<table::Diagnostic> diagnostics_;
  std::size_t bytes_ = 0;
};

PoseStream to_pose_stream(table::NumberTable table) {
  PoseStream pose;
  pose.poses.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    pose.poses.push_back({{table.at(i, 0), table.at(i, 1)}, table.at(i, 2)});
  }
  pose.time_ns = std::move(table.time_ns);
  return pose;
}

TactileStream to_tactile_stream(table::NumberTable table) {
  TactileStream tactile;
  tactile.rays = table.columns / 2;
  tactile.readings.reserve(table.rows() * tactile.rays);
  for (std::size_t i = 0; i < table.values.size(); i += 2) {
    tactile.readings.push_back({table.values[i], table.values[i + 1]});
  }
  tactile.time_ns = std::move(table.time_ns);
  return tactile;
}

ControlStream to_control_stream(table::NumberTable table) {
  ControlStream control;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    control.speed_cmd_mps.push_back(table.at(i, 0));
    control.yaw_rate_cmd_rps.push_back(table.at(i, 1));
    control.loop_latency_ms.push_back(table.at(i, 2));
  }
  control.time_ns = std::move(table.time_ns);
  return control;
}

/// Pose and tactile must overlap; ends further apart than the gap are worth a warning.
void compare_ends(const Stream& pose,
                  const Stream& tactile,
                  double max_gap_s,
                  StreamReader& reader) {
  const auto& a = pose.table.time_ns;
  const auto& b = tactile.table.time_ns;
  if (std::max(a.front(), b.front()) > std::min(a.back(), b.back())) {
    reader.report({table::Severity::error,
                   tactile.file,
                   0,
                   "time_s",
                   "no instant in common",
                   "times that overlap those of the pose: streams share one clock",
                   1});
    return;
  }
  const std::int64_t apart = a.back() - b.back();
  if (static_cast<double>(std::abs(apart)) > max_gap_s * 1e9) {
    const Stream& shorter = apart < 0 ? pose : tactile;
    std::string found = "its end ";
    table::append_seconds(found, std::abs(apart));
    reader.report({table::Severity::warning,
                   shorter.file,
                   shorter.table.lines.back(),
                   "time_s",
                   found + " s before the other stream's",
                   "streams that end together; the ticks end where this one does",
                   1});
  }
}

void read_streams(StreamReader& reader, const Bundle& bundle, TrialLog& log) {
  auto pose = reader.read(
      "pose.csv", stream_columns("pose.csv"), Presence::required, EqualTimes::in_file_order);
  auto tactile = reader.read("tactile.csv",
                             tactile_columns(bundle.info.robot),
                             Presence::required,
                             EqualTimes::in_file_order);
  auto control = reader.read(
      "control.csv", stream_columns("control.csv"), Presence::optional, EqualTimes::in_file_order);
  if (reader.has_error()) {
    return;
  }
  compare_ends(*pose, *tactile, bundle.info.max_gap_s, reader);
  for (const Stream* stream : {&*pose, &*tactile}) {
    const std::vector<std::int64_t> breaks = reader.breaks_of(*stream);
    log.breaks_ns.insert(log.breaks_ns.end(), breaks.begin(), breaks.end());
  }
  std::ranges::sort(log.breaks_ns);
  log.pose = to_pose_stream(std::move(pose->table));
  log.tactile = to_tactile_stream(std::move(tactile->table));
  if (control) {
    // A gap in what was commanded does not break the path that was driven.
    static_cast<void>(reader.breaks_of(*control));
    log.control = to_control_stream(std::move(control->table));
  }
}

void read_merged(StreamReader& reader, const Bundle& bundle, TrialLog& log) {
  const auto stream = reader.read(
      "ticks.csv", tick_columns(bundle.info.robot), Presence::required, EqualTimes::forbidden);
  if (!stream) {
    return;
  }
  log.breaks_ns = reader.breaks_of(*stream);
  table::DiagnosticGroups problems;
  log.merged = to_tick_table(
      stream->table, bundle.info.robot.rays.size(), log.breaks_ns, stream->file, problems);
  for (table::Diagnostic& diagnostic : problems.take()) {
    reader.report(std::move(diagnostic));
  }
}

}  // namespace

TrialResult read_trial(const Bundle& bundle, const TrialRow& trial, const ReadOptions& options) {
  StreamReader reader(bundle, trial, options);
  TrialLog log;
  if (!reader.has_error()) {
    if (reader.has("ticks.csv")) {
      read_merged(reader, bundle, log);
    } else {
      read_streams(reader, bundle, log);
    }
  }
  log.bytes = reader.bytes();
  TrialResult result;
  if (!reader.has_error()) {
    result.log = std::move(log);
  }
  result.diagnostics = reader.take_diagnostics();
  return result;
}

}  // namespace tcert
