#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/route_planner.hpp>
#include <variant>

namespace tcert {
namespace {

constexpr std::uint32_t kGoalState = 0;
constexpr double kUnitsPerMetre = 1e6;
constexpr double kLostAtOnce = 0.01;   // m
constexpr double kLargestCost = 1e15;  // far from overflow along any path

std::uint32_t state_of(std::uint32_t node) noexcept { return node + 1; }
std::uint32_t node_of(std::uint32_t state) noexcept { return state - 1; }

Point centre_of(const Region& region) {
  if (const Disc* disc = std::get_if<Disc>(&region)) {
    return disc->centre;
  }
  const auto& corners = std::get<Polygon>(region).vertices;
  Point sum;
  for (const Point& corner : corners) {
    sum = sum + corner;
  }
  return (1.0 / static_cast<double>(corners.size())) * sum;
}

}  // namespace

void validate(const RouteParameters& p) { require_fields(p); }

RoutePlanner::RoutePlanner(std::uint32_t max_nodes,
                           std::uint32_t max_edges,
                           const Region& goal,
                           const RobustMargin& margin,
                           const RouteParameters& parameters)
    : margin_(margin),
      parameters_(parameters),
      goal_(centre_of(goal)),
      search_(max_nodes + 1, max_nodes + max_edges),
      frontier_(max_nodes, kNone),
      corridor_(max_edges, kNone),
      open_cost_(std::size_t{max_nodes} + max_edges, kBlocked),
      until_ns_(std::size_t{max_nodes} + max_edges, 0),
      blocked_(std::size_t{max_nodes} + max_edges) {
  validate(parameters);
  clear();
}

void RoutePlanner::clear() noexcept {
  search_.clear();
  search_.add_state(goal_);
  search_.set_goal(kGoalState);
  blocked_count_ = 0;
  known_nodes_ = known_edges_ = 0;
  at_node_ = kNone;
  now_ns_ = 0;
  lost_m_ = 0.0;
  pending_violates_ = false;
}

// Rounded up to whole units, so that no edge is cheaper than it is.
PathCost RoutePlanner::cost_of(double length_m, double margin_m) const noexcept {
  const double inflated = length_m * (1.0 + parameters_.inflation_m / margin_m);
  return static_cast<PathCost>(std::ceil(std::min(inflated * kUnitsPerMetre, kLargestCost)));
}

void RoutePlanner::take_nodes(const CorridorGraph& graph) noexcept {
  for (; known_nodes_ < graph.nodes().size(); ++known_nodes_) {
    const Node& node = graph.nodes()[known_nodes_];
    const std::uint32_t state = search_.add_state(node.pose.position);
    const double length_m = distance(node.pose.position, goal_);
    const PathCost cost = node.in_goal ? 0 : cost_of(length_m, parameters_.unknown_margin_m);
    const std::uint32_t edge = search_.add_edge(state, kGoalState, cost);
    frontier_[known_nodes_] = edge;
    open_cost_[edge] = cost;
    until_ns_[edge] = 0;
  }
  for (; known_edges_ < graph.edges().size(); ++known_edges_) {
    const auto& ends = graph.edges()[known_edges_].ends;
    const std::uint32_t edge =
        search_.add_edge(state_of(ends[0].node), state_of(ends[1].node), kBlocked);
    corridor_[known_edges_] = edge;
    open_cost_[edge] = kBlocked;
    until_ns_[edge] = 0;
  }
}

void RoutePlanner::take_edges_at(const CorridorGraph& graph, std::uint32_t node) noexcept {
  graph.for_each_edge_at(
      node, [&](std::uint32_t index, std::uint32_t /*end*/) noexcept { take_edge(graph, index); });
}

void RoutePlanner::take_edge(const CorridorGraph& graph, std::uint32_t index) noexcept {
  const Edge& edge = graph.edges()[index];
  const double margin_m = edge.pass.margin_m - lost_m_ - margin_.tracking_error_m;
  const double length_m = distance(graph.nodes()[edge.ends[0].node].pose.position,
                                   graph.nodes()[edge.ends[1].node].pose.position);
  const std::uint32_t in_search = corridor_[index];
  open_cost_[in_search] =
      margin_m > margin_.least_m ? cost_of(length_m, std::max(margin_m, 1e-9)) : kBlocked;
  if (until_ns_[in_search] == 0) {
    search_.set_cost(in_search, open_cost_[in_search]);
  }
}

void RoutePlanner::follow(const CorridorGraph& graph,
                          std::uint32_t at_node,
                          std::int64_t time_ns,
                          double since_start_m) noexcept {
  now_ns_ = time_ns;
  lift_blocks();
  const std::uint32_t before = known_edges_;
  take_nodes(graph);
  if (since_start_m > lost_m_) {
    lost_m_ = kLostAtOnce * std::ceil(since_start_m / kLostAtOnce);
    for (std::uint32_t index = 0; index < before; ++index) {
      take_edge(graph, index);
    }
  }
  if (at_node == at_node_) {
    return;
  }
  // An edge that closed at this tick ends at the node passed before or at the one passed now.
  for (const std::uint32_t node : {at_node_, at_node}) {
    if (node != kNone) {
      take_edges_at(graph, node);
    }
  }
  if (pending_violates_ && at_node_ != kNone && at_node != kNone) {
    graph.for_each_edge_at(at_node, [&](std::uint32_t index, std::uint32_t end) noexcept {
      if (graph.edges()[index].ends[1 - end].node == at_node_) {
        block(corridor_[index]);
      }
    });
  }
  pending_violates_ = false;
  at_node_ = at_node;
}

void RoutePlanner::block_ahead(bool violates_force) noexcept {
  pending_violates_ = pending_violates_ || violates_force;
  if (at_node_ != kNone) {
    block(frontier_[at_node_]);
  }
}

void RoutePlanner::block(std::uint32_t edge) noexcept {
  if (until_ns_[edge] == 0) {
    blocked_[blocked_count_++] = edge;
    search_.set_cost(edge, kBlocked);
  }
  until_ns_[edge] = now_ns_ + static_cast<std::int64_t>(parameters_.block_s * 1e9);
}

void RoutePlanner::lift_blocks() noexcept {
  for (std::size_t i = blocked_count_; i > 0; --i) {
    const std::uint32_t edge = blocked_[i - 1];
    if (until_ns_[edge] <= now_ns_) {
      until_ns_[edge] = 0;
      search_.set_cost(edge, open_cost_[edge]);
      blocked_[i - 1] = blocked_[--blocked_count_];
    }
  }
}

Route RoutePlanner::replan() noexcept {
  Route route;
  if (at_node_ == kNone) {
    return route;
  }
  search_.set_start(state_of(at_node_));
  route.cost = search_.plan();
  std::uint32_t at = state_of(at_node_);
  while (route.cost != kBlocked) {
    const std::uint32_t next = search_.next(at).state;
    if (next == kGoalState) {
      route.exit = node_of(at);
      break;
    }
    route.next = route.next == kNone ? node_of(next) : route.next;
    at = next;
  }
  return route;
}

}  // namespace tcert
