#include <statistics/roc/auc_statistic.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <statistics/basics/rank_order.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

constexpr std::size_t kMostRows = std::size_t{1} << 30U;

/// Rows from weakest to strongest, each as row * 4 + success * 2 + (last of its tie).
using RankedRows = std::vector<std::uint32_t>;

struct AucProblem {
  std::size_t rows = 0;
  std::vector<RankedRows> scores;
  AucDifferences differences;
};

RankedRows ranked_rows(const Score& score, std::span<const std::uint8_t> success) {
  RankedRows ranked = rank_order(score.values, score.higher);
  for (std::size_t k = 0; k < ranked.size(); ++k) {
    // Its successor is not encoded yet.
    const std::uint32_t row = ranked[k];
    const bool last = k + 1 == ranked.size() || score.values[row] != score.values[ranked[k + 1]];
    ranked[k] = row << 2U | (success[row] != 0 ? 2U : 0U) | (last ? 1U : 0U);
  }
  return ranked;
}

/// Twice the pairs won by successes, and the rows of both classes.
struct PairCount {
  std::uint64_t twice_wins = 0;
  std::uint64_t successes = 0;
  std::uint64_t failures = 0;
};

PairCount count_pairs(const RankedRows& ranked, std::span<const std::uint32_t> multiplicity) {
  PairCount count;
  std::uint64_t tied_successes = 0;
  std::uint64_t tied = 0;
  for (const std::uint32_t code : ranked) {
    const std::uint64_t times = multiplicity[code >> 2U];
    tied += times;
    tied_successes += (code & 2U) != 0 ? times : 0U;
    if ((code & 1U) != 0) {
      const std::uint64_t tied_failures = tied - tied_successes;
      count.twice_wins += tied_successes * (2 * count.failures + tied_failures);
      count.successes += tied_successes;
      count.failures += tied_failures;
      tied = tied_successes = 0;
    }
  }
  return count;
}

/// Twice the wins of every score over twice the pairs, then the differences.
void write_values(std::span<const std::uint64_t> twice_wins,
                  const AucDifferences& differences,
                  std::uint64_t pairs,
                  std::span<double> values) {
  const double twice_pairs = 2.0 * static_cast<double>(pairs);
  const auto over_pairs = [&](double twice) {
    return pairs == 0 ? std::numeric_limits<double>::quiet_NaN() : twice / twice_pairs;
  };
  for (std::size_t k = 0; k < twice_wins.size(); ++k) {
    values[k] = over_pairs(static_cast<double>(twice_wins[k]));
  }
  for (std::size_t k = 0; k < differences.size(); ++k) {
    const auto first = static_cast<std::int64_t>(twice_wins[differences[k].first]);
    const auto second = static_cast<std::int64_t>(twice_wins[differences[k].second]);
    values[twice_wins.size() + k] = over_pairs(static_cast<double>(first - second));
  }
}

StatisticKernel make_kernel(const std::shared_ptr<const AucProblem>& problem) {
  return [problem, wins = std::vector<std::uint64_t>(problem->scores.size())](
             std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
    PairCount count;
    for (std::size_t k = 0; k < wins.size(); ++k) {
      count = count_pairs(problem->scores[k], multiplicity);
      wins[k] = count.twice_wins;
    }
    write_values(wins, problem->differences, count.successes * count.failures, values);
  };
}

/// One unit's rows of each class.
struct UnitCount {
  std::uint64_t successes = 0;
  std::uint64_t failures = 0;
};

