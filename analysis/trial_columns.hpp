#pragma once
/// \file
/// The columns of trials.csv as they stand in a feature table. Internal to feature_table*.cpp.

#include <array>
#include <string>
#include <string_view>

#include "datasets/bundle.hpp"

namespace tcert {

/// A column of a trial: its cell as text, and reading it back. `read` is false for a bad cell, and
/// `expectation` then completes "expected ...".
struct TrialColumn {
  std::string_view name;
  std::string_view expectation;
  void (*append)(std::string& out, const TrialRow& trial);
  bool (*read)(TrialRow& trial, std::string_view cell);
};

[[nodiscard]] const std::array<TrialColumn, 9>& trial_columns() noexcept;

/// True for an empty cell and for R's NA.
[[nodiscard]] inline bool is_missing(std::string_view cell) noexcept {
  return cell.empty() || cell == "NA";
}

/// A finite number that fills the cell; true for a missing one too, which leaves `value` empty.
[[nodiscard]] bool read_number(std::string_view cell, std::optional<double>& value) noexcept;

}  // namespace tcert
