#pragma once
/// \file
/// Terms to columns: treatment contrasts and interactions, named as R names them.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/model/formula.hpp>
#include <statistics/model/variable.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

struct DesignMatrix {
  Eigen::MatrixXd values;            ///< rows x columns.
  std::vector<std::string> columns;  ///< "(Intercept)", "lightingdim", "x1:lightingdim".
  std::vector<std::size_t> term_of;  ///< Per column: index into the formula's terms + 1; 0: the
                                     ///< intercept.
};

/// A variable of the formula, on the rows of the model.
struct NamedVariable {
  Expression expression;
  Variable value;
};

/// A factor in a term is coded by contrasts against its first level if the term without it is in
/// the model too, else by all its levels; without an intercept the first factor has all its levels,
/// as R's `model.matrix` has it. Truth values are a factor of FALSE and TRUE. `variables` holds
/// every variable of the terms once. O(rows x columns).
[[nodiscard]] DesignMatrix design_matrix(const Formula& formula,
                                         const std::vector<NamedVariable>& variables,
                                         std::size_t rows);

}  // namespace tcert::statistics
