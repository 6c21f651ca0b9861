#include "analysis/study/witness/witness_looks.hpp"

#include <algorithm>
#include <cmath>
#include <tcert/tick.hpp>

namespace tcert::study {

std::vector<std::size_t> ticks_to_look_at(std::span<const CertifiedTick> series,
                                          std::uint32_t every) {
  const auto first = std::ranges::find_if(
      series, [](const CertifiedTick& tick) { return (tick.flags & flag_goal_reached) != 0; });
  std::vector<std::size_t> ticks;
  if (every == 0) {
    return ticks;
  }
  for (auto i = static_cast<std::size_t>(first - series.begin()); i + 1 < series.size();
       i += every) {
    ticks.push_back(i);
  }
  return ticks;
}

witness::Samples known_samples(const witness::Samples& felt,
                               std::int64_t time_ns,
                               const Robot& robot,
                               double lost_share) {
  const auto known = static_cast<std::size_t>(
      std::ranges::upper_bound(felt.known_ns, time_ns) - felt.known_ns.begin());
  witness::Samples samples = witness::first_samples(felt, known);
  witness::drop_glitches(samples, robot, lost_share);
  for (std::size_t k = 0; k < samples.rays; ++k) {
    for (std::size_t i = samples.size(); i-- > 0;) {
      double& clearance_m = samples.clearances_m[i * samples.rays + k];
      if (!std::isnan(clearance_m)) {
        clearance_m = kMissing;
        break;
      }
    }
  }
  return samples;
}

void keep_best(const std::vector<WitnessLook>& looks,
               const Robot& robot,
               const Region& goal,
               Proof& proof) {
  const WitnessLook* best = nullptr;
  for (const WitnessLook& look : looks) {
    if (look.found && (best == nullptr ||
                       look.found->checked.margin_m > best->found->checked.margin_m)) {
      best = &look;
    }
  }
  if (best == nullptr) {
    return;
  }
  const witness::Path& path = best->found->path;
  witness::Checked again = witness::check(path, proof.cells, proof.start, goal, robot);
  const bool is_better =
      again.refused.empty() && (!proof.witness || again.margin_m > proof.witness->checked.margin_m);
  if (is_better) {
    proof.witness = witness::Witness{path, std::move(again)};
    proof.reason.clear();
  }
}

}  // namespace tcert::study
