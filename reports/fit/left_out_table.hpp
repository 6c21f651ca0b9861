#pragma once
/// \file
/// Coefficients without each cluster in turn: which of them the result hangs on.

#include <Eigen/Core>
#include <string>
#include <table/factor.hpp>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// A row a cluster of the fit and coefficient. `estimates` are of all rows (p), `left_out` without
/// each cluster (p x G, G the levels that `cluster` has rows of, in order); NaN is missing.
[[nodiscard]] Table left_out_table(const std::vector<std::string>& names,
                                   const table::Factor& cluster,
                                   const Eigen::VectorXd& estimates,
                                   const Eigen::MatrixXd& left_out);

}  // namespace tcert
