#pragma once
/// \file
/// The rows of a fit as they would be at each level of one factor.

#include <Eigen/Core>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// More levels than this are not compared pair by pair.
inline constexpr std::size_t kMostComparedLevels = 50;

struct LevelMeans {
  std::vector<std::string> levels;  ///< Those that rows of the fit have, in the factor's order.
  Eigen::MatrixXd design;  ///< levels x columns of the frame: the mean over all rows of the fit,
                           ///< were they of that level and else as they are.
};

/// `fitted` is the frame of `formula` on `table`. Where the factor is in no product this is what
/// `emmeans` takes for its reference grid but for what cancels between levels; in products the
/// other variables stand as the rows have them (`weights = "proportional"` of balanced factors).
/// \throws FormulaError if there is no such column, the model does not depend on it, or it has
/// fewer than 2 levels or more than kMostComparedLevels. O(levels rows columns).
[[nodiscard]] LevelMeans level_means(const Formula& formula,
                                     const table::DataTable& table,
                                     const ModelFrame& fitted,
                                     const FrameOptions& options,
                                     const std::string& column);

}  // namespace tcert::statistics
