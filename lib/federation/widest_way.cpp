#include <algorithm>
#include <federation/widest_way.hpp>
#include <queue>
#include <utility>

namespace tcert::federation {
namespace {

/// Half edges by node: 2 e + end.
class HalfEdges {
 public:
  HalfEdges(std::size_t nodes, std::span<const SubmapEdge> edges) : first_(nodes + 1, 0) {
    for (const SubmapEdge& edge : edges) {
      ++first_[edge.ends[0].node + 1];
      ++first_[edge.ends[1].node + 1];
    }
    for (std::size_t n = 0; n < nodes; ++n) {
      first_[n + 1] += first_[n];
    }
    halves_.resize(2 * edges.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      for (std::uint32_t end = 0; end < 2; ++end) {
        halves_[next[edges[e].ends[end].node]++] = 2 * e + end;
      }
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t node) const {
    return std::span(halves_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> halves_;
};

/// Dijkstra's search for the largest least margin. A state is a node and the side it can be left
/// by, 2 node + side; without sides only the first of them.
class Search {
 public:
  Search(std::span<const SubmapNode> nodes, std::span<const SubmapEdge> edges, bool sided)
      : nodes_(nodes),
        edges_(edges),
        halves_(nodes.size(), edges),
        sided_(sided),
        label_(2 * nodes.size(), Way{}.margin_m),
        by_(2 * nodes.size(), kNone) {}

  Way run() {
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      if (nodes_[n].in_start) {
        raise(state(n, Side::back), std::numeric_limits<double>::infinity(), kNone);
        raise(state(n, Side::front), std::numeric_limits<double>::infinity(), kNone);
      }
    }
    while (!queue_.empty()) {
      const auto [margin_m, order] = queue_.top();
      queue_.pop();
      const std::uint32_t from = ~order;
      if (margin_m < label_[from]) {
        continue;
      }
      if (nodes_[from / 2].in_goal) {
        return way_to(from);
      }
      for (const std::uint32_t half : halves_.at(from / 2)) {
        follow(from, half);
      }
    }
    return {};
  }

 private:
  [[nodiscard]] std::uint32_t state(std::uint32_t node, Side side) const noexcept {
    return 2 * node + (sided_ ? static_cast<std::uint32_t>(side) : 0U);
  }

  void follow(std::uint32_t from, std::uint32_t half) {
    const SubmapEdge& edge = edges_[half / 2];
    if (state(from / 2, edge.ends[half % 2].side) != from) {
      return;
    }
    const EdgeEnd to = edge.ends[1 - half % 2];
    raise(state(to.node, opposite(to.side)), std::min(label_[from], edge.margin_m), half);
  }

  void raise(std::uint32_t to, double margin_m, std::uint32_t by) {
    if (margin_m > label_[to]) {
      label_[to] = margin_m;
      by_[to] = by;
      queue_.push({margin_m, ~to});  // the widest first, then the lowest number
    }
  }

  [[nodiscard]] Way way_to(std::uint32_t last) const {
    Way way;
    way.margin_m = label_[last];
    while (by_[last] != kNone) {
      const std::uint32_t half = by_[last];
      way.steps.push_back({half / 2, half % 2 == 1});
      const EdgeEnd from = edges_[half / 2].ends[half % 2];
      last = state(from.node, from.side);
    }
    std::ranges::reverse(way.steps);
    return way;
  }

  std::span<const SubmapNode> nodes_;
  std::span<const SubmapEdge> edges_;
  HalfEdges halves_;
  bool sided_;
  std::vector<double> label_;
  std::vector<std::uint32_t> by_;
  std::priority_queue<std::pair<double, std::uint32_t>> queue_;
};

}  // namespace

Way widest_way(std::span<const SubmapNode> nodes,
               std::span<const SubmapEdge> edges,
               bool turns_on_the_spot) {
  Way way = Search(nodes, edges, true).run();
  if (turns_on_the_spot && way.margin_m < 0.0) {
    Way turning = Search(nodes, edges, false).run();
    turning.margin_m = std::min(turning.margin_m, 0.0);
    if (turning.margin_m > way.margin_m) {
      return turning;
    }
  }
  return way;
}

}  // namespace tcert::federation
