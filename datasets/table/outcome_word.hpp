#pragma once
/// \file
/// What a cell says about the outcome of a trial: the one list of words, for bundles, imports,
/// fits and hypotheses.

#include <cstdint>
#include <string_view>

namespace tcert::table {

enum class OutcomeWord : std::uint8_t { failure, success, missing, unknown };

/// In any case. Success: 1, true, t, yes, y, success, successful, succeeded, s, ok, okay, pass,
/// passed. Failure: 0, false, f, no, n, failure, failed, fail, nok, "not ok". Numbers by value:
/// 1.0 is 1. Missing as read_cell() has it. Everything else is unknown.
[[nodiscard]] OutcomeWord outcome_of_cell(std::string_view cell, char decimal_point = '.');

/// Completes "expected ...": the words in brief.
inline constexpr std::string_view kOutcomeWords =
    "1 or 0, true or false, success or failure, s or f, ok or fail, pass or fail, yes or no, in "
    "any case";

}  // namespace tcert::table
