#pragma once
/// \file
/// Elements of the inverse of a sparse symmetric matrix where its Cholesky factor has elements.

#include <Eigen/SparseCore>
#include <vector>

namespace tcert::statistics {

/// `factor` is lower, by columns, rows ascending, with every fill-in (as Eigen's SimplicialLLT
/// holds it). Returns one number per element of it: the inverse of factor * factor' there
/// (Takahashi, Fagan and Chin, 1973). O(sum over columns of the elements of the columns that it
/// reaches).
[[nodiscard]] std::vector<double> selected_inverse(const Eigen::SparseMatrix<double>& factor);

}  // namespace tcert::statistics
