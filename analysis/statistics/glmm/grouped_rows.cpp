#include <statistics/glmm/grouped_rows.hpp>

#include <cstddef>

namespace tcert::statistics {

GroupedRows grouped_rows(const Eigen::MatrixXd& basis,
                         const BinomialRows& rows,
                         const std::vector<std::uint32_t>& codes,
                         std::size_t groups) {
  GroupedRows grouped;
  const Eigen::Index size = basis.rows();
  grouped.start.assign(groups + 1, 0);
  for (const std::uint32_t code : codes) {
    ++grouped.start[code + 1];
  }
  for (std::size_t g = 0; g < groups; ++g) {
    grouped.start[g + 1] += grouped.start[g];
  }
  grouped.basis.resize(size, basis.cols());
  grouped.successes.resize(size);
  grouped.trials.resize(size);
  grouped.offset.resize(rows.offset.size());
  std::vector<Eigen::Index> next(grouped.start.begin(), grouped.start.end() - 1);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index to = next[codes[static_cast<std::size_t>(i)]]++;
    grouped.basis.row(to) = basis.row(i);
    grouped.successes[to] = rows.successes[i];
    grouped.trials[to] = rows.trials[i];
    if (rows.offset.size() > 0) {
      grouped.offset[to] = rows.offset[i];
    }
  }
  grouped.unit_trials = (grouped.trials.array() == 1.0).all();
  return grouped;
}

}  // namespace tcert::statistics
