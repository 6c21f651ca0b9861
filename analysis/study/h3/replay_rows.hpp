#pragma once
/// \file
/// The table of replays as H3 uses it: its columns, and its rows by trial and case.

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <table/data_table.hpp>
#include <utility>
#include <vector>

#include "analysis/study/h3/hypothesis_h3.hpp"

namespace tcert::study {

/// A speed law and its beta.
using CaseKey = std::pair<std::string, double>;

/// The columns of the table, as they are used.
struct ReplayRows {
  std::vector<std::string> trial, algorithm, lighting, cluster, law;
  std::vector<double> success, beta, length, time, gated_time, speed, gated_speed, latency, stalls,
      kept;
};

/// \throws FormulaError if a column is not there or holds text for numbers.
[[nodiscard]] ReplayRows rows_of(const table::DataTable& table, const H3Options& options);

/// One trial of the two algorithms: the row of each case.
struct H3Trial {
  bool baseline = false;
  bool success = false;
  std::map<CaseKey, std::size_t> row;
  [[nodiscard]] std::size_t any_row() const { return row.begin()->second; }
};

/// Trials by lighting, each with its rows; trials that lack a case are refused.
struct Grouped {
  std::map<std::string, std::vector<H3Trial>> by_lighting;
  std::set<CaseKey> cases;
  std::size_t unknown = 0;
};

/// \throws std::invalid_argument if a trial has two rows of a case, or none.
[[nodiscard]] Grouped grouped(const ReplayRows& rows, const H3Options& options);

}  // namespace tcert::study
