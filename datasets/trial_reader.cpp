#include "datasets/trial_reader.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/clock_reporter.hpp"
#include "datasets/empty_samples.hpp"
#include "datasets/range_report.hpp"
#include "datasets/range_rule.hpp"
#include "datasets/stream_overlap.hpp"
#include "datasets/stream_reader.hpp"
#include "datasets/tick_columns.hpp"
#include "datasets/tick_table.hpp"

namespace tcert {

namespace {

constexpr const char* kControlFile = "control.csv";

/// When the samples of a stream arrived, empty if its file does not say; arrival_s is the last
/// column.
std::vector<std::int64_t> arrivals_of(const table::NumberTable& table) {
  std::vector<std::int64_t> arrivals;
  for (std::size_t i = 0; table.present.back() != 0 && i < table.rows(); ++i) {
    const double delay_ns = table.at(i, table.columns - 1);
    arrivals.push_back(table.time_ns[i] + (std::isnan(delay_ns) ? 0 : std::llround(delay_ns)));
  }
  return arrivals;
}

PoseStream to_pose_stream(table::NumberTable table) {
  PoseStream pose;
  pose.arrival_ns = arrivals_of(table);
  pose.poses.reserve(table.rows());
  const bool has_footing = std::ranges::any_of(std::span(table.present).subspan(3, kFootingColumns),
                                               [](std::uint8_t there) { return there != 0; });
  for (std::size_t i = 0; i < table.rows(); ++i) {
    pose.poses.push_back({{table.at(i, 0), table.at(i, 1)}, table.at(i, 2)});
    if (has_footing) {
      pose.footing.push_back({table.at(i, 3), table.at(i, 4), table.at(i, 5), table.at(i, 6)});
    }
  }
  pose.time_ns = std::move(table.time_ns);
  return pose;
}

TactileStream to_tactile_stream(table::NumberTable table) {
  TactileStream tactile;
  tactile.arrival_ns = arrivals_of(table);
  tactile.rays = table.columns / kColumnsPerRay;
  tactile.readings.reserve(table.rows() * tactile.rays);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t c = 0; c < kColumnsPerRay * tactile.rays; c += kColumnsPerRay) {
      tactile.readings.push_back({table.at(row, c), table.at(row, c + 1), table.at(row, c + 2)});
    }
  }
  tactile.time_ns = std::move(table.time_ns);
  return tactile;
}

ControlStream to_control_stream(table::NumberTable table) {
  ControlStream control;
  control.arrival_ns = arrivals_of(table);
  for (std::vector<double>* column :
       {&control.speed_cmd_mps, &control.yaw_rate_cmd_rps, &control.loop_latency_ms}) {
    column->reserve(table.rows());
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    control.speed_cmd_mps.push_back(table.at(i, 0));
    control.yaw_rate_cmd_rps.push_back(table.at(i, 1));
    control.loop_latency_ms.push_back(table.at(i, 2));
  }
  control.time_ns = std::move(table.time_ns);
  return control;
}

/// Understands the readings of a tactile.csv by the rules of its rays. A row that says nothing then
/// is no sample either.
void resolve_readings(const Bundle& bundle, Stream& tactile, StreamReader& reader) {
  const RangeRules rules(bundle.info.robot, bundle.info.range_keys);
  std::vector<RangeCount> counts(rules.rays());
  table::NumberTable& table = tactile.table;
  for (std::size_t k = 0; k < rules.rays(); ++k) {
    for (std::size_t row = 0; rules.is_range(k) && row < table.rows(); ++row) {
      double& value = table.values[row * table.columns + kColumnsPerRay * k];
      value = rules.resolve(k, value, counts[k]);
    }
  }
  if (std::ranges::any_of(counts, &RangeCount::has_missing)) {
    drop_empty_rows(table, kColumnsPerRay * rules.rays());
  }
  for (table::Diagnostic& one : range_report(bundle.info.robot, counts, tactile.file)) {
    reader.report(std::move(one));
  }
  if (table.rows() == 0) {
    reader.report({table::Severity::error,
                   tactile.file,
                   0,
                   "",
                   std::to_string(table.empty_rows) + " rows, none with a reading",
                   "at least one reading of a ray",
                   1});
  }
}

/// A sample is not there before it is made; without a word when it came, it came at once.
void check_arrivals(const Stream& stream, StreamReader& reader) {
  const table::NumberTable& table = stream.table;
  if (table.present.back() == 0) {
    return;
  }
  const std::string column(kArrivalColumn);
  table::DiagnosticGroups problems;
  std::size_t missing = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double delay_ns = table.at(row, table.columns - 1);
    missing += std::isnan(delay_ns) ? 1 : 0;
    if (delay_ns < 0.0) {
      const std::int64_t time = table.time_ns[row];
      problems.add({table::Severity::error,
                    stream.file,
                    table.lines[row],
                    column,
                    seconds_text(time + std::llround(delay_ns)) + " before " + seconds_text(time),
                    "a time at or after time_s, on the same clock",
                    1});
    }
  }
  if (missing > 0) {
    problems.add(
        {table::Severity::note,
         stream.file,
         0,
         column,
         std::to_string(missing) + " of " + std::to_string(table.rows()) + " cells missing",
         "a time; these samples count as there at once",
         1});
  }
  reader.report(problems);
}

