#pragma once
// Models of the golden files as inputs.

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <statistics/glmm/glmm.hpp>
#include <statistics/model/variable.hpp>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {

/// Columns of numbers become text, levels by value, as R's factor() makes them.
inline void make_factors(table::DataTable& table, const std::vector<std::string>& names) {
  for (table::DataColumn& column : table.columns) {
    if (!column.is_text && std::find(names.begin(), names.end(), column.name) != names.end()) {
      column.text = evaluate_factor({Expression::Kind::column, 0.0, column.name, {}}, table);
      column.is_text = true;
    }
  }
}

/// The model of one golden case: its data, formula, weights and factors.
inline GlmmInput golden_input(const std::filesystem::path& data, const nlohmann::json& golden) {
  table::DataTable table = test_support::table_of_file(data / golden["data"].get<std::string>());
  make_factors(table, golden["as_factor"].get<std::vector<std::string>>());
  FrameOptions options;
  if (golden.contains("weights") && golden["weights"].is_string()) {
    options.weights = golden["weights"].get<std::string>();
  }
  return glmm_input(
      model_frame(parse_formula(golden["formula"].get<std::string>()), table, options));
}

}  // namespace tcert::statistics
