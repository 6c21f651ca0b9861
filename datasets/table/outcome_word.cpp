#include <table/outcome_word.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <table/cell_reading.hpp>
#include <table/nearest_name.hpp>
#include <table/trimmed.hpp>

namespace tcert::table {
namespace {

/// Case-folded; truth values and numbers are read_cell()'s.
constexpr std::array<std::string_view, 12> kSuccess = {"true",
                                                       "t",
                                                       "yes",
                                                       "y",
                                                       "success",
                                                       "successful",
                                                       "succeeded",
                                                       "s",
                                                       "ok",
                                                       "okay",
                                                       "pass",
                                                       "passed"};
constexpr std::array<std::string_view, 9> kFailure = {
    "false", "f", "no", "n", "failure", "failed", "fail", "nok", "not ok"};

}  // namespace

OutcomeWord outcome_of_cell(std::string_view cell, char decimal_point) {
  const CellReading reading = read_cell(cell, decimal_point);
  if (reading.meaning == CellMeaning::missing) {
    return OutcomeWord::missing;
  }
  if (reading.value == 0.0 || reading.value == 1.0) {
    return reading.value == 1.0 ? OutcomeWord::success : OutcomeWord::failure;
  }
  const std::string word = case_folded(trimmed(cell));
  if (std::ranges::find(kSuccess, word) != kSuccess.end()) {
    return OutcomeWord::success;
  }
  return std::ranges::find(kFailure, word) != kFailure.end() ? OutcomeWord::failure
                                                             : OutcomeWord::unknown;
}

}  // namespace tcert::table
