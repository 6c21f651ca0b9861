#include <statistics/concordance/concordance_columns.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check(const SurvivalOutcome& outcome,
           std::span<const Predictor> predictors,
           const ConcordanceOptions& options) {
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw std::invalid_argument("concordance: level must be in (0, 1)");
  }
  const std::size_t n = outcome.rows();
  const auto wrong = [n](std::size_t size) { return size != n; };
  if (wrong(outcome.event.size()) || (outcome.left_truncated() && wrong(outcome.start.size())) ||
      (!options.weights.empty() && wrong(options.weights.size())) ||
      (options.strata != nullptr && wrong(options.strata->rows())) ||
      (options.cluster != nullptr && wrong(options.cluster->rows())) ||
      std::any_of(predictors.begin(), predictors.end(), [&](const Predictor& predictor) {
        return wrong(predictor.values.size());
      })) {
    throw std::invalid_argument("concordance: columns of different length");
  }
  if (options.cluster != nullptr) {
    const std::size_t levels = options.cluster->levels.size();
    const auto& codes = options.cluster->codes;
    if (std::any_of(codes.begin(), codes.end(), [&](auto code) { return code >= levels; })) {
      throw std::invalid_argument("concordance: a cluster is missing");
    }
  }
}

template <typename T>
std::vector<T> pick(std::span<const T> column, std::span<const std::size_t> rows) {
  std::vector<T> result;
  if (!column.empty()) {
    result.reserve(rows.size());
    for (const std::size_t row : rows) {
      result.push_back(column[row]);
    }
  }
  return result;
}

/// R's ymin: early times become one.
void raise_times(SurvivalOutcome& outcome, double earliest) {
  for (std::size_t row = 0; row < outcome.rows(); ++row) {
    if (outcome.stop[row] < earliest) {
      if (outcome.event[row] == 0) {
        throw std::invalid_argument("concordance: a row is censored before the earliest time");
      }
      outcome.stop[row] = earliest;
    }
  }
}

/// A risk set that everybody enters at the same time is that of rows without a start.
bool has_common_start(const SurvivalOutcome& outcome) {
  const auto& start = outcome.start;
  return !start.empty() &&
         std::all_of(start.begin(), start.end(), [&](double s) { return s == start[0]; }) &&
         std::all_of(
             outcome.stop.begin(), outcome.stop.end(), [&](double s) { return s > start[0]; });
}

}  // namespace

ConcordanceColumns::ConcordanceColumns(const SurvivalOutcome& outcome,
                                       std::span<const Predictor> predictors,
                                       const ConcordanceOptions& options)
    : outcome_(&outcome), weights_(options.weights) {
  check(outcome, predictors, options);
  for (const Predictor& predictor : predictors) {
    predictors_.push_back(predictor.values);
  }
  if (options.strata != nullptr) {
    strata_ = options.strata->codes;
  }
  if (options.cluster != nullptr) {
    cluster_ = options.cluster->codes;
  }
  find_complete_rows();
  if (missing_ > 0) {
    copy_complete_rows();
  }
  const bool common_start = has_common_start(*outcome_);
  if (options.earliest || common_start) {
    if (outcome_ != &own_outcome_) {
      own_outcome_ = *outcome_;
      outcome_ = &own_outcome_;
    }
    if (common_start) {
      own_outcome_.start.clear();
    }
    if (options.earliest) {
      raise_times(own_outcome_, *options.earliest);
    }
  }
}

bool ConcordanceColumns::is_complete(std::size_t row) const {
  return std::none_of(predictors_.begin(),
                      predictors_.end(),
                      [row](std::span<const double> values) { return std::isnan(values[row]); });
}

void ConcordanceColumns::find_complete_rows() {
  const std::size_t n = outcome_->rows();
  std::size_t complete = 0;
  while (complete < n && is_complete(complete)) {
    ++complete;
  }
  if (complete == n) {
    return;
  }
  rows_.resize(complete);
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  for (std::size_t row = complete + 1; row < n; ++row) {
    if (is_complete(row)) {
      rows_.push_back(row);
    }
  }
  missing_ = n - rows_.size();
}

void ConcordanceColumns::copy_complete_rows() {
  own_outcome_.start = pick(std::span<const double>(outcome_->start), rows_);
  own_outcome_.stop = pick(std::span<const double>(outcome_->stop), rows_);
  own_outcome_.event = pick(std::span<const std::uint8_t>(outcome_->event), rows_);
  outcome_ = &own_outcome_;
  for (std::span<const double>& values : predictors_) {
    own_predictors_.push_back(pick(values, rows_));
    values = own_predictors_.back();
  }
  own_weights_ = pick(weights_, rows_);
  own_strata_ = pick(strata_, rows_);
  own_cluster_ = pick(cluster_, rows_);
  weights_ = own_weights_;
  strata_ = own_strata_;
  cluster_ = own_cluster_;
}

}  // namespace tcert::statistics
