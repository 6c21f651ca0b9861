#include "analysis/cox_rows.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

/// exp() of it leaves room for sums of 10^9 products of scaled columns.
constexpr double kLargestExponent = 600.0;

void centre_and_scale(const CoxData& data, CoxRows& rows) {
  const Eigen::Index n = data.design.rows();
  const Eigen::Index p = data.design.cols();
  rows.centre = Eigen::VectorXd::Zero(p);
  rows.scale = Eigen::VectorXd::Ones(p);
  if (n == 0) {
    return;
  }
  const Eigen::VectorXd weights = data.weights.value_or(Eigen::VectorXd::Ones(n));
  const double total = weights.sum();
  for (Eigen::Index j = 0; j < p; ++j) {
    const auto column = data.design.col(j);
    // About the first value, so that the mean of a constant column is exact.
    const double origin = column(0);
    rows.centre(j) = origin + weights.dot((column.array() - origin).matrix()) / total;
    const double deviation =
        weights.dot((column.array() - rows.centre(j)).abs().matrix()) / total;
    rows.scale(j) = deviation > 0.0 ? deviation : 1.0;
  }
}

}  // namespace

CoxRows cox_rows(const CoxData& data) {
  CoxRows rows;
  rows.sets = risk_sets(data.outcome, data.strata ? &*data.strata : nullptr);
  rows.columns = static_cast<std::size_t>(data.design.cols());
  centre_and_scale(data, rows);

  const std::size_t m = rows.rows();
  rows.x.resize(m * rows.columns);
  rows.weight.assign(m, 1.0);
  rows.offset.assign(m, 0.0);
  for (std::size_t place = 0; place < m; ++place) {
    const auto row = static_cast<Eigen::Index>(rows.sets.order[place]);
    double* const x = rows.x.data() + place * rows.columns;
    for (Eigen::Index j = 0; j < data.design.cols(); ++j) {
      x[j] = (data.design(row, j) - rows.centre(j)) / rows.scale(j);
    }
    if (data.weights) {
      rows.weight[place] = (*data.weights)(row);
    }
    if (data.offset) {
      rows.offset[place] = (*data.offset)(row);
    }
  }
  return rows;
}

void risk_scores(const CoxRows& rows, const Eigen::VectorXd& beta, RiskScores& scores) {
  const std::size_t m = rows.rows();
  const std::size_t p = rows.columns;
  scores.score.resize(m);
  double largest = 0.0;
  for (std::size_t place = 0; place < m; ++place) {
    const double* const x = rows.row(place);
    double sum = rows.offset[place];
    for (std::size_t j = 0; j < p; ++j) {
      sum += x[j] * beta(static_cast<Eigen::Index>(j));
    }
    scores.score[place] = sum;
    largest = std::max(largest, sum);
  }
  scores.shift = largest > kLargestExponent ? largest - kLargestExponent : 0.0;
  for (double& score : scores.score) {
    score = std::exp(score - scores.shift);
  }
}

}  // namespace tcert
