#include "datasets/import_barn.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/outcome_word.hpp>

namespace tcert {
namespace {

std::optional<double> finite_number(std::string_view cell) {
  const table::CellReading reading = table::read_cell(cell);
  const bool is_number =
      reading.meaning == table::CellMeaning::number && std::isfinite(reading.value);
  return is_number ? std::optional(reading.value) : std::nullopt;
}

std::optional<long> world_of(std::string_view cell) {
  long world = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, world);
  return error == std::errc{} && stop == end && world >= 0 ? std::optional(world) : std::nullopt;
}

/// A table with the places of its problems.
class Source {
 public:
  Source(const table::TextTable& table, std::string file, table::DiagnosticGroups& problems)
      : table_(table), file_(std::move(file)), problems_(problems) {}

  [[nodiscard]] std::size_t rows() const noexcept { return table_.rows(); }
  [[nodiscard]] bool has(std::string_view column) const noexcept {
    return table_.find(column).has_value();
  }
  [[nodiscard]] const std::string& cell(std::size_t row, std::string_view column) const {
    return table_.at(row, table_.find(column).value());
  }

  /// True if all columns are there; the missing ones are errors.
  [[nodiscard]] bool require(const std::vector<std::string>& columns) const {
    bool all = true;
    for (const std::string& column : columns) {
      if (!has(column)) {
        problems_.add({table::Severity::error, file_, 0, column, "", "a column of this name", 1});
        all = false;
      }
    }
    return all;
  }

  void add(table::Severity severity,
           std::size_t row,
           std::string_view column,
           std::string expectation) const {
    problems_.add({severity,
                   file_,
                   table_.lines[row],
                   std::string(column),
                   table::shortened(cell(row, column)),
                   std::move(expectation),
                   1});
  }

 private:
  const table::TextTable& table_;
  std::string file_;
  table::DiagnosticGroups& problems_;
};

std::vector<std::string> metric_columns(const Source& metrics) {
  std::vector<std::string> columns{"m1", "m2", "m3", "m4", "m5"};
  for (const char* const name : {"norm1", "norm2", "norm3", "norm4", "norm5"}) {
    if (metrics.has(name)) {
      columns.emplace_back(name);
    }
  }
  return columns;
}

/// World -> its metrics as cells, each with a comma before it. Worlds with a bad cell are left out.
std::map<long, std::string> metrics_by_world(const Source& metrics,
                                             const std::vector<std::string>& columns) {
  std::map<long, std::string> result;
  std::set<long> seen;
  for (std::size_t row = 0; row < metrics.rows(); ++row) {
    const std::optional<long> world = world_of(metrics.cell(row, "world"));
    if (!world) {
      metrics.add(
          table::Severity::error, row, "world", "a whole number, 0 or more; the row is left out");
      continue;
    }
    if (!seen.insert(*world).second) {
      metrics.add(table::Severity::error, row, "world", "each world once; the first row counts");
      continue;
    }
    std::string cells;
    bool good = true;
    for (const std::string& column : columns) {
      if (!finite_number(metrics.cell(row, column))) {
        metrics.add(
            table::Severity::error, row, column, "a finite number; the world has no metrics");
        good = false;
      }
      cells += ',' + metrics.cell(row, column);
    }
    if (good) {
      result.emplace(*world, cells);
    }
  }
  return result;
}

bool is_true(const std::string& cell) {
  return table::outcome_of_cell(cell) == table::OutcomeWord::success;
}

bool is_flag(const std::string& cell) {
  return is_true(cell) || table::outcome_of_cell(cell) == table::OutcomeWord::failure;
}

/// True if the row can be used; else what is wrong with it has been said.
bool check_row(const Source& trials, std::size_t row) {
  bool good = true;
  const auto reject = [&](std::string_view column, const char* expectation) {
    trials.add(
        table::Severity::error, row, column, std::string(expectation) + "; the row is left out");
    good = false;
  };
  if (!world_of(trials.cell(row, "world"))) {
    reject("world", "a whole number, 0 or more");
  }
  int endings = 0;
  for (const char* const column : {"success", "collided", "timeout"}) {
    if (!is_flag(trials.cell(row, column))) {
      reject(column, "0 or 1, true or false");
    }
    endings += is_true(trials.cell(row, column)) ? 1 : 0;
  }
  if (good && endings != 1) {
    reject("success", "exactly one of success, collided and timeout to be 1");
  }
  const std::optional<double> time = finite_number(trials.cell(row, "time_s"));
  if (!time || !(*time > 0.0)) {
    reject("time_s", "a time above 0 s");
  } else if (*time > 1.01 * kBarnLimitSeconds) {
    trials.add(
        table::Severity::warning, row, "time_s", "at most 101 s, for a trial ends at 100; kept");
  }
  return good;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Why a row is not written; null if it is. `by_planner` says that the group is a planner.
std::size_t BarnSummary::*reason_against(const Source& trials,
                                         std::size_t row,
                                         const std::string& group,
                                         bool by_planner,
                                         const std::map<long, std::string>& metrics,
                                         const BarnImportOptions& options) {
  if (by_planner && !options.planners.empty() && !contains(options.planners, group)) {
    return &BarnSummary::not_asked_for;
  }
  if (by_planner && !options.other_ports && contains(other_port_planners(), group)) {
    return &BarnSummary::other_ports;
  }
  if (!check_row(trials, row)) {
    return &BarnSummary::bad;
  }
  const long world = *world_of(trials.cell(row, "world"));
  if (world >= kFirstMovingWorld) {
    return &BarnSummary::moving;
  }
  return metrics.contains(world) ? nullptr : &BarnSummary::unmeasured;
}

}  // namespace

const std::vector<std::string>& other_port_planners() {
  static const std::vector<std::string> names{"mppi_ros2", "ros2_maity"};
  return names;
}

std::vector<std::string> planners_of(const table::TextTable& trials) {
  std::set<std::string> names;
  if (const auto column = trials.find("planner")) {
    for (std::size_t row = 0; row < trials.rows(); ++row) {
      names.insert(trials.at(row, *column));
    }
  }
  return {names.begin(), names.end()};
}

BarnImportResult import_barn(const table::TextTable& trials,
                             const std::string& trials_file,
                             const table::TextTable& metrics,
                             const std::string& metrics_file,
                             const BarnImportOptions& options) {
  BarnImportResult result;
  table::DiagnosticGroups problems;
  const Source source(trials, trials_file, problems);
  const Source measured(metrics, metrics_file, problems);
  const bool by_planner = source.has("planner");
  const std::string group_column = by_planner ? "planner" : "first_commit_date";
  const bool usable =
      source.require({group_column, "world", "success", "collided", "timeout", "time_s"});
  if (!measured.require({"world", "m1", "m2", "m3", "m4", "m5"}) || !usable) {
    result.diagnostics = problems.take();
    return result;
  }
  const std::vector<std::string> columns = metric_columns(measured);
  const std::map<long, std::string> by_world = metrics_by_world(measured, columns);

  BarnSummary& summary = result.summary;
  summary.group = by_planner ? "planner" : "date";
  std::string csv = summary.group + ",world,success,collided,timeout,time_s";
  for (const std::string& column : columns) {
    csv += ',' + column;
  }
  csv += '\n';
  std::map<std::string, std::size_t> groups;
  std::set<long> worlds;
  for (std::size_t row = 0; row < source.rows(); ++row) {
    ++summary.read;
    const std::string& group = source.cell(row, group_column);
    if (const auto reason = reason_against(source, row, group, by_planner, by_world, options)) {
      ++(summary.*reason);
      continue;
    }
    const long world = *world_of(source.cell(row, "world"));
    table::append_text(csv, group);
    csv += ',' + std::to_string(world);
    for (const char* const column : {"success", "collided", "timeout"}) {
      csv += is_true(source.cell(row, column)) ? ",1" : ",0";
    }
    csv += ',' + source.cell(row, "time_s");
    csv += by_world.at(world) + '\n';
    ++summary.written;
    summary.successes += is_true(source.cell(row, "success")) ? 1U : 0U;
    ++groups[group];
    worlds.insert(world);
  }
  summary.worlds = worlds.size();
  summary.groups.assign(groups.begin(), groups.end());
  if (summary.written > 0) {
    result.csv = std::move(csv);
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert
