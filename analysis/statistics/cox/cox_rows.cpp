#include <statistics/cox/cox_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace tcert::statistics {
namespace {

/// exp() of twice it leaves room: the information divides by squares of sums.
constexpr double kLargestExponent = 300.0;

void centre_and_scale(const CoxData& data, CoxRows& rows) {
  const Eigen::Index n = data.design.rows();
  const Eigen::Index p = data.design.cols();
  rows.centre = Eigen::VectorXd::Zero(p);
  rows.scale = Eigen::VectorXd::Ones(p);
  if (n == 0) {
    return;
  }
  const auto weighted_mean = [&](const auto& values) {
    return data.weights ? data.weights->dot(values.matrix()) / data.weights->sum() : values.mean();
  };
  for (Eigen::Index j = 0; j < p; ++j) {
    const auto column = data.design.col(j).array();
    // About the first value, so that the mean of a constant column is exact.
    const double origin = column(0);
    const double centre = origin + weighted_mean(column - origin);
    const double deviation = weighted_mean((column - centre).abs());
    rows.centre(j) = centre;
    rows.scale(j) = deviation > 0.0 ? deviation : 1.0;
  }
}

/// Reads the design column by column, a block of rows at a time, and writes rows where they belong:
/// the other way around every number of a large design would be a cache miss.
void scatter_design(const CoxData& data, const std::vector<std::uint32_t>& place, CoxRows& rows) {
  constexpr std::size_t kBlock = 512;
  for (std::size_t begin = 0; begin < place.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, place.size());
    for (std::size_t j = 0; j < rows.columns; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      const double* const from = data.design.col(column).data();
      const double centre = rows.centre(column);
      const double unit = rows.scale(column);
      for (std::size_t row = begin; row < end; ++row) {
        if (place[row] != RiskSets::kNever) {
          rows.x[place[row] * rows.columns + j] = (from[row] - centre) / unit;
        }
      }
    }
  }
}

}  // namespace

CoxRows cox_rows(const CoxData& data) {
  CoxRows rows;
  rows.sets = risk_sets(data.outcome, data.strata ? &*data.strata : nullptr);
  rows.columns = static_cast<std::size_t>(data.design.cols());
  centre_and_scale(data, rows);

  const std::size_t m = rows.rows();
  std::vector<std::uint32_t> place(data.rows(), RiskSets::kNever);
  for (std::size_t k = 0; k < m; ++k) {
    place[rows.sets.order[k]] = static_cast<std::uint32_t>(k);
  }
  rows.x.resize(m * rows.columns);
  scatter_design(data, place, rows);
  const auto gather = [&](const std::optional<Eigen::VectorXd>& from, std::vector<double>& to) {
    if (from) {
      to.resize(m);
      for (std::size_t k = 0; k < m; ++k) {
        to[k] = (*from)(static_cast<Eigen::Index>(rows.sets.order[k]));
      }
    }
  };
  gather(data.weights, rows.weight);
  gather(data.offset, rows.offset);
  if (data.offset && data.offset->size() > 0) {
    rows.offset_centre = data.offset->mean();
    for (double& offset : rows.offset) {
      offset -= rows.offset_centre;
    }
  }
  return rows;
}

void risk_scores(const CoxRows& rows, const Eigen::VectorXd& beta, RiskScores& scores) {
  const std::size_t m = rows.rows();
  const std::size_t p = rows.columns;
  if (rows.offset.empty() && beta.isZero(0.0)) {
    scores.score.assign(m, 1.0);
    scores.weighted = rows.weight;
    scores.shift = 0.0;
    return;
  }
  scores.score.resize(m);
  double largest = -std::numeric_limits<double>::infinity();
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t place = 0; place < m; ++place) {
    const double* const x = rows.row(place);
    double sum = rows.offset_of(place);
    for (std::size_t j = 0; j < p; ++j) {
      sum += x[j] * beta(static_cast<Eigen::Index>(j));
    }
    scores.score[place] = sum;
    largest = std::max(largest, sum);
    smallest = std::min(smallest, sum);
  }
  const bool fits = largest <= kLargestExponent && smallest >= -kLargestExponent;
  scores.shift = m == 0 || fits ? 0.0 : largest - kLargestExponent;
  for (double& score : scores.score) {
    score = std::exp(score - scores.shift);
  }
  scores.weighted.resize(rows.weight.size());
  for (std::size_t place = 0; place < rows.weight.size(); ++place) {
    scores.weighted[place] = rows.weight[place] * scores.score[place];
  }
}

}  // namespace tcert::statistics
