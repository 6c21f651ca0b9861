#include <statistics/glmm/selected_inverse.hpp>

#include <cstddef>

namespace tcert::statistics {

std::vector<double> selected_inverse(const Eigen::SparseMatrix<double>& factor) {
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  const Index* const start = factor.outerIndexPtr();
  const Index* const row = factor.innerIndexPtr();
  const double* const value = factor.valuePtr();
  const auto size = static_cast<Index>(factor.cols());
  std::vector<double> inverse(static_cast<std::size_t>(factor.nonZeros()), 0.0);
  // Of the column at work: its elements by row, 0 elsewhere, and the sums being made.
  std::vector<double> element(static_cast<std::size_t>(size), 0.0);
  std::vector<double> sum(static_cast<std::size_t>(size), 0.0);
  for (Index j = size; j-- > 0;) {
    const Index first = start[j];
    const Index last = start[j + 1];
    for (Index a = first + 1; a < last; ++a) {
      element[static_cast<std::size_t>(row[a])] = value[a];
    }
    for (Index a = first + 1; a < last; ++a) {
      const auto k = static_cast<std::size_t>(row[a]);
      sum[k] += value[a] * inverse[static_cast<std::size_t>(start[k])];
      for (Index b = start[k] + 1; b < start[k + 1]; ++b) {
        const auto i = static_cast<std::size_t>(row[b]);
        const double at = inverse[static_cast<std::size_t>(b)];
        sum[i] += value[a] * at;
        sum[k] += element[i] * at;
      }
    }
    const double pivot = value[first];
    double rest = 1.0 / pivot;
    for (Index a = first + 1; a < last; ++a) {
      const double found = -sum[static_cast<std::size_t>(row[a])] / pivot;
      inverse[static_cast<std::size_t>(a)] = found;
      rest -= value[a] * found;
    }
    inverse[static_cast<std::size_t>(first)] = rest / pivot;
    for (Index a = first + 1; a < last; ++a) {
      const auto k = static_cast<std::size_t>(row[a]);
      element[k] = 0.0;
      sum[k] = 0.0;
      // Rows beyond the column's own get sums that are not used.
      for (Index b = start[k] + 1; b < start[k + 1]; ++b) {
        sum[static_cast<std::size_t>(row[b])] = 0.0;
      }
    }
  }
  return inverse;
}

}  // namespace tcert::statistics
