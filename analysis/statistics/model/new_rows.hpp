#pragma once
/// \file
/// Rows of another table as a fitted model sees them, for prediction.

#include <cstddef>
#include <optional>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// Columns that rows need to be predicted: all of the formula but those of its outcome alone, and
/// the strata.
[[nodiscard]] std::vector<std::string> columns_to_predict(const Formula& formula,
                                                          const FrameOptions& options);

struct NewRows {
  Eigen::MatrixXd design;                 ///< k x columns of the fitted frame.
  std::optional<Eigen::VectorXd> offset;  ///< k.
  std::optional<table::Factor> strata;    ///< k.
  std::vector<std::size_t> rows;          ///< Of the new table, those that are complete.
  std::size_t dropped = 0;
};

/// `fitted` is the frame of `formula` on `table`; levels, their reference and the means of scale()
/// are those of `table`. \throws FormulaError as `model_frame`, and for a column of other kind, or
/// a level that the fit has not seen, with its column.
[[nodiscard]] NewRows new_rows(const Formula& formula,
                               const table::DataTable& table,
                               const ModelFrame& fitted,
                               const table::DataTable& others,
                               const FrameOptions& options);

}  // namespace tcert::statistics