/// A stream with its arrivals looked at; empty if it is rejected.
std::optional<Stream> read_stream(StreamReader& reader,
                                  const std::string& name,
                                  table::NumberOptions columns) {
  std::optional<Stream> stream = reader.read(name, std::move(columns));
  if (stream) {
    check_arrivals(*stream, reader);
  }
  return stream;
}

/// Says how many rows were no samples of their stream.
void note_empty_rows(const Stream& stream, StreamReader& reader) {
  if (stream.table.empty_rows > 0) {
    const std::size_t all = stream.table.rows() + stream.table.empty_rows;
    reader.report({table::Severity::note,
                   stream.file,
                   0,
                   "",
                   std::to_string(stream.table.empty_rows) + " of " + std::to_string(all) +
                       " rows without a value",
                   "rows with one; the others are no samples of this stream",
                   1});
  }
}

/// Commands are not required: what is wrong with them costs them, never the trial.
void drop_bad_control(StreamReader& reader, std::optional<Stream>& control) {
  if (reader.forgive(kControlFile)) {
    reader.report({table::Severity::warning,
                   reader.path_of(kControlFile),
                   0,
                   "",
                   "a file with errors",
                   "commands; the trial is used without them",
                   1});
    control.reset();
  }
}

/// Puts the streams that could be read in order of their common clock.
void settle(StreamReader& reader,
            std::optional<Stream>& pose,
            std::optional<Stream>& tactile,
            std::optional<Stream>& control) {
  std::vector<Stream*> streams;
  for (std::optional<Stream>* one : {&pose, &tactile}) {
    if (*one) {
      streams.push_back(&**one);
    }
  }
  if (streams.empty()) {
    return;
  }
  if (control && reader.step_alike(streams)) {
    streams.push_back(&*control);
    if (!reader.step_alike(streams)) {
      streams.pop_back();
      reader.report({table::Severity::error,
                     control->file,
                     0,
                     "time_s",
                     "steps back that pose.csv has not, or the other way round",
                     "the clock of the other streams",
                     1});
    }
  }
  reader.settle_clocks(streams, EqualTimes::in_file_order);
  drop_bad_control(reader, control);
}

void read_streams(StreamReader& reader, const Bundle& bundle, TrialLog& log) {
  auto pose = read_stream(reader, "pose.csv", stream_columns("pose.csv"));
  auto tactile = read_stream(reader, "tactile.csv", tactile_columns(bundle.info.robot));
  if (tactile) {
    resolve_readings(bundle, *tactile, reader);
  }
  std::optional<Stream> control;
  if (reader.has(kControlFile)) {
    control = read_stream(reader, kControlFile, stream_columns(kControlFile));
    drop_bad_control(reader, control);
  }
  settle(reader, pose, tactile, control);
  if (reader.has_error()) {
    return;
  }
  compare_streams(*pose, *tactile, bundle.info, reader);
  for (const Stream* stream : {&*pose, &*tactile}) {
    note_empty_rows(*stream, reader);
    const std::vector<std::int64_t> breaks = reader.breaks_of(*stream);
    log.breaks_ns.insert(log.breaks_ns.end(), breaks.begin(), breaks.end());
  }
  std::ranges::sort(log.breaks_ns);
  log.starts_with_pose = bundle.info.start_at == StartAt::pose;
  if (control && shares_clock(*control, *pose, bundle.info.max_gap_s, reader)) {
    // A gap in what was commanded does not break the path that was driven.
    static_cast<void>(reader.breaks_of(*control, PathBreaks::none));
    log.control = to_control_stream(std::move(control->table));
  }
  log.pose = to_pose_stream(std::move(pose->table));
  log.tactile = to_tactile_stream(std::move(tactile->table));
}

void read_merged(StreamReader& reader, const Bundle& bundle, TrialLog& log) {
  auto stream = reader.read("ticks.csv", tick_columns(bundle.info.robot));
  if (!stream) {
    return;
  }
  Stream* const alone = &*stream;
  reader.settle_clocks(std::span(&alone, 1), EqualTimes::forbidden);
  if (reader.has_error()) {
    return;
  }
  log.breaks_ns = reader.breaks_of(*stream);
  table::DiagnosticGroups problems;
  std::vector<RangeCount> counts;
  log.merged = to_tick_table(stream->table,
                             RangeRules(bundle.info.robot, bundle.info.range_keys),
                             log.breaks_ns,
                             stream->file,
                             counts,
                             problems);
  reader.report(problems);
  for (table::Diagnostic& one : range_report(bundle.info.robot, counts, stream->file)) {
    reader.report(std::move(one));
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
