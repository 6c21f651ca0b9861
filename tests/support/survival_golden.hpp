#pragma once
// Golden cases of survival estimates: their data sets as outcomes, factors and numbers.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/survival_outcome.hpp"
#include "datasets/factor.hpp"

namespace tcert::test_support {

/// The R values in `golden/<name>`, null if they are not there.
[[nodiscard]] nlohmann::json golden_values(const std::string& name);

/// What a formula and its extra columns say, on the rows that are complete in them.
struct GoldenFrame {
  SurvivalOutcome outcome;
  std::vector<std::vector<double>> predictors;
  Factor groups;  ///< Crossing of the right-hand side as factors.
  Factor strata;
  Factor cluster;
  std::vector<double> weights;
};

struct GoldenCall {
  std::string data;
  std::string response;                 ///< "Surv(time, status == 2)" or a number column.
  std::vector<std::string> predictors;  ///< Number columns.
  std::vector<std::string> groups;      ///< Factor columns, crossed.
  std::string strata;
  std::string cluster;
  std::string weights;
};

[[nodiscard]] GoldenFrame golden_frame(const GoldenCall& call);

/// A JSON number, or "Inf", "-Inf", "NaN", "NA".
[[nodiscard]] double golden_number(const nlohmann::json& value);

/// |actual - expected| relative to |expected|, or absolute below 1e-300; 0 if both are NaN.
[[nodiscard]] double disagreement(double actual, double expected);

/// X beta of the Cox model with Efron's ties, by Newton's method; columns of the design in turn.
[[nodiscard]] std::vector<double> efron_linear_predictor(
    const SurvivalOutcome& outcome, const std::vector<std::vector<double>>& columns);

}  // namespace tcert::test_support
