#include "analysis/study/trials/certify_trial.hpp"

#include <cstddef>

namespace tcert::study {

TrialSeries certify_trial(Certifier& certifier, const TickTable& ticks) {
  certifier.reset();
  TrialSeries series;
  series.ticks.reserve(ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    series.ticks.push_back(certifier.update(ticks[i]));
  }
  series.bottleneck = certifier.bottleneck();
  const CorridorGraph& graph = certifier.graph();
  series.nodes.assign(graph.nodes().begin(), graph.nodes().end());
  series.edges.assign(graph.edges().begin(), graph.edges().end());
  for (Edge& edge : series.edges) {
    edge.pass.margin_m -= certifier.since_start_m();
    edge.certified.margin_m -= certifier.since_start_m();
  }
  return series;
}

}  // namespace tcert::study
