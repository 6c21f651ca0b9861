#pragma once
// Golden values of survival estimates, and the frames that they are of.

#include <nlohmann/json.hpp>
#include <statistics/model/model_frame.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>

namespace tcert::statistics {

/// The R values in `golden/<name>`, null if they are not there.
[[nodiscard]] nlohmann::json golden_values(const std::string& name);

/// A formula on a golden data set.
[[nodiscard]] ModelFrame golden_frame(const std::string& data,
                                      const std::string& formula,
                                      const FrameOptions& options = {});

/// The outcome of a frame; a plain number is an uncensored time.
[[nodiscard]] SurvivalOutcome survival_outcome(const ModelFrame& frame);

/// The text at `key`, empty if it is none.
[[nodiscard]] std::string golden_text(const nlohmann::json& test_case, const std::string& key);

/// A JSON number, or "Inf", "-Inf", "NaN", "NA".
[[nodiscard]] double golden_number(const nlohmann::json& value);

/// |actual - expected| relative to |expected|, absolute if it is 0; 0 if both are NaN.
[[nodiscard]] double disagreement(double actual, double expected);

}  // namespace tcert::statistics
