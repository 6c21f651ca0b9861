#include "analysis/statistics/survival/survival_golden.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <statistics/concordance/concordance.hpp>
#include <variant>

#include "support/data_table.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::statistics {

nlohmann::json golden_values(const std::string& name) {
  std::ifstream file(test_support::shared_data() / "stats" / "golden" / name);
  return file ? nlohmann::json::parse(file) : nlohmann::json();
}

ModelFrame golden_frame(const std::string& data,
                        const std::string& formula,
                        const FrameOptions& options) {
  return test_support::frame_of_file(
      test_support::shared_data() / "stats" / "data" / data, formula, options);
}

SurvivalOutcome survival_outcome(const ModelFrame& frame) {
  if (const auto* const numbers = std::get_if<NumberOutcome>(&frame.outcome)) {
    return uncensored(numbers->values);
  }
  return std::get<SurvivalOutcome>(frame.outcome);
}

std::string golden_text(const nlohmann::json& test_case, const std::string& key) {
  return test_case.contains(key) && test_case[key].is_string() ? test_case[key].get<std::string>()
                                                               : std::string();
}

double golden_number(const nlohmann::json& value) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value == "Inf") {
    return kInf;
  }
  return value == "-Inf" ? -kInf : std::numeric_limits<double>::quiet_NaN();
}

double disagreement(double actual, double expected) {
  if (!std::isfinite(expected)) {
    return (std::isnan(expected) && std::isnan(actual)) || actual == expected
               ? 0.0
               : std::numeric_limits<double>::infinity();
  }
  const double difference = std::abs(actual - expected);
  if (std::isnan(difference)) {
    return std::numeric_limits<double>::infinity();
  }
  return expected == 0.0 ? difference : difference / std::abs(expected);
}

}  // namespace tcert::statistics
