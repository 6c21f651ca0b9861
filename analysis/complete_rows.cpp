#include "analysis/complete_rows.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tcert {

CompleteRows complete_rows(std::initializer_list<std::span<const double>> scores,
                           std::span<const double> success) {
  CompleteRows rows;
  rows.scores.resize(scores.size());
  for (const auto& score : scores) {
    if (score.size() != success.size()) {
      throw std::invalid_argument("AUC: a predictor has " + std::to_string(score.size()) +
                                  " values, the outcome " + std::to_string(success.size()));
    }
  }
  for (std::size_t row = 0; row < success.size(); ++row) {
    const double y = success[row];
    if (!std::isnan(y) && y != 0.0 && y != 1.0) {
      throw std::invalid_argument("AUC: the outcome of row " + std::to_string(row + 1) +
                                  " is neither 0 nor 1");
    }
    if (std::isnan(y) || std::any_of(scores.begin(), scores.end(), [&](const auto& score) {
          return std::isnan(score[row]);
        })) {
      ++rows.missing;
      continue;
    }
    auto column = rows.scores.begin();
    for (const auto& score : scores) {
      (column++)->push_back(score[row]);
    }
    rows.success.push_back(y == 1.0 ? 1 : 0);
    ++(y == 1.0 ? rows.successes : rows.failures);
  }
  return rows;
}

}  // namespace tcert
