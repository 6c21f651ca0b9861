#pragma once
/// \file
/// What a model frame says about its rows. Internal to model_frame.cpp.

#include <cstddef>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// A note of the rows left out, or an error if none is left.
void add_missing_conditions(ModelFrame& frame);

/// Where row `i` of the frame stands: "row 4 (line 5)", of the table and of its file.
[[nodiscard]] std::string place_of(const ModelFrame& frame, std::size_t i);

/// Errors in `frame.conditions`, with the first row (of the table, counted from 1) and how many.
void check_finite(const std::vector<double>& values, const std::string& column, ModelFrame& frame);
void check_binary(const std::vector<double>& values, const std::string& column, ModelFrame& frame);
void check_weights(const std::vector<double>& values, const std::string& column, ModelFrame& frame);

/// Times are finite and above 0, starts before their stops.
void check_times(const SurvivalOutcome& survival, const std::string& column, ModelFrame& frame);

/// Makes times equal that differ by rounding, if `round`, and says what that did, or what R would
/// do; then starts must still lie before their stops. Names times that are far from the others.
void round_and_check_times(SurvivalOutcome& survival,
                           const std::string& column,
                           bool round,
                           ModelFrame& frame);

/// Successes and failures are whole and not negative.
void check_counts(ModelFrame& frame);

}  // namespace tcert::statistics
