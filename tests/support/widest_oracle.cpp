#include "support/widest_oracle.hpp"

#include <algorithm>
#include <limits>

namespace tcert::test_support {
namespace {

constexpr double kNoPath = -std::numeric_limits<double>::infinity();

std::size_t state_of(WidestLabels::Kind kind, std::uint32_t node, Side side) {
  return kind == WidestLabels::Kind::sided ? std::size_t{2} * node + static_cast<std::size_t>(side)
                                           : node;
}

}  // namespace

std::vector<double> widest_by_search(const CorridorGraph& graph,
                                     WidestLabels::Kind kind,
                                     std::vector<double> label) {
  std::vector<bool> settled(label.size(), false);
  for (;;) {
    std::size_t widest = label.size();
    for (std::size_t s = 0; s < label.size(); ++s) {
      if (!settled[s] && (widest == label.size() || label[s] > label[widest])) {
        widest = s;
      }
    }
    if (widest == label.size() || label[widest] == kNoPath) {
      return label;
    }
    settled[widest] = true;
    for (const Edge& edge : graph.edges()) {
      for (std::size_t end = 0; end < 2; ++end) {
        const EdgeEnd from = edge.ends[end];
        const EdgeEnd to = edge.ends[1 - end];
        if (state_of(kind, from.node, from.side) == widest) {
          double& far = label[state_of(kind, to.node, opposite(to.side))];
          const double margin_m =
              kind == WidestLabels::Kind::sided ? edge.certified.margin_m : edge.pass.margin_m;
          far = std::max(far, std::min(label[widest], margin_m));
        }
      }
    }
  }
}

double certificate_by_search(const CorridorGraph& graph, bool tied_to_start) {
  const auto nodes = graph.nodes();
  std::vector<double> source(2 * nodes.size(), kNoPath);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (tied_to_start && nodes[n].in_start) {
      source[2 * n] = source[2 * n + 1] = std::numeric_limits<double>::infinity();
    }
  }
  const auto label = widest_by_search(graph, WidestLabels::Kind::sided, source);
  double widest = kNoPath;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].in_goal) {
      widest = std::max({widest, label[2 * n], label[2 * n + 1]});
    }
  }
  return widest;
}

}  // namespace tcert::test_support
