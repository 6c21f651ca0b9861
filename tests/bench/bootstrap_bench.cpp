// The BCa interval of a paired difference of AUCs, on one thread: replicates, jackknife, interval.

#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>

#include <cstdint>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
using table::RandomStream;
namespace {

struct Data {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> day;

  explicit Data(std::size_t rows) {
    RandomStream random(1, 0, 0);
    for (std::size_t row = 0; row < rows; ++row) {
      success.push_back(random.below(660) < 77 ? 0 : 1);
      day.push_back(static_cast<std::uint32_t>(row / 30));
      first.push_back(random.normal() + 0.9 * success.back());
      second.push_back(random.normal() + 0.5 * success.back());
    }
  }

  [[nodiscard]] std::vector<Score> scores() const {
    return {{first, HigherMeans::success}, {second, HigherMeans::success}};
  }
};

/// Sorting, 10,000 replicates, jackknife and interval; rows, then days, resampled.
void bca_of_difference(benchmark::State& state, bool days, std::size_t replicates) {
  const Data data(static_cast<std::size_t>(state.range(0)));
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (auto _ : state) {
    const Statistic statistic = auc_statistic(data.scores(), data.success, {{0, 1}});
    const ResamplingPlan plan =
        days ? ResamplingPlan::of_clusters(data.day) : ResamplingPlan::of_rows(data.success.size());
    const BootstrapResult result = bootstrap(statistic, plan, {replicates, 1, 0});
    benchmark::DoNotOptimize(bootstrap_estimate(result, 2));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(replicates) *
                          state.range(0));
}

void BM_BcaOfRows(benchmark::State& state) { bca_of_difference(state, false, 10'000); }
void BM_BcaOfDays(benchmark::State& state) { bca_of_difference(state, true, 10'000); }

/// Growth with the rows, at 100 replicates.
void BM_BcaOfRows100(benchmark::State& state) { bca_of_difference(state, false, 100); }

BENCHMARK(BM_BcaOfRows)->Arg(660)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BcaOfDays)->Arg(660)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BcaOfRows100)
    ->RangeMultiplier(10)
    ->Range(1'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);

void BM_JointAuc(benchmark::State& state) {
  const Data data(static_cast<std::size_t>(state.range(0)));
  const std::vector<double> outcome(data.success.begin(), data.success.end());
  for (auto _ : state) {
    benchmark::DoNotOptimize(joint_auc(data.scores(), outcome, {0.95, data.day}));
  }
}

BENCHMARK(BM_JointAuc)->Arg(660)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tcert::statistics
