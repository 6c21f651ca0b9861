// Logistic regression of a million rows, its growth, and bootstrap replicates.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_refit.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
using table::RandomStream;
namespace {

/// Six columns with the intercept, about a third of the outcomes 0.
LogisticInput made(Eigen::Index rows) {
  LogisticInput input;
  input.design.resize(rows, 6);
  input.columns = {"(Intercept)", "a", "b", "c", "d", "e"};
  input.terms = {"a", "b", "c", "d", "e"};
  input.term_of = {0, 1, 2, 3, 4, 5};
  input.successes.resize(rows);
  RandomStream random(1, 2, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    input.design(i, 0) = 1.0;
    double eta = 0.8;
    for (Eigen::Index j = 1; j < 6; ++j) {
      input.design(i, j) = random.normal();
      eta += 0.3 * input.design(i, j);
    }
    input.successes[i] = random.uniform() < 1.0 / (1.0 + std::exp(-eta)) ? 1.0 : 0.0;
  }
  return input;
}

void fit(benchmark::State& state) {
  const LogisticInput input = made(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_logistic(input).log_likelihood);
  }
  state.SetComplexityN(state.range(0));
}

/// The second outcome is a threshold of a column: the fit must find that out.
void separated_fit(benchmark::State& state) {
  LogisticInput input = made(state.range(0));
  for (Eigen::Index i = 0; i < input.design.rows(); ++i) {
    input.successes[i] = input.design(i, 1) > 0.1 ? 1.0 : 0.0;
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_logistic(input).separation);
  }
  state.SetComplexityN(state.range(0));
}

void replicate(benchmark::State& state) {
  const LogisticInput input = made(state.range(0));
  const LogisticRefit refit(input);
  RandomStream random(4, 5, 6);
  const auto rows = static_cast<std::uint32_t>(state.range(0));
  std::vector<std::uint32_t> times(rows, 0);
  for (std::uint32_t draw = 0; draw < rows; ++draw) {
    ++times[random.below(rows)];
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(refit.fit(times).coefficients);
  }
  state.SetComplexityN(state.range(0));
}

BENCHMARK(fit)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(separated_fit)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(replicate)->Arg(660)->Arg(66000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tcert::statistics
