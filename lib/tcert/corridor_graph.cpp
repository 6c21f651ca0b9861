#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <tcert/corridor_graph.hpp>

namespace tcert {

CorridorGraph::CorridorGraph(std::uint32_t max_nodes, std::uint32_t max_edges, double cell_m)
    : cell_m_(cell_m),
      nodes_(max_nodes),
      edges_(max_edges),
      first_half_(max_nodes, kNone),
      next_half_(std::size_t{2} * max_edges, kNone),
      bucket_(std::bit_ceil(std::size_t{2} * max_nodes), kNone),
      next_in_bucket_(max_nodes, kNone) {}

void CorridorGraph::clear() noexcept {
  if (node_count_ > 0) {
    std::fill(bucket_.begin(), bucket_.end(), kNone);
  }
  node_count_ = 0;
  edge_count_ = 0;
}

CorridorGraph::Cell CorridorGraph::cell_of(Point p) const noexcept {
  constexpr double kFar = 4.0e15;  // whole numbers are exact up to here
  const double ix = std::clamp(std::floor(p.x_m / cell_m_), -kFar, kFar);
  const double iy = std::clamp(std::floor(p.y_m / cell_m_), -kFar, kFar);
  return {static_cast<std::int64_t>(ix), static_cast<std::int64_t>(iy)};
}

std::size_t CorridorGraph::bucket_of(Cell cell) const noexcept {
  std::uint64_t hash = static_cast<std::uint64_t>(cell.ix) * 0x9E3779B97F4A7C15ULL;
  hash ^= static_cast<std::uint64_t>(cell.iy) * 0xC2B2AE3D27D4EB4FULL;
  hash ^= hash >> 29U;
  hash *= 0xBF58476D1CE4E5B9ULL;
  hash ^= hash >> 32U;
  return static_cast<std::size_t>(hash) & (bucket_.size() - 1);
}

std::uint32_t CorridorGraph::add_node(const Node& node) noexcept {
  if (nodes_full()) {
    return kNone;
  }
  const std::uint32_t index = node_count_++;
  nodes_[index] = node;
  first_half_[index] = kNone;
  const std::size_t bucket = bucket_of(cell_of(node.pose.position));
  next_in_bucket_[index] = bucket_[bucket];
  bucket_[bucket] = index;
  return index;
}

CorridorGraph::Recorded CorridorGraph::record_pass(EdgeEnd a,
                                                   EdgeEnd b,
                                                   const Pass& pass) noexcept {
  return record_pass(a, b, pass, {pass.margin_m, pass.narrowest, pass.width_m, pass.turn_radius_m});
}

CorridorGraph::Recorded CorridorGraph::record_pass(EdgeEnd a,
                                                   EdgeEnd b,
                                                   const Pass& pass,
                                                   const Certified& certified) noexcept {
  assert(a.node < node_count_ && b.node < node_count_);
  const std::uint32_t known = find_edge(a, b);
  if (known != kNone) {
    Edge& edge = edges_[known];
    const bool felt_rose = pass.margin_m > edge.pass.margin_m;
    if (felt_rose) {
      edge.pass = pass;
    }
    const bool certified_rose = certify(known, certified);
    return {known, felt_rose || certified_rose};
  }
  if (edges_full()) {
    return {};
  }
  const std::uint32_t index = edge_count_++;
  edges_[index] = {{a, b}, pass, certified};
  for (std::uint32_t end = 0; end < 2; ++end) {
    const std::uint32_t half = 2 * index + end;
    const std::uint32_t node = edges_[index].ends[end].node;
    next_half_[half] = first_half_[node];
    first_half_[node] = half;
  }
  return {index, true};
}

std::uint32_t CorridorGraph::find_edge(EdgeEnd a, EdgeEnd b) const noexcept {
  for (std::uint32_t half = first_half_[a.node]; half != kNone; half = next_half_[half]) {
    const Edge& edge = edges_[half / 2];
    if (edge.ends[half % 2] == a && edge.ends[1 - half % 2] == b) {
      return half / 2;
    }
  }
  return kNone;
}

bool CorridorGraph::certify(std::uint32_t edge, const Certified& certified) noexcept {
  const bool rises = certified.margin_m > edges_[edge].certified.margin_m;
  if (rises) {
    edges_[edge].certified = certified;
  }
  return rises;
}

std::span<const Node> CorridorGraph::nodes() const noexcept {
  return std::span(nodes_).first(node_count_);
}

std::span<const Edge> CorridorGraph::edges() const noexcept {
  return std::span(edges_).first(edge_count_);
}

}  // namespace tcert
