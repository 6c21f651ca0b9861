#include "datasets/stream_reader.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "datasets/clock_reporter.hpp"
#include "datasets/clock_steps.hpp"
#include "datasets/column_hints.hpp"
#include "datasets/joined_seconds.hpp"
#include "datasets/ray_names.hpp"

namespace tcert {
namespace {

constexpr const char* kTime = "time_s";

bool increases(const std::vector<std::int64_t>& times) {
  return std::ranges::adjacent_find(times, std::greater_equal<>{}) == times.end();
}

/// What is wrong with the times of streams that share one clock.
struct SharedClock {
  SharedClock(std::span<Stream* const> streams, std::int64_t gap_ns) {
    for (const Stream* stream : streams) {
      faults.push_back(find_clock_faults(stream->table.time_ns, gap_ns));
    }
    if (std::ranges::all_of(faults, [](const ClockFaults& one) { return one.steps.empty(); })) {
      shifts.emplace();
      return;
    }
    std::vector<StreamSteps> steps;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      steps.push_back({&faults[i], median_step_ns(streams[i]->table.time_ns)});
    }
    shifts = shifts_after_steps(steps, gap_ns);
  }

  /// A stream that never steps back can be put in order whatever the others do.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> shifts_of(std::size_t i) const {
    return faults[i].steps.empty() ? std::vector<std::int64_t>() : shifts;
  }

  std::vector<ClockFaults> faults;
  std::optional<std::vector<std::int64_t>> shifts;
};

}  // namespace

table::CsvOptions csv_of_stream(const Bundle& bundle,
                                const std::string& name,
                                const std::string& file) {
  table::CsvOptions csv;
  csv.file = file;
  csv.decimal_comma = bundle.decimal_comma;
  csv.fold_names = true;
  if (const auto renames = bundle.info.columns.find(name); renames != bundle.info.columns.end()) {
    csv.rename = renames->second;
  }
  return csv;
}

StreamReader::StreamReader(const Bundle& bundle, const TrialRow& trial, const ReadOptions& options)
    : bundle_(bundle),
      files_(bundle.path),
      folder_("logs/" + trial.trial_id + "/"),
      options_(options) {
  if (!files_.problem().empty()) {
    report({table::Severity::error, bundle.path.string(), 0, "", files_.problem(), "a bundle", 1});
  }
}

bool StreamReader::has(const std::string& name) const {
  return files_.find(folder_ + name).has_value();
}

std::optional<Stream> StreamReader::read(const std::string& name, table::NumberOptions columns) {
  const auto found = files_.find(folder_ + name);
  if (!found) {
    report({table::Severity::error,
            folder_ + name,
            0,
            "",
            "",
            "this file, or it with .gz or .zst, or ticks.csv instead",
            1});
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
  columns.skip_empty_rows = true;
  const table::CsvOptions csv = csv_of_stream(bundle_, name, *found);
  std::optional<table::NumberTable> table =
      table::read_numbers(*file.bytes, csv, columns, problems);
  if (!table) {
    add_column_hints(*file.bytes, csv, columns, problems);
    report(problems);
    return std::nullopt;
  }
  Stream stream{std::move(*table), *found};
  stream.rises = increases(stream.table.time_ns);
  // What was joined in two columns at once is not told apart.
  const bool arrives = columns.columns.back().is_time && stream.table.present.back() != 0;
  if (!stream.rises && !arrives) {
    settle_stamps(*file.bytes, csv, stream, problems);
  }
  const bool good = !problems.has_error();
  report(problems);
  return good ? std::optional(std::move(stream)) : std::nullopt;
}

// Stamps that do not rise as they stand but do if they are read as seconds and nanoseconds.
void StreamReader::settle_stamps(const table::Bytes& bytes,
                                 const table::CsvOptions& csv,
                                 Stream& stream,
                                 table::DiagnosticGroups& problems) const {
  auto times = joined_seconds(bytes, csv, kTime, stream.table.lines);
  if (!times) {
    return;
  }
  const std::vector<std::int64_t>& stated = stream.table.time_ns;
  const auto back = std::ranges::adjacent_find(stated, std::greater_equal<>{});
  const auto row = static_cast<std::size_t>(back - stated.begin()) + 1;
  const std::string wish =
      "seconds as decimals; here seconds and nanoseconds are joined without the zeros between "
      "(1.5 for 1.000000005)";
  problems.add({options_.repair ? table::Severity::warning : table::Severity::error,
                stream.file,
                stream.table.lines[row],
                kTime,
                seconds_text(*std::next(back)) + " after " + seconds_text(*back),
                wish + (options_.repair ? "; they are read so" : "; --repair reads them so"),
                1});
  stream.table.time_ns = std::move(*times);
}

void StreamReader::settle_clocks(std::span<Stream* const> streams, EqualTimes equal_times) {
  if (std::ranges::all_of(streams, &Stream::rises)) {
    return;
  }
  const SharedClock clock(streams, gap_in_nanoseconds(bundle_.info.max_gap_s));
  for (std::size_t i = 0; i < streams.size(); ++i) {
    table::DiagnosticGroups problems;
    streams[i]->set_back_ns = put_in_order(streams[i]->table,
                                           clock.faults[i],
                                           clock.shifts_of(i),
                                           {streams[i]->file, kTime, options_.repair, equal_times},
                                           problems);
    report(problems);
  }
}

bool StreamReader::step_alike(std::span<Stream* const> streams) const {
  return std::ranges::all_of(streams, &Stream::rises) ||
         SharedClock(streams, gap_in_nanoseconds(bundle_.info.max_gap_s)).shifts.has_value();
}

std::vector<std::int64_t> StreamReader::breaks_of(const Stream& stream, PathBreaks path) {
  table::DiagnosticGroups problems;
  const ClockLimits limits{bundle_.info.max_gap_s, bundle_.info.trial_limit_s, path};
  auto breaks = find_breaks(stream.table, stream.file, kTime, limits, problems);
  report(problems);
  breaks.insert(breaks.end(), stream.set_back_ns.begin(), stream.set_back_ns.end());
  std::ranges::sort(breaks);
  return breaks;
}

void StreamReader::report(table::Diagnostic diagnostic) {
  diagnostics_.push_back(std::move(diagnostic));
}

void StreamReader::report(table::DiagnosticGroups& problems) {
  std::ranges::move(joined_over_rays(problems.take(), bundle_.info.robot),
                    std::back_inserter(diagnostics_));
}

bool StreamReader::forgive(const std::string& name) {
  bool any = false;
  for (table::Diagnostic& one : diagnostics_) {
    if (one.severity == table::Severity::error && one.file.starts_with(folder_ + name)) {
      one.severity = table::Severity::warning;
      any = true;
    }
  }
  return any;
}

std::vector<table::Diagnostic> StreamReader::take_diagnostics() { return std::move(diagnostics_); }

}  // namespace tcert
