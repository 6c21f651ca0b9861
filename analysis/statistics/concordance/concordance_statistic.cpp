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

/// C of every predictor from its pairs, then the differences.
void write_values(std::span<const ConcordanceReplicates::Counts> counts,
                  const ConcordanceDifferences& differences,
                  std::span<double> values) {
  // Which pairs can be compared does not depend on the predictor.
  const ConcordanceReplicates::Counts& any = counts.back();
  const std::uint64_t pairs = any.concordant + any.discordant + any.tied_x;
  const auto over_pairs = [&](double twice_wins) {
    return pairs == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : twice_wins / (2.0 * static_cast<double>(pairs));
  };
  const auto twice = [&](std::size_t k) { return 2 * counts[k].concordant + counts[k].tied_x; };
  for (std::size_t k = 0; k < counts.size(); ++k) {
    values[k] = over_pairs(static_cast<double>(twice(k)));
  }
  for (std::size_t k = 0; k < differences.size(); ++k) {
    const auto first = static_cast<std::int64_t>(twice(differences[k].first));
    const auto second = static_cast<std::int64_t>(twice(differences[k].second));
    values[counts.size() + k] = over_pairs(static_cast<double>(first - second));
  }
}

StatisticKernel make_kernel(const std::shared_ptr<const ConcordanceProblem>& problem) {
  return [problem,
          scratch = ConcordanceReplicates::Scratch{},
          counts = std::vector<ConcordanceReplicates::Counts>(problem->predictors.size())](
             std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
    for (std::size_t k = 0; k < counts.size(); ++k) {
      counts[k] = problem->predictors[k].counts(multiplicity, scratch);
    }
    write_values(counts, problem->differences, values);
  };
}

void leave_out(const ConcordanceProblem& problem,
               const ResamplingPlan& plan,
               std::span<std::vector<double>> out) {
  const std::size_t predictors = problem.predictors.size();
  std::vector<std::vector<ConcordanceReplicates::Counts>> without;
  for (const ConcordanceReplicates& predictor : problem.predictors) {
    without.push_back(predictor.without_units(plan));
  }
  std::vector<ConcordanceReplicates::Counts> counts(predictors);
  std::vector<double> values(predictors + problem.differences.size());
  for (std::size_t unit = 0; unit < plan.units(); ++unit) {
    for (std::size_t k = 0; k < predictors; ++k) {
      counts[k] = without[k][unit];
    }
    write_values(counts, problem.differences, values);
    for (std::size_t value = 0; value < values.size(); ++value) {
      out[value][unit] = values[value];
    }
  }
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
  statistic.leave_one_out = [shared](const ResamplingPlan& plan,
                                     std::span<std::vector<double>> out) {
    leave_out(*shared, plan, out);
  };
  return statistic;
}

}  // namespace tcert::statistics
