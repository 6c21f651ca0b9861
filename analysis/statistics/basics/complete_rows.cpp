#include <statistics/basics/complete_rows.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <stdexcept>
#include <string>
#include <table/factor.hpp>

namespace tcert::statistics {
namespace {

void check_lengths(std::span<const std::span<const double>> scores,
                   std::size_t rows,
                   std::span<const std::uint32_t> cluster) {
  for (const auto& score : scores) {
    if (score.size() != rows) {
      throw std::invalid_argument("AUC: a predictor has " + std::to_string(score.size()) +
                                  " values, the outcome " + std::to_string(rows));
    }
  }
  if (!cluster.empty() && cluster.size() != rows) {
    throw std::invalid_argument("AUC: " + std::to_string(cluster.size()) +
                                " clusters, the outcome has " + std::to_string(rows) + " rows");
  }
}

}  // namespace

CompleteRows complete_rows(std::span<const std::span<const double>> scores,
                           std::span<const double> success,
                           std::span<const std::uint32_t> cluster) {
  check_lengths(scores, success.size(), cluster);
  CompleteRows rows;
  rows.clustered = !cluster.empty();
  rows.scores.resize(scores.size());
  for (std::size_t row = 0; row < success.size(); ++row) {
    const double y = success[row];
    if (!std::isnan(y) && y != 0.0 && y != 1.0) {
      throw std::invalid_argument("AUC: the outcome of row " + std::to_string(row + 1) +
                                  " is neither 0 nor 1");
    }
    if (std::isnan(y) || (rows.clustered && cluster[row] == table::Factor::kMissing) ||
        std::any_of(scores.begin(), scores.end(), [&](const auto& score) {
          return std::isnan(score[row]);
        })) {
      ++rows.missing;
      continue;
    }
    for (std::size_t k = 0; k < scores.size(); ++k) {
      rows.scores[k].push_back(scores[k][row]);
    }
    rows.success.push_back(y == 1.0 ? 1 : 0);
    ++(y == 1.0 ? rows.successes : rows.failures);
    if (rows.clustered) {
      rows.cluster.push_back(cluster[row]);
    }
  }
  CompactCodes compact = compact_codes(rows.cluster);
  rows.cluster = std::move(compact.codes);
  rows.clusters = compact.count;
  return rows;
}

}  // namespace tcert::statistics
