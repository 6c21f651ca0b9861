// Harrell's C with its variance, and one bootstrap replicate of it, by rows; without ties and with
// a predictor of ten values and whole times.

#include <benchmark/benchmark.h>

#include <cmath>
#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/concordance_replicates.hpp>
#include <table/random.hpp>
#include <vector>

#include "support/allocations.hpp"

namespace {

using namespace tcert;
using namespace tcert::statistics;
using namespace tcert::table;

struct Rows {
  SurvivalOutcome outcome;
  std::vector<double> x;
};

Rows make_rows(std::size_t n, bool tied) {
  RandomStream random(1, 1, n);
  Rows rows;
  for (std::size_t row = 0; row < n; ++row) {
    const double x = random.normal();
    const double time = -30.0 * std::exp(0.5 * x) * std::log(random.uniform());
    rows.outcome.stop.push_back(tied ? std::ceil(time) : time);
    rows.outcome.event.push_back(random.uniform() < 0.8 ? 1 : 0);
    rows.x.push_back(tied ? std::round(2.0 * x) : x);
  }
  return rows;
}

void concordance_with_variance(benchmark::State& state) {
  const Rows rows = make_rows(static_cast<std::size_t>(state.range(0)), state.range(1) != 0);
  const std::vector<Predictor> predictors{{"x", rows.x}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(concordance(rows.outcome, predictors).estimates[0].variance);
  }
}
BENCHMARK(concordance_with_variance)
    ->ArgNames({"rows", "tied"})
    ->ArgsProduct({{1'000, 10'000, 100'000, 1'000'000, 10'000'000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

void concordance_replicate(benchmark::State& state) {
  const auto n = static_cast<std::uint32_t>(state.range(0));
  const Rows rows = make_rows(n, state.range(1) != 0);
  const ConcordanceReplicates replicates(rows.outcome, {"x", rows.x});
  std::vector<std::uint32_t> times(n, 0);
  RandomStream random(2, 1, n);
  for (std::uint32_t draw = 0; draw < n; ++draw) {
    ++times[random.below(n)];
  }
  ConcordanceReplicates::Scratch scratch;
  benchmark::DoNotOptimize(replicates.c(times, scratch));
  const std::size_t before = test_support::allocation_count();
  for (auto _ : state) {
    benchmark::DoNotOptimize(replicates.c(times, scratch));
  }
  state.counters["allocations"] = static_cast<double>(test_support::allocation_count() - before);
}
BENCHMARK(concordance_replicate)
    ->ArgNames({"rows", "tied"})
    ->ArgsProduct({{660, 10'000, 100'000, 1'000'000}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
