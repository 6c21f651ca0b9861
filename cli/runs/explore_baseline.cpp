#include "cli/runs/explore_baseline.hpp"

#include <fmt/format.h>

#include <table/random.hpp>

namespace tcert::cli {

terrain::BaselineResult baseline_walk(const ExploreRequest& o,
                                      const terrain::Terrain& ground,
                                      const terrain::ExploreSetup& places) {
  if (!places.goal || !places.more_goals.empty()) {
    throw UsageError("--baseline needs one --goal");
  }
  if (o.baseline == "straight") {
    return terrain::straight_walk(ground, places.blocked, o.threshold, places.start, *places.goal);
  }
  if (!places.blocked.empty()) {
    throw UsageError("--baseline sparse-rrt knows no obstacles or gaps: take --baseline straight");
  }
  constexpr std::uint32_t kPurpose = 0x7e44bc;  // of the random stream
  table::RandomStream random(static_cast<std::uint64_t>(o.seed), kPurpose, 0);
  terrain::SparseRrtOptions options;
  options.prior.mean = o.threshold;
  return terrain::sparse_rrt_walk(
      ground, o.threshold, places.start, *places.goal, options, [&] { return random.uniform(); });
}

std::string baseline_summary(const std::string& method, const terrain::BaselineResult& result) {
  return fmt::format(
      "method: {}\nend: {}\nsteps onto unsafe cells, each of which is a failure: {}\nmeasurements: "
      "{}\nplans: {}\ntravelled: {:.1f} cells\n",
      method,
      result.reached ? "reached" : "not reached",
      result.unsafe_visits,
      result.samples,
      result.plans,
      result.length);
}

}  // namespace tcert::cli
