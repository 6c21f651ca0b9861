#include <algorithm>
#include <cmath>
#include <cstddef>
#include <statistics/basics/linalg.hpp>
#include <statistics/cox/cox_columns.hpp>

namespace tcert::statistics {
namespace {

/// Cholesky pivots of `information` in the given order; a column whose pivot is at most
/// tolerance x reference is skipped. Returns the columns that stay.
std::vector<Eigen::Index> independent_columns(Eigen::MatrixXd information,
                                              const std::vector<Eigen::Index>& order,
                                              const Eigen::VectorXd& reference,
                                              double tolerance) {
  std::vector<Eigen::Index> kept;
  for (const Eigen::Index j : order) {
    const double pivot = information(j, j);
    if (!(pivot > tolerance * reference(j))) {
      continue;
    }
    kept.push_back(j);
    const Eigen::VectorXd column = information.col(j);
    information.noalias() -= column * column.transpose() / pivot;
  }
  return kept;
}

}  // namespace

std::vector<ColumnState> column_states(const CoxRows& rows,
                                       const CoxDerivatives& null,
                                       double tolerance) {
  const auto p = static_cast<Eigen::Index>(rows.columns);
  double events = 0.0;
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    for (std::size_t place = rows.sets.events_begin[t]; place < rows.sets.begin[t + 1]; ++place) {
      events += rows.weight_of(place);
    }
  }
  std::vector<ColumnState> states(rows.columns, ColumnState::collinear);
  std::vector<Eigen::Index> varying;
  for (Eigen::Index j = 0; j < p; ++j) {
    // A scaled column has a variance of 1 or more, so about that much information per event.
    if (null.information(j, j) > tolerance * events) {
      varying.push_back(j);
    } else {
      states[static_cast<std::size_t>(j)] = ColumnState::constant;
    }
  }
  for (const Eigen::Index j :
       independent_columns(null.information, varying, null.information.diagonal(), tolerance)) {
    states[static_cast<std::size_t>(j)] = ColumnState::estimated;
  }
  return states;
}

std::vector<Eigen::Index> ranked_columns(const std::vector<ColumnState>& columns) {
  std::vector<Eigen::Index> ranked;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j] == ColumnState::estimated || columns[j] == ColumnState::infinite) {
      ranked.push_back(static_cast<Eigen::Index>(j));
    }
  }
  return ranked;
}

Eigen::MatrixXd limit_inverse(const CoxMaximum& maximum) {
  const Eigen::Index p = maximum.beta.size();
  std::vector<Eigen::Index> kept = ranked_columns(maximum.columns);
  if (maximum.summary.termination == CoxTermination::monotone) {
    // Finite columns first, so that it is the infinite ones whose pivots vanish.
    std::stable_partition(kept.begin(), kept.end(), [&](Eigen::Index j) {
      return maximum.columns[static_cast<std::size_t>(j)] != ColumnState::infinite;
    });
    kept = independent_columns(
        maximum.fitted.information, kept, maximum.null.information.diagonal(), kLimitTolerance);
  }
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(p, p);
  if (!kept.empty()) {
    const Eigen::MatrixXd information = maximum.fitted.information(kept, kept);
    const Eigen::MatrixXd solution = inverse_symmetric(information);
    inverse(kept, kept) = solution;
  }
  return inverse;
}

Eigen::MatrixXd with_missing(Eigen::MatrixXd variance, const CoxMaximum& maximum) {
  for (Eigen::Index j = 0; j < variance.cols(); ++j) {
    if (maximum.columns[static_cast<std::size_t>(j)] != ColumnState::estimated) {
      variance.row(j).setConstant(std::nan(""));
      variance.col(j).setConstant(std::nan(""));
    }
  }
  return variance;
}

}  // namespace tcert::statistics
