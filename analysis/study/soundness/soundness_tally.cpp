#include "analysis/study/soundness/soundness_tally.hpp"

#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/quantile.hpp>

namespace tcert::study {

void SoundnessSummary::add(const WorldOutcome& world,
                           const SoundnessOutcome& outcome,
                           std::uint64_t number) {
  ++worlds;
  ticks += world.ticks;
  issued += outcome.issued ? 1U : 0U;
  untraversable += world.truth_m <= 0.0 ? 1U : 0U;
  spurious += outcome.issued && world.truth_m <= 0.0 ? 1U : 0U;
  violations += outcome.violating_ticks > 0 ? 1U : 0U;
  violating_ticks += outcome.violating_ticks;
  if (outcome.excess_m > largest_excess_m) {
    largest_excess_m = outcome.excess_m;
    worst_world = number;
  }
}

double SoundnessSummary::violation_bound() const {
  return statistics::clopper_pearson_upper(violations, worlds).value_or(1.0);
}

SoundnessTally::SoundnessTally(std::size_t methods, std::span<const WorldFamily> families)
    : of_all_(methods), gaps_(methods) {
  for (const WorldFamily family : families) {
    of_family_[family].resize(methods);
  }
}

void SoundnessTally::add(const WorldOutcome& world, std::uint64_t number) {
  ++worlds_;
  const auto own = of_family_.find(world.family);
  for (std::size_t method = 0; method < of_all_.size(); ++method) {
    const SoundnessOutcome& outcome = world.outcomes.at(method);
    of_all_[method].add(world, outcome, number);
    if (own != of_family_.end()) {
      own->second[method].add(world, outcome, number);
    }
    if (world.reached && outcome.certificate_m > ClearanceValue::kNoPath) {
      gaps_[method][{world.family, world.explored, world.lanes}].push_back(world.truth_m -
                                                                           outcome.certificate_m);
    }
  }
}

std::vector<Tightness> SoundnessTally::tightness(std::size_t method) const {
  std::vector<Tightness> rows;
  for (const auto& [place, gaps] : gaps_.at(method)) {
    const auto& [family, explored, lanes] = place;
    std::vector<double> values = gaps;
    rows.push_back({family,
                    explored,
                    lanes,
                    values.size(),
                    statistics::quantile_in_place(values, 0.5).value(),
                    statistics::quantile_in_place(values, 0.9).value()});
  }
  return rows;
}

}  // namespace tcert::study