/// Twice the wins that go with each unit: those of its successes over any failure and of any
/// success over its failures, the pairs within it once.
std::vector<std::uint64_t> twice_wins_of_units(const RankedRows& ranked,
                                               const ResamplingPlan& plan,
                                               std::uint64_t successes) {
  std::vector<std::uint64_t> result(plan.units(), 0);
  std::vector<UnitCount> below(plan.units());
  std::vector<UnitCount> in_tie(plan.units());  // Of the present tie, the rows seen so far.
  UnitCount all_below;
  for (std::size_t first = 0; first < ranked.size();) {
    std::size_t last = first;
    UnitCount tied;
    do {
      ++((ranked[last] & 2U) != 0 ? tied.successes : tied.failures);
    } while ((ranked[last++] & 1U) == 0);
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t unit = plan.unit_of(ranked[k] >> 2U);
      UnitCount& seen = in_tie[unit];
      // A pair within the unit is seen from its success if the failure is lower; if they are tied,
      // from the row that comes first.
      if ((ranked[k] & 2U) != 0) {
        result[unit] += 2 * (all_below.failures - below[unit].failures) + tied.failures;
        result[unit] -= seen.failures;
        ++seen.successes;
      } else {
        result[unit] += 2 * (successes - all_below.successes) - tied.successes;
        result[unit] -= seen.successes;
        ++seen.failures;
      }
    }
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t unit = plan.unit_of(ranked[k] >> 2U);
      below[unit].successes += in_tie[unit].successes;
      below[unit].failures += in_tie[unit].failures;
      in_tie[unit] = UnitCount{};
    }
    all_below.successes += tied.successes;
    all_below.failures += tied.failures;
    first = last;
  }
  return result;
}

void leave_out(const AucProblem& problem,
               const ResamplingPlan& plan,
               std::span<std::vector<double>> out) {
  const std::size_t scores = problem.scores.size();
  std::vector<UnitCount> unit_rows(plan.units());
  for (const std::uint32_t code : problem.scores.front()) {
    UnitCount& count = unit_rows[plan.unit_of(code >> 2U)];
    ++((code & 2U) != 0 ? count.successes : count.failures);
  }
  const std::vector<std::uint32_t> once(problem.rows, 1);
  std::vector<PairCount> all;
  std::vector<std::vector<std::uint64_t>> gone;
  for (const RankedRows& ranked : problem.scores) {
    all.push_back(count_pairs(ranked, once));
    gone.push_back(twice_wins_of_units(ranked, plan, all.back().successes));
  }
  std::vector<std::uint64_t> wins(scores);
  std::vector<double> values(scores + problem.differences.size());
  for (std::size_t unit = 0; unit < plan.units(); ++unit) {
    for (std::size_t k = 0; k < scores; ++k) {
      wins[k] = all[k].twice_wins - gone[k][unit];
    }
    const std::uint64_t pairs = (all.front().successes - unit_rows[unit].successes) *
                                (all.front().failures - unit_rows[unit].failures);
    write_values(wins, problem.differences, pairs, values);
    for (std::size_t value = 0; value < values.size(); ++value) {
      out[value][unit] = values[value];
    }
  }
}

void check(std::span<const Score> scores,
           std::span<const std::uint8_t> success,
           const AucDifferences& differences) {
  if (scores.empty() || success.size() >= kMostRows) {
    throw std::invalid_argument("AUC statistic: no predictor, or too many rows");
  }
  for (const Score& score : scores) {
    if (score.values.size() != success.size() ||
        std::any_of(
            score.values.begin(), score.values.end(), [](double x) { return std::isnan(x); })) {
      throw std::invalid_argument("AUC statistic: a predictor is not complete");
    }
  }
  for (const auto& [first, second] : differences) {
    if (first >= scores.size() || second >= scores.size()) {
      throw std::invalid_argument("AUC statistic: a difference of a predictor that is not there");
    }
  }
}

}  // namespace

Statistic auc_statistic(std::span<const Score> scores,
                        std::span<const std::uint8_t> success,
                        const AucDifferences& differences) {
  check(scores, success, differences);
  auto problem = std::make_shared<AucProblem>();
  problem->rows = success.size();
  problem->differences = differences;
  for (const Score& score : scores) {
    problem->scores.push_back(ranked_rows(score, success));
  }
  const std::shared_ptr<const AucProblem> shared = problem;
  Statistic statistic;
  statistic.rows = success.size();
  statistic.values = scores.size() + differences.size();
  statistic.make_kernel = [shared] { return make_kernel(shared); };
  statistic.leave_one_out = [shared](const ResamplingPlan& plan,
                                     std::span<std::vector<double>> out) {
    leave_out(*shared, plan, out);
  };
  return statistic;
}

}  // namespace tcert::statistics
