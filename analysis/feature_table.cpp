#include "analysis/feature_table.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/trial_columns.hpp"
#include "datasets/csv_write.hpp"
#include "datasets/nearest_name.hpp"

namespace tcert {
namespace {

void require_distinct_columns(const FeatureTable& table) {
  std::set<std::string> names;
  for (const TrialColumn& column : trial_columns()) {
    names.emplace(column.name);
  }
  for (const FeatureColumn& column : feature_columns()) {
    names.emplace(column.name);
  }
  for (const std::string& name : table.extra_columns) {
    if (!names.insert(case_folded(name)).second) {
      throw std::invalid_argument("feature table: the trials have a column '" + name +
                                  "', which is the name of another column; rename it");
    }
  }
}

void append_header(std::string& out, const FeatureTable& table) {
  for (const TrialColumn& column : trial_columns()) {
    out += column.name;
    out += ',';
  }
  for (const std::string& name : table.extra_columns) {
    append_text(out, name);
    out += ',';
  }
  for (const FeatureColumn& column : feature_columns()) {
    out += column.name;
    out += ',';
  }
  out.back() = '\n';
}

void append_row(std::string& out, const FeatureRow& row) {
  for (const TrialColumn& column : trial_columns()) {
    column.append(out, row.trial);
    out += ',';
  }
  for (const std::string& cell : row.trial.extra) {
    append_text(out, cell);
    out += ',';
  }
  for (const FeatureColumn& column : feature_columns()) {
    if (const auto value = column.get(row.features)) {
      append_number(out, *value);
    }
    out += ',';
  }
  out.back() = '\n';
}

/// What a column of the file is read as: one of the two, or an extra column.
struct Target {
  const TrialColumn* trial = nullptr;
  const FeatureColumn* feature = nullptr;
};

template <class Columns>
auto* find_by_name(const Columns& columns, std::string_view name) {
  const auto found = std::find_if(
      columns.begin(), columns.end(), [&](const auto& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

/// Empty if the cell is good, else what was expected.
std::string_view read_cell(const Target& target, const std::string& cell, FeatureRow& row) {
  if (target.trial != nullptr) {
    return target.trial->read(row.trial, cell) ? std::string_view() : target.trial->expectation;
  }
  if (target.feature != nullptr) {
    std::optional<double> value;
    if (!read_number(cell, value)) {
      return "a number or an empty cell";
    }
    target.feature->set(row.features, value);
    return {};
  }
  row.trial.extra.push_back(cell);
  return {};
}

}  // namespace

std::string to_csv(const FeatureTable& table, std::string_view comment) {
  require_distinct_columns(table);
  std::string out;
  if (!comment.empty()) {
    out += "# ";
    out += comment;
    out += '\n';
  }
  append_header(out, table);
  for (const FeatureRow& row : table.rows) {
    append_row(out, row);
  }
  return out;
}

FeatureTableResult to_feature_table(const TextTable& table, std::string_view file) {
  DiagnosticGroups problems;
  FeatureTable result;
  std::vector<Target> targets;
  for (const std::string& name : table.columns) {
    targets.push_back({find_by_name(trial_columns(), name), find_by_name(feature_columns(), name)});
    if (targets.back().trial == nullptr && targets.back().feature == nullptr) {
      result.extra_columns.push_back(name);
    }
  }
  if (!table.find("success")) {
    problems.add({Severity::error, std::string(file), 0, "success", "", "a column of that name"});
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    FeatureRow row;
    row.trial.trial_id = std::to_string(i + 1);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const std::string& cell = table.at(i, k);
      if (const std::string_view expected = read_cell(targets[k], cell, row); !expected.empty()) {
        problems.add({Severity::error,
                      std::string(file),
                      table.lines[i],
                      table.columns[k],
                      shortened(cell),
                      std::string(expected)});
      }
    }
    result.rows.push_back(std::move(row));
  }
  const bool bad = problems.has_error();
  return {bad ? std::nullopt : std::optional(std::move(result)), problems.take()};
}

}  // namespace tcert
