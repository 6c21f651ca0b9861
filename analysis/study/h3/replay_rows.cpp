#include "analysis/study/h3/replay_rows.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/study/trials/table_columns.hpp"

namespace tcert::study {

std::vector<std::string> columns_of(const H3Options& options) {
  std::vector<std::string> columns{"trial_id",
                                   "algorithm",
                                   "lighting",
                                   "success",
                                   "speed_law",
                                   "beta_per_m",
                                   "length_m",
                                   "logged_time_s",
                                   "gated_time_s",
                                   "speed_cmd_mps",
                                   "gated_speed_cmd_mps",
                                   "loop_latency_ms",
                                   "stalls",
                                   "kept",
                                   "synthetic_seed"};
  if (!options.cluster.empty()) {
    columns.push_back(options.cluster);
  }
  return columns;
}

ReplayRows rows_of(const table::DataTable& table, const H3Options& options) {
  ReplayRows rows;
  rows.trial = words_in(table, "trial_id");
  rows.algorithm = words_in(table, "algorithm");
  rows.lighting = words_in(table, "lighting");
  rows.law = words_in(table, "speed_law");
  rows.cluster = words_in(table, options.cluster.empty() ? "trial_id" : options.cluster);
  rows.success = numbers_in(table, "success");
  rows.beta = numbers_in(table, "beta_per_m");
  rows.length = numbers_in(table, "length_m");
  rows.time = numbers_in(table, "logged_time_s");
  rows.gated_time = numbers_in(table, "gated_time_s");
  rows.speed = numbers_in(table, "speed_cmd_mps");
  rows.gated_speed = numbers_in(table, "gated_speed_cmd_mps");
  rows.latency = numbers_in(table, "loop_latency_ms");
  rows.stalls = numbers_in(table, "stalls");
  rows.kept = numbers_in(table, "kept");
  return rows;
}

Grouped grouped(const ReplayRows& rows, const H3Options& options) {
  Grouped out;
  std::map<std::string, std::pair<std::string, H3Trial>> by_id;
  std::set<std::string> unknown;
  for (std::size_t i = 0; i < rows.trial.size(); ++i) {
    const bool baseline = rows.algorithm[i] == options.baseline;
    if (!baseline && rows.algorithm[i] != options.gated) {
      continue;
    }
    if (std::isnan(rows.success[i])) {
      unknown.insert(rows.trial[i]);
      continue;
    }
    auto& [lighting, trial] = by_id[rows.trial[i]];
    lighting = rows.lighting[i];
    trial.baseline = baseline;
    trial.success = rows.success[i] == 1.0;
    const CaseKey key{rows.law[i], rows.beta[i]};
    out.cases.insert(key);
    if (!trial.row.emplace(key, i).second) {
      throw std::invalid_argument("h3: trial '" + rows.trial[i] + "' has two rows of " + key.first);
    }
  }
  for (auto& [id, entry] : by_id) {
    if (entry.second.row.size() != out.cases.size()) {
      throw std::invalid_argument("h3: trial '" + id + "' lacks a row of some law and beta");
    }
    out.by_lighting[entry.first].push_back(std::move(entry.second));
  }
  out.unknown = unknown.size();
  return out;
}

}  // namespace tcert::study
