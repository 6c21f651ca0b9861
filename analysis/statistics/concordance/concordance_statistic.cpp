#include <statistics/concordance/concordance_statistic.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <statistics/concordance/concordance_replicates.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

struct ConcordanceProblem {
  std::vector<ConcordanceReplicates> predictors;
  ConcordanceDifferences differences;
};

StatisticKernel make_kernel(const std::shared_ptr<const ConcordanceProblem>& problem) {
  return [problem,
          scratch = ConcordanceReplicates::Scratch{},
          twice = std::vector<std::uint64_t>(problem->predictors.size())](
             std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
    // Which pairs can be compared does not depend on the predictor.
    std::uint64_t pairs = 0;
    for (std::size_t k = 0; k < twice.size(); ++k) {
      const auto counts = problem->predictors[k].counts(multiplicity, scratch);
      pairs = counts.concordant + counts.discordant + counts.tied_x;
      twice[k] = 2 * counts.concordant + counts.tied_x;
    }
    const auto over_pairs = [&](double twice_wins) {
      return pairs == 0 ? std::numeric_limits<double>::quiet_NaN()
                        : twice_wins / (2.0 * static_cast<double>(pairs));
    };
    for (std::size_t k = 0; k < twice.size(); ++k) {
      values[k] = over_pairs(static_cast<double>(twice[k]));
    }
    for (std::size_t k = 0; k < problem->differences.size(); ++k) {
      const auto first = static_cast<std::int64_t>(twice[problem->differences[k].first]);
      const auto second = static_cast<std::int64_t>(twice[problem->differences[k].second]);
      values[twice.size() + k] = over_pairs(static_cast<double>(first - second));
    }
  };
}

}  // namespace

Statistic concordance_statistic(const SurvivalOutcome& outcome,
                                std::span<const Predictor> predictors,
                                const ConcordanceDifferences& differences,
                                const table::Factor* strata) {
  if (predictors.empty()) {
    throw std::invalid_argument("C statistic: no predictor");
  }
  for (const auto& [first, second] : differences) {
    if (first >= predictors.size() || second >= predictors.size()) {
      throw std::invalid_argument("C statistic: a difference of a predictor that is not there");
    }
  }
  auto problem = std::make_shared<ConcordanceProblem>();
  problem->differences = differences;
  problem->predictors.reserve(predictors.size());
  for (const Predictor& predictor : predictors) {
    problem->predictors.emplace_back(outcome, predictor, strata);
  }
  const std::shared_ptr<const ConcordanceProblem> shared = problem;
  Statistic statistic;
  statistic.rows = outcome.rows();
  statistic.values = predictors.size() + differences.size();
  statistic.make_kernel = [shared] { return make_kernel(shared); };
  return statistic;
}

}  // namespace tcert::statistics
