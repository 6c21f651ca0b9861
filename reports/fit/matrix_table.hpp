#pragma once
/// \file
/// Square matrices with names as tables.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "reports/columns_of.hpp"

namespace tcert {

/// `name`, or with as many dots before it as keep it apart from `taken`: a predictor may be called
/// `term` or `row`, and no column may replace another in JSON.
[[nodiscard]] std::string apart_from(std::string name, const std::vector<std::string>& taken);

/// What the coefficients of a fit are called.
template <class Coefficients>
[[nodiscard]] std::vector<std::string> names_of(const Coefficients& coefficients) {
  std::vector<std::string> names;
  names.reserve(coefficients.size());
  for (const auto& one : coefficients) {
    names.push_back(one.column);
  }
  return names;
}

/// One column a name, with the entries of the row of `values` (its columns as many as the names);
/// NaN is missing. Both are to outlive the columns.
void add_matrix_columns(const std::vector<std::string>& names,
                        const Eigen::MatrixXd& values,
                        ColumnsOf<Eigen::Index>& columns);

/// A square matrix with its names: column `term` (`.term` if a name is `term`), then one column a
/// name.
[[nodiscard]] Table matrix_table(std::string name,
                                 std::string title,
                                 const std::vector<std::string>& names,
                                 const Eigen::MatrixXd& values);

}  // namespace tcert
