#include <algorithm>
#include <limits>
#include <tcert/widest_labels.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kNoPath = -std::numeric_limits<double>::infinity();

}  // namespace

WidestLabels::WidestLabels(Kind kind, Margin margin, std::uint32_t max_nodes)
    : kind_(kind), margin_(margin), sink_(kNoPath) {
  const std::size_t states = std::size_t{kind == Kind::sided ? 2U : 1U} * max_nodes;
  label_.assign(states, kNoPath);
  via_.assign(states, kNone);
  heap_.assign(states, kNone);
  slot_.assign(states, kNone);
  is_sink_.assign(max_nodes, 0);
}

void WidestLabels::clear() noexcept {
  sink_ = kNoPath;
  sink_end_ = {};
  heap_size_ = 0;
  raised_ = 0;
}

void WidestLabels::add_node(std::uint32_t node, bool is_sink) noexcept {
  is_sink_[node] = is_sink ? 1 : 0;
  for (const Side side : {Side::back, Side::front}) {
    const std::uint32_t state = state_of(node, side);
    label_[state] = kNoPath;
    via_[state] = kNone;
    slot_[state] = kNone;
  }
}

double WidestLabels::at(std::uint32_t node) const noexcept {
  return std::max(leaving(node, Side::back), leaving(node, Side::front));
}

void WidestLabels::raise_node(const CorridorGraph& graph,
                              std::uint32_t node,
                              double value) noexcept {
  raise(state_of(node, Side::back), value, kNone);
  raise(state_of(node, Side::front), value, kNone);
  propagate(graph);
}

void WidestLabels::relax_edge(const CorridorGraph& graph, std::uint32_t edge) noexcept {
  relax(graph, edge, 0);
  relax(graph, edge, 1);
  propagate(graph);
}

// Along `edge` from its end `from_end`: left by that side, the far node can be left by the side
// opposite to the one it is entered by.
void WidestLabels::relax(const CorridorGraph& graph,
                         std::uint32_t edge,
                         std::uint32_t from_end) noexcept {
  const Edge& e = graph.edges()[edge];
  const EdgeEnd from = e.ends[from_end];
  const EdgeEnd to = e.ends[1 - from_end];
  const double margin_m = margin_ == Margin::certified ? e.certified.margin_m : e.pass.margin_m;
  raise(state_of(to.node, opposite(to.side)),
        std::min(leaving(from.node, from.side), margin_m),
        edge);
}

void WidestLabels::raise(std::uint32_t state, double value, std::uint32_t via) noexcept {
  if (!(value > label_[state])) {
    return;
  }
  label_[state] = value;
  via_[state] = via;
  ++raised_;
  if (is_sink_[node_of(state)] != 0 && value > sink_) {
    sink_ = value;
    const Side left_by = kind_ == Kind::sided ? static_cast<Side>(state % 2) : Side::front;
    sink_end_ = {node_of(state), opposite(left_by)};
  }
  if (slot_[state] == kNone) {
    slot_[state] = heap_size_;
    heap_[heap_size_++] = state;
  }
  sift_up(slot_[state]);
}

// Largest first: each state that rises is passed on once.
void WidestLabels::propagate(const CorridorGraph& graph) noexcept {
  while (heap_size_ > 0) {
    const std::uint32_t state = pop_largest();
    const std::uint32_t node = node_of(state);
    graph.for_each_edge_at(node, [&](std::uint32_t edge, std::uint32_t end) noexcept {
      if (state_of(node, graph.edges()[edge].ends[end].side) == state) {
        relax(graph, edge, end);
      }
    });
  }
}

std::uint32_t WidestLabels::pop_largest() noexcept {
  const std::uint32_t top = heap_[0];
  slot_[top] = kNone;
  --heap_size_;
  if (heap_size_ > 0) {
    heap_[0] = heap_[heap_size_];
    slot_[heap_[0]] = 0;
    sift_down(0);
  }
  return top;
}

void WidestLabels::sift_up(std::uint32_t slot) noexcept {
  while (slot > 0) {
    const std::uint32_t parent = (slot - 1) / 2;
    if (label_[heap_[parent]] >= label_[heap_[slot]]) {
      return;
    }
    std::swap(heap_[parent], heap_[slot]);
    std::swap(slot_[heap_[parent]], slot_[heap_[slot]]);
    slot = parent;
  }
}

void WidestLabels::sift_down(std::uint32_t slot) noexcept {
  for (std::uint32_t child = 2 * slot + 1; child < heap_size_; child = 2 * slot + 1) {
    if (child + 1 < heap_size_ && label_[heap_[child + 1]] > label_[heap_[child]]) {
      ++child;
    }
    if (label_[heap_[slot]] >= label_[heap_[child]]) {
      return;
    }
    std::swap(heap_[slot], heap_[child]);
    std::swap(slot_[heap_[slot]], slot_[heap_[child]]);
    slot = child;
  }
}

}  // namespace tcert
