#pragma once
/// \file
/// Public outcomes of the BARN challenge made into one feature table: a row a trial, with the
/// difficulty metrics of its world.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <table/diagnostic.hpp>
#include <utility>
#include <vector>

#include "datasets/import/barn_table.hpp"

namespace tcert {

/// Worlds from here on have moving obstacles: nothing static tells how passable they are.
inline constexpr long kFirstMovingWorld = 300;

/// A trial ends at 100 s; longer ones are kept and named.
inline constexpr double kBarnLimitSeconds = 100.0;

/// Planners that ran on another port of the simulation, with other limits.
[[nodiscard]] const std::vector<std::string>& other_port_planners();

struct BarnImportOptions {
  std::vector<std::string> planners;  ///< To keep; empty: all. Only of tables with that column.
  bool other_ports = true;            ///< Keep `other_port_planners`.
};

struct BarnSummary {
  std::size_t read = 0;
  std::size_t written = 0;
  std::size_t successes = 0;      ///< Of those written.
  std::size_t worlds = 0;         ///< Distinct, of those written.
  std::size_t bad = 0;            ///< Left out with an error.
  std::size_t not_asked_for = 0;  ///< By `planners`.
  std::size_t other_ports = 0;    ///< Left out by `other_ports`.
  std::size_t moving = 0;         ///< Left out: the world's obstacles move.
  std::size_t unmeasured = 0;     ///< Left out: the world has no metrics.
  std::string group;              ///< "planner" or "date".
  std::vector<std::pair<std::string, std::size_t>> groups;  ///< Rows written, by name.
};

struct BarnImportResult {
  std::optional<std::string> csv;  ///< Empty iff a column is missing or no row is left.
  BarnSummary summary;
  std::vector<table::Diagnostic> diagnostics;
};

/// Each of `trials` has world, success, collided, timeout, time_s and either planner or
/// first_commit_date (written as `date`), all the same of the two; `metrics` has world and m1 to
/// m5, and norm1 to norm5 or not. Exactly one of success, collided and timeout is true (1, True,
/// ...: outcome_of_cell()); time_s is above 0. A row that breaks this is left out with an error
/// that names its line; rows are left out in the order of the counts in `BarnSummary`. Written:
/// planner or date, world, success, collided, timeout, time_s, the metrics; the three as 0 and 1,
/// the other cells as they stand, one table after another. O(size).
[[nodiscard]] BarnImportResult import_barn(std::span<const BarnTable> trials,
                                           const BarnTable& metrics,
                                           const BarnImportOptions& options = {});

/// Names in the columns `planner`, sorted; empty if there is none.
[[nodiscard]] std::vector<std::string> planners_of(std::span<const BarnTable> trials);

}  // namespace tcert
