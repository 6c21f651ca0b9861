#include "datasets/import/import_barn.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <table/csv_write.hpp>
#include <table/outcome_word.hpp>

#include "datasets/import/barn_metrics.hpp"

namespace tcert {
namespace {

bool is_true(const std::string& cell) {
  return table::outcome_of_cell(cell) == table::OutcomeWord::success;
}

bool is_flag(const std::string& cell) {
  return is_true(cell) || table::outcome_of_cell(cell) == table::OutcomeWord::failure;
}

/// True if the row can be used; else what is wrong with it has been said.
bool check_row(const BarnSource& trials, std::size_t row) {
  bool good = true;
  const auto reject = [&](std::string_view column, const char* expectation) {
    trials.add(
        table::Severity::error, row, column, std::string(expectation) + "; the row is left out");
    good = false;
  };
  if (!barn_world(trials.cell(row, "world"))) {
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

/// Joins trials and worlds, a table after another.
class BarnJoin {
 public:
  /// What they are made from must outlive it.
  BarnJoin(const std::map<long, std::string>& metrics,
           const BarnImportOptions& options,
           bool by_planner)
      : metrics_(metrics), options_(options), by_planner_(by_planner) {}

  void take(const BarnSource& trials) {
    for (std::size_t row = 0; row < trials.rows(); ++row) {
      ++summary_.read;
      const std::string& group = trials.cell(row, by_planner_ ? "planner" : "first_commit_date");
      if (const auto reason = reason_against(trials, row, group)) {
        ++(summary_.*reason);
      } else {
        write(trials, row, group);
      }
    }
  }

  [[nodiscard]] const std::string& rows() const noexcept { return rows_; }

  [[nodiscard]] BarnSummary summary() const {
    BarnSummary summary = summary_;
    summary.group = by_planner_ ? "planner" : "date";
    summary.worlds = worlds_.size();
    summary.groups.assign(groups_.begin(), groups_.end());
    return summary;
  }

 private:
  /// Why a row is not written; null if it is.
  [[nodiscard]] std::size_t BarnSummary::*reason_against(const BarnSource& trials,
                                                         std::size_t row,
                                                         const std::string& group) const {
    if (by_planner_ && !options_.planners.empty() && !contains(options_.planners, group)) {
      return &BarnSummary::not_asked_for;
    }
    if (by_planner_ && !options_.other_ports && contains(other_port_planners(), group)) {
      return &BarnSummary::other_ports;
    }
    if (!check_row(trials, row)) {
      return &BarnSummary::bad;
    }
    const long world = *barn_world(trials.cell(row, "world"));
    if (world >= kFirstMovingWorld) {
      return &BarnSummary::moving;
    }
    return metrics_.contains(world) ? nullptr : &BarnSummary::unmeasured;
  }

  void write(const BarnSource& trials, std::size_t row, const std::string& group) {
    const long world = *barn_world(trials.cell(row, "world"));
    table::append_text(rows_, group);
    rows_ += ',' + std::to_string(world);
    for (const char* const column : {"success", "collided", "timeout"}) {
      rows_ += is_true(trials.cell(row, column)) ? ",1" : ",0";
    }
    rows_ += ',' + trials.cell(row, "time_s");
    rows_ += metrics_.at(world) + '\n';
    ++summary_.written;
    summary_.successes += is_true(trials.cell(row, "success")) ? 1U : 0U;
    ++groups_[group];
    worlds_.insert(world);
  }

  const std::map<long, std::string>& metrics_;
  const BarnImportOptions& options_;
  bool by_planner_;
  std::string rows_;
  BarnSummary summary_;
  std::map<std::string, std::size_t> groups_;
  std::set<long> worlds_;
};

}  // namespace

const std::vector<std::string>& other_port_planners() {
  static const std::vector<std::string> names{"mppi_ros2", "ros2_maity"};
  return names;
}

std::vector<std::string> planners_of(std::span<const BarnTable> trials) {
  std::set<std::string> names;
  for (const BarnTable& one : trials) {
    if (const auto column = one.table.find("planner")) {
      for (std::size_t row = 0; row < one.table.rows(); ++row) {
        names.insert(one.table.at(row, *column));
      }
    }
  }
  return {names.begin(), names.end()};
}

BarnImportResult import_barn(std::span<const BarnTable> trials,
                             const BarnTable& metrics,
                             const BarnImportOptions& options) {
  BarnImportResult result;
  table::DiagnosticGroups problems;
  const BarnSource measured(metrics, problems);
  const bool by_planner = !trials.empty() && trials.front().table.find("planner").has_value();
  const std::string group = by_planner ? "planner" : "first_commit_date";
  bool usable = measured.require({"world", "m1", "m2", "m3", "m4", "m5"});
  for (const BarnTable& one : trials) {
    const BarnSource source(one, problems);
    usable = source.require({group, "world", "success", "collided", "timeout", "time_s"}) && usable;
  }
  if (!usable) {
    result.diagnostics = problems.take();
    return result;
  }
  const std::vector<std::string> columns = metric_columns(measured);
  const std::map<long, std::string> by_world = metrics_by_world(measured, columns);
  BarnJoin join(by_world, options, by_planner);
  for (const BarnTable& one : trials) {
    join.take(BarnSource(one, problems));
  }
  result.summary = join.summary();
  if (result.summary.written > 0) {
    std::string csv = result.summary.group + ",world,success,collided,timeout,time_s";
    for (const std::string& column : columns) {
      csv += ',' + column;
    }
    result.csv = csv + '\n' + join.rows();
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert
