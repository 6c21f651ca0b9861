// Kaplan-Meier curves of three groups, the log-rank test between them and their cumulative
// incidences, by rows.

#include <benchmark/benchmark.h>

#include <cmath>
#include <statistics/survival/cumulative_incidence.hpp>
#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <table/random.hpp>
#include <vector>

namespace {

using namespace tcert;
using namespace tcert::statistics;
using namespace tcert::table;

struct Rows {
  SurvivalOutcome outcome;
  std::vector<std::uint32_t> cause;
  Factor groups{{}, {"a", "b", "c"}};
};

Rows make_rows(std::size_t n) {
  RandomStream random(1, 2, n);
  Rows rows;
  for (std::size_t row = 0; row < n; ++row) {
    rows.outcome.stop.push_back(-30.0 * std::log(random.uniform()));
    rows.cause.push_back(random.below(5) == 0 ? 0 : 1 + random.below(2));
    rows.outcome.event.push_back(rows.cause.back() > 0 ? 1 : 0);
    rows.groups.codes.push_back(random.below(3));
  }
  return rows;
}

void kaplan_meier(benchmark::State& state) {
  const Rows rows = make_rows(static_cast<std::size_t>(state.range(0)));
  CurveOptions options;
  options.groups = &rows.groups;
  for (auto _ : state) {
    benchmark::DoNotOptimize(survival_curves(rows.outcome, options));
  }
}

void log_rank(benchmark::State& state) {
  const Rows rows = make_rows(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(log_rank_test(rows.outcome, rows.groups).chi_squared);
  }
}

void aalen_johansen(benchmark::State& state) {
  const Rows rows = make_rows(static_cast<std::size_t>(state.range(0)));
  IncidenceOptions options;
  options.groups = &rows.groups;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        cumulative_incidence({{}, rows.outcome.stop, rows.cause, {"egress", "failure"}}, options));
  }
}

BENCHMARK(kaplan_meier)
    ->RangeMultiplier(10)
    ->Range(1'000, 10'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(log_rank)->RangeMultiplier(10)->Range(1'000, 10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(aalen_johansen)
    ->RangeMultiplier(10)
    ->Range(1'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
