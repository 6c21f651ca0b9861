// Growth of the Cox fit with the number of rows: ties as a 0.1 s clock makes them and none at all,
// without and with clusters of 30 rows.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_residuals.hpp>
#include <statistics/cox/cox_zph.hpp>

namespace tcert::statistics {
namespace {

constexpr Eigen::Index kColumns = 6;

/// Exponential times with a censoring limit; `grid` 0 leaves them untied.
CoxData made_rows(std::int64_t rows, double grid, bool clustered, bool truncated) {
  std::mt19937_64 engine(20);
  const auto unit = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const auto n = static_cast<std::size_t>(rows);
  CoxData data;
  data.design.resize(rows, kColumns);
  data.outcome.stop.resize(n);
  data.outcome.event.resize(n);
  if (truncated) {
    data.outcome.start.resize(n);
  }
  for (Eigen::Index j = 0; j < kColumns; ++j) {
    data.columns.push_back("x" + std::to_string(j));
    data.terms.push_back(data.columns.back());
    data.term_of.push_back(static_cast<std::size_t>(j));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index j = 0; j < kColumns; ++j) {
      data.design(row, j) = j < 2 ? std::floor(2.0 * unit()) : 2.0 * unit() - 1.0;
    }
    const double risk = std::exp(0.5 * data.design(row, 0) - 0.7 * data.design(row, 3));
    double time = -25.0 * std::log(1.0 - unit()) / risk;
    const double limit = 60.0;
    data.outcome.event[i] = time < limit ? 1 : 0;
    time = std::min(time, limit);
    time = grid > 0.0 ? grid * std::max(1.0, std::ceil(time / grid)) : time;
    data.outcome.stop[i] = time;
    if (truncated) {
      data.outcome.start[i] = 0.5 * time * unit();
    }
  }
  if (clustered) {
    data.cluster.emplace();
    for (std::size_t i = 0; i < n; ++i) {
      data.cluster->codes.push_back(static_cast<std::uint32_t>(i / 30));
    }
    data.cluster->levels.resize(n / 30 + 1);
  }
  return data;
}

void fit(benchmark::State& state, Ties ties, double grid, bool clustered, bool truncated = false) {
  const CoxData data = made_rows(state.range(0), grid, clustered, truncated);
  CoxOptions options;
  options.ties = ties;
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_cox(data, options));
  }
  state.SetItemsProcessed(state.range(0) * state.iterations());
  state.SetComplexityN(state.range(0));
}

void BM_CoxEfron(benchmark::State& state) { fit(state, Ties::efron, 0.1, false); }
void BM_CoxBreslow(benchmark::State& state) { fit(state, Ties::breslow, 0.1, false); }
void BM_CoxEfronUntied(benchmark::State& state) { fit(state, Ties::efron, 0.0, false); }
void BM_CoxEfronTruncated(benchmark::State& state) { fit(state, Ties::efron, 0.1, false, true); }
void BM_CoxEfronCluster(benchmark::State& state) { fit(state, Ties::efron, 0.1, true); }
void BM_CoxBreslowCluster(benchmark::State& state) { fit(state, Ties::breslow, 0.1, true); }
void BM_CoxExact(benchmark::State& state) { fit(state, Ties::exact, 0.1, false); }

void BM_CoxZph(benchmark::State& state) {
  const CoxData data = made_rows(state.range(0), 0.1, false, false);
  const CoxFit model = fit_cox(data);
  for (auto _ : state) {
    benchmark::DoNotOptimize(cox_zph(data, model));
  }
  state.SetComplexityN(state.range(0));
}

BENCHMARK(BM_CoxEfron)
    ->RangeMultiplier(10)
    ->Range(1000, 10'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxBreslow)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxEfronUntied)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxEfronTruncated)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxEfronCluster)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxBreslowCluster)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(BM_CoxExact)->RangeMultiplier(10)->Range(1000, 10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CoxZph)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace tcert::statistics
