#include "analysis/study/experiment/cell_scores.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tcert::study {
namespace {

const table::DataColumn& column(const table::DataTable& table, const std::string& name) {
  const table::DataColumn* const found = table.find(name);
  if (found == nullptr) {
    throw std::invalid_argument("cell scores: no column '" + name + "'");
  }
  return *found;
}

std::vector<std::string> words(const table::DataColumn& column, std::size_t rows) {
  std::vector<std::string> result;
  for (std::size_t row = 0; row < rows; ++row) {
    result.push_back(column.is_text ? column.text.levels.at(column.text.codes.at(row))
                                    : std::to_string(column.numbers.at(row)));
  }
  return result;
}

void require_same_trials(const table::DataTable& cell, const table::DataTable& full) {
  if (cell.rows != full.rows ||
      words(column(cell, "trial_id"), cell.rows) != words(column(full, "trial_id"), full.rows)) {
    throw std::invalid_argument("cell scores: the tables are of different trials");
  }
}

/// The full method's table with the cell's certificate features beside its own.
table::DataTable joined(const table::DataTable& cell,
                        const table::DataTable& full,
                        const H1Predictor& predictor) {
  table::DataTable table = full;
  for (const std::string& name : {predictor.column, predictor.landmark_column}) {
    table::DataColumn copy = column(cell, name);
    copy.name = "cell " + name;
    table.columns.push_back(std::move(copy));
  }
  return table;
}

H1Table against(const table::DataTable& cell,
                const table::DataTable& full,
                const H1Options& options) {
  const H1Predictor& tc = options.predictors.front();
  H1Options pair = options;
  pair.predictors = {{"cell " + tc.column, tc.higher, "cell " + tc.landmark_column}, tc};
  return hypothesis_h1(joined(cell, full, tc), pair);
}

CellIssuance issuance(const table::DataTable& cell,
                      const table::DataTable& full,
                      const std::string& success) {
  const std::vector<double>& outcome = column(full, success).numbers;
  const std::vector<double>& here = column(cell, "issued").numbers;
  const std::vector<double>& there = column(full, "issued").numbers;
  const std::vector<double>& before = column(cell, "issued_before_goal").numbers;
  const std::vector<double>& falls = column(cell, "certificate_falls").numbers;
  CellIssuance count;
  for (std::size_t row = 0; row < cell.rows; ++row) {
    const bool succeeded = outcome[row] == 1.0;
    if (!succeeded && outcome[row] != 0.0) {
      continue;
    }
    const bool issued = here[row] == 1.0;
    const bool issued_there = there[row] == 1.0;
    ++(succeeded ? count.successes : count.failures);
    if (issued) {
      ++(succeeded ? count.issued_successes : count.issued_failures);
    }
    count.spurious += issued && !issued_there ? 1 : 0;
    count.spurious_failures += issued && !issued_there && !succeeded ? 1 : 0;
    count.lost += !issued && issued_there ? 1 : 0;
    count.before_goal += before[row] == 1.0 ? 1 : 0;
    count.falling += falls[row] > 0.0 ? 1 : 0;
  }
  return count;
}

}  // namespace

CellScores cell_scores(const table::DataTable& cell,
                       const table::DataTable& full,
                       double landmark_s,
                       H1Options options) {
  require_same_trials(cell, full);
  options.models = false;
  CellScores scores;
  options.within.clear();  // Cells are compared with one another, not taken apart.
  H1Options own = options;
  own.landmark_s = landmark_s;
  scores.own = hypothesis_h1(cell, own);
  if (&cell != &full) {
    options.landmark_s = std::max(options.landmark_s, landmark_s);
    scores.against_full = against(cell, full, options);
  }
  scores.issuance = issuance(cell, full, options.success);
  return scores;
}

}  // namespace tcert::study
