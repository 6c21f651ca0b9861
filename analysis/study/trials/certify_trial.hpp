#pragma once
/// \file
/// The certificate series of one trial: every reader of a trial goes through here.

#include <optional>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <vector>

#include "datasets/ticks.hpp"

namespace tcert::study {

/// What a trial shows, tick by tick, and where its last certificate is decided.
struct TrialSeries {
  std::vector<CertifiedTick> ticks;      ///< One per tick of the table, stale ones included.
  std::optional<Bottleneck> bottleneck;  ///< Empty unless S and G are connected at the end.
  std::vector<Node> nodes;               ///< Of the corridor graph at the end.
  std::vector<Edge> edges;               ///< Margins as they hold at the last tick.
};

/// Feeds `ticks` to the certifier, which is reset first and left in the state after the last tick,
/// so its graph is the trial's. One certifier serves any number of trials.
[[nodiscard]] TrialSeries certify_trial(Certifier& certifier, const TickTable& ticks);

}  // namespace tcert::study
