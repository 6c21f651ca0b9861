#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include <utility>

#include "analysis/study/trials/study.hpp"

namespace tcert::study {
namespace {

using Outcome = std::function<bool()>;

constexpr std::size_t kInFlightPerThread = 4;

}  // namespace

void in_order(std::size_t count, int threads, const std::function<Outcome(std::size_t)>& work) {
  const auto cores =
      static_cast<std::size_t>(threads > 0 ? threads : tbb::info::default_concurrency());
  if (cores == 1) {
    for (std::size_t i = 0; i < count && work(i)(); ++i) {
    }
    return;
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, cores);
  std::size_t next = 0;
  bool stopped = false;
  tbb::task_group_context context;
  const auto index = [&](tbb::flow_control& flow) -> std::size_t {
    if (next == count) {
      flow.stop();
      return 0;
    }
    return next++;
  };
  const auto finish = [&](const Outcome& outcome) {
    if (!stopped && !outcome()) {
      stopped = true;
      context.cancel_group_execution();
    }
  };
  tbb::parallel_pipeline(
      cores * kInFlightPerThread,
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, index) &
          tbb::make_filter<std::size_t, Outcome>(tbb::filter_mode::parallel, work) &
          tbb::make_filter<Outcome, void>(tbb::filter_mode::serial_in_order, finish),
      context);
}

}  // namespace tcert::study
