#include "datasets/tracking_runs.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/rename_advice.hpp>
#include <utility>

#include "datasets/measured_cells.hpp"

namespace tcert {
namespace {

class RunReader {
 public:
  RunReader(const table::TextTable& rows,
            const std::string& file,
            table::DiagnosticGroups& problems)
      : rows_(rows), cells_(rows, file, problems) {}

  TrackingRuns read() {
    const auto curvature = rows_.find("curvature_per_m");
    const auto nominal_curvature = rows_.find("nominal_curvature_per_m");
    runs_.has_curvature = curvature.has_value();
    runs_.has_nominal_curvature = nominal_curvature.has_value();
    for (std::size_t row = 0; row < rows_.rows(); ++row) {
      constexpr std::array kNeeded{"time_s", "x_m", "y_m", "yaw_rad", "nominal_x_m", "nominal_y_m"};
      std::array<double, kNeeded.size()> cells{};
      bool whole = true;
      for (std::size_t i = 0; i < kNeeded.size(); ++i) {
        cells[i] = number(row, rows_.find(kNeeded[i]));
        whole = whole && !std::isnan(cells[i]);
      }
      const TrackedSample sample{cells[0],
                                 {{cells[1], cells[2]}, cells[3]},
                                 {cells[4], cells[5]},
                                 number(row, curvature),
                                 number(row, nominal_curvature)};
      runs_.missing += whole ? 0 : 1;
      if (whole) {
        add(row, sample);
      }
    }
    finish();
    return std::move(runs_);
  }

 private:
  void add(std::size_t row, const TrackedSample& sample) {
    const std::string& name = rows_.at(row, rows_.find("run").value());
    const auto day_column = rows_.find("day");
    const std::string day = day_column ? rows_.at(row, *day_column) : "";
    if (table::is_missing_cell(name)) {
      cells_.report(table::Severity::error, rows_.lines[row], "run", name, "a name");
      return;
    }
    days_.insert(day);
    const auto [at, is_new] = places_.try_emplace({day, name}, runs_.runs.size());
    if (is_new) {
      runs_.runs.push_back({name, day, {}});
    }
    std::vector<TrackedSample>& samples = runs_.runs[at->second].samples;
    if (!samples.empty() && sample.time_s <= samples.back().time_s) {
      cells_.report(
          table::Severity::error,
          rows_.lines[row],
          "time_s",
          table::number_text(sample.time_s) + " after " + table::number_text(samples.back().time_s),
          "times that rise within a run");
    }
    samples.push_back(sample);
  }

  double number(std::size_t row, std::optional<std::size_t> column) {
    return column ? cells_.number(row, *column).value_or(kMissing) : kMissing;
  }

  void finish() {
    runs_.days = rows_.find("day") ? days_.size() : 0;
    const SyntheticTable made = synthetic_table(rows_);
    runs_.synthetic = made.synthetic;
    runs_.seed = made.seed;
    if (runs_.missing > 0) {
      cells_.report(table::Severity::note,
                    0,
                    "",
                    std::to_string(runs_.missing) + " rows without a position or a time",
                    "both paths in each; they are left out");
    }
    if (runs_.runs.empty()) {
      cells_.report(table::Severity::error, 0, "", "no run", "rows with both paths");
    }
  }

  const table::TextTable& rows_;
  MeasuredCells cells_;
  TrackingRuns runs_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;
  std::set<std::string> days_;
};

}  // namespace

TrackingRunsResult read_tracking_runs(const table::Bytes& bytes, const table::CsvOptions& csv) {
  table::DiagnosticGroups problems;
  const std::optional<table::TextTable> rows = table::read_text_table(
      bytes,
      csv,
      {"run", "time_s", "x_m", "y_m", "yaw_rad", "nominal_x_m", "nominal_y_m"},
      problems);
  TrackingRunsResult result;
  if (rows) {
    result.runs = RunReader(*rows, csv.file, problems).read();
  }
  if (problems.has_error()) {
    result.runs.reset();
  }
  result.diagnostics = problems.take();
  table::drop_rename_advice(result.diagnostics);
  return result;
}

TrackingRunsResult read_tracking_runs(const std::filesystem::path& path, table::CsvOptions csv) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  const table::BytesResult file = table::read_file(path);
  if (!file.bytes) {
    return {std::nullopt,
            {{table::Severity::error, csv.file, 0, "", file.problem, "a readable file", 1}}};
  }
  return read_tracking_runs(*file.bytes, csv);
}

}  // namespace tcert
