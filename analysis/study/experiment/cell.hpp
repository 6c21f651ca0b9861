#pragma once
/// \file
/// A cell of an experiment: a name and the parameters that it overrides. An ablation, a sweep and a
/// sensitivity run are lists of cells over the same way from log to result.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tcert/robot.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/study/trials/parameters.hpp"

namespace tcert::study {

struct Cell {
  std::string name;                                            ///< Unique within a run.
  std::vector<std::pair<std::string, std::string>> overrides;  ///< Key and value, in order.
};

/// "curvature=none unknown=free"; "(none)" without overrides.
[[nodiscard]] std::string overrides_text(const Cell& cell);

/// One parameter with the values that it takes.
struct GridAxis {
  std::string key;
  std::vector<std::string> values;
};

/// Combinations beyond this are a slip: each costs a run over all logs.
inline constexpr std::size_t kMostGridCells = 10000;

/// Every combination, the last axis fastest, each named by its overrides. O(cells).
/// \throws std::invalid_argument without an axis, for an axis without a value, for a key that
/// comes twice, or for more than kMostGridCells combinations.
[[nodiscard]] std::vector<Cell> grid_cells(std::span<const GridAxis> axes);

/// A cell with its effective parameters, or with the reason why there are none.
struct PlannedCell {
  Cell cell;
  std::variant<ParameterSet, std::string> parameters;

  [[nodiscard]] bool refused() const noexcept {
    return std::holds_alternative<std::string>(parameters);
  }
  /// \pre not refused.
  [[nodiscard]] const ParameterSet& set() const { return std::get<ParameterSet>(parameters); }
};

/// The first override, "key=value: reason", with which no cell is possible, whatever the others
/// are; empty if there is none.
[[nodiscard]] std::optional<std::string> impossible_value(std::span<const PlannedCell> cells);

/// Puts the overrides over `base`. A cell is refused if a key is unknown, a value is not accepted,
/// or the parameters make no certifier for this robot and course.
[[nodiscard]] PlannedCell plan(Cell cell,
                               const ParameterSet& base,
                               const Robot& robot,
                               const Course& course);

}  // namespace tcert::study
