#include <algorithm>
#include <cmath>
#include <tcert/dstar_lite.hpp>

namespace tcert {
namespace {

constexpr double kUnitsPerMetre = 1e6;

PathCost sum(PathCost a, PathCost b) noexcept {
  return a == kBlocked || b == kBlocked ? kBlocked : a + b;
}

}  // namespace

DStarLite::DStarLite(std::uint32_t max_states, std::uint32_t max_edges)
    : position_(max_states),
      edges_(max_edges),
      first_half_(max_states, kNoState),
      next_half_(std::size_t{2} * max_edges, kNoState),
      g_(max_states, kBlocked),
      rhs_(max_states, kBlocked),
      key_(max_states),
      heap_(max_states),
      slot_(max_states, kNoState) {}

void DStarLite::clear() noexcept {
  state_count_ = edge_count_ = heap_size_ = 0;
  start_ = goal_ = kNoState;
  shift_ = 0;
  expansions_ = 0;
}

std::uint32_t DStarLite::add_state(Point position) noexcept {
  if (state_count_ == position_.size()) {
    return kNoState;
  }
  const std::uint32_t state = state_count_++;
  position_[state] = position;
  first_half_[state] = kNoState;
  g_[state] = rhs_[state] = kBlocked;
  slot_[state] = kNoState;
  return state;
}

std::uint32_t DStarLite::add_edge(std::uint32_t a, std::uint32_t b, PathCost cost) noexcept {
  if (edge_count_ == edges_.size()) {
    return kNoState;
  }
  const std::uint32_t edge = edge_count_++;
  edges_[edge] = {{a, b}, kBlocked};
  for (const std::uint32_t end : {0U, 1U}) {
    const std::uint32_t state = edges_[edge].ends[end];
    next_half_[2 * edge + end] = first_half_[state];
    first_half_[state] = 2 * edge + end;
  }
  set_cost(edge, cost);
  return edge;
}

void DStarLite::set_cost(std::uint32_t edge, PathCost cost) noexcept {
  const auto [a, b] = edges_[edge].ends;
  const PathCost now = cost == kBlocked ? kBlocked : std::max(cost, distance_between(a, b) + 1);
  const PathCost before = edges_[edge].cost;
  edges_[edge].cost = now;
  if (before != now) {
    cost_changed(a, b, before, now);
    cost_changed(b, a, before, now);
  }
}

void DStarLite::cost_changed(std::uint32_t state,
                             std::uint32_t other,
                             PathCost before,
                             PathCost now) noexcept {
  if (state == goal_) {
    return;
  }
  if (now < before) {
    rhs_[state] = std::min(rhs_[state], sum(now, g_[other]));
  } else if (rhs_[state] == sum(before, g_[other])) {
    rhs_[state] = best_successor(state);
  }
  update_state(state);
}

void DStarLite::set_goal(std::uint32_t goal) noexcept {
  goal_ = goal;
  forget();
}

// Keys in the heap were made for the start before; raising later ones by how far it has moved keeps
// the old ones lower bounds. Rounded distances may break the triangle inequality by one unit.
void DStarLite::set_start(std::uint32_t start) noexcept {
  if (start_ != kNoState && start != start_) {
    shift_ += distance_between(start_, start) + 1;
  }
  start_ = start;
}

void DStarLite::forget() noexcept {
  std::fill_n(g_.begin(), state_count_, kBlocked);
  std::fill_n(rhs_.begin(), state_count_, kBlocked);
  std::fill_n(slot_.begin(), state_count_, kNoState);
  heap_size_ = 0;
  shift_ = 0;
  if (goal_ != kNoState) {
    rhs_[goal_] = 0;
    update_state(goal_);
  }
}

PathCost DStarLite::distance_between(std::uint32_t a, std::uint32_t b) const noexcept {
  return static_cast<PathCost>(kUnitsPerMetre * distance(position_[a], position_[b]));
}

DStarLite::Key DStarLite::key_of(std::uint32_t state) const noexcept {
  const PathCost least = std::min(g_[state], rhs_[state]);
  const PathCost ahead = start_ == kNoState ? 0 : distance_between(start_, state);
  return {sum(least, ahead + shift_), least};
}

PathCost DStarLite::best_successor(std::uint32_t state) const noexcept {
  PathCost best = kBlocked;
  for (std::uint32_t half = first_half_[state]; half != kNoState; half = next_half_[half]) {
    const Edge& edge = edges_[half / 2];
    best = std::min(best, sum(edge.cost, g_[edge.ends[1 - half % 2]]));
  }
  return best;
}

void DStarLite::update_state(std::uint32_t state) noexcept {
  const bool queued = slot_[state] != kNoState;
  if (g_[state] == rhs_[state]) {
    if (queued) {
      remove(state);
    }
    return;
  }
  if (queued) {
    key_[state] = key_of(state);
    move_up(slot_[state]);
    move_down(slot_[state]);
  } else {
    insert(state, key_of(state));
  }
}

PathCost DStarLite::plan() noexcept {
  while (heap_size_ > 0) {
    const std::uint32_t state = heap_[0];
    const Key old_key = key_[state];
    if (!(old_key < key_of(start_)) && rhs_[start_] <= g_[start_]) {
      break;
    }
    const Key new_key = key_of(state);
    if (old_key < new_key) {
      key_[state] = new_key;
      move_down(0);
      continue;
    }
    ++expansions_;
    if (g_[state] > rhs_[state]) {
      g_[state] = rhs_[state];
      remove(state);
      lower_neighbours(state);
    } else {
      raise_neighbours(state);
    }
  }
  return rhs_[start_];
}

void DStarLite::lower_neighbours(std::uint32_t state) noexcept {
  for (std::uint32_t half = first_half_[state]; half != kNoState; half = next_half_[half]) {
    const Edge& edge = edges_[half / 2];
    const std::uint32_t near = edge.ends[1 - half % 2];
    const PathCost through = sum(edge.cost, g_[state]);
    if (near != goal_ && through < rhs_[near]) {
      rhs_[near] = through;
      update_state(near);
    }
  }
}

void DStarLite::raise_neighbours(std::uint32_t state) noexcept {
  const PathCost before = g_[state];
  g_[state] = kBlocked;
  for (std::uint32_t half = first_half_[state]; half != kNoState; half = next_half_[half]) {
    const Edge& edge = edges_[half / 2];
    const std::uint32_t near = edge.ends[1 - half % 2];
    if (near != goal_ && rhs_[near] != kBlocked && rhs_[near] == sum(edge.cost, before)) {
      rhs_[near] = best_successor(near);
      update_state(near);
    }
  }
  update_state(state);
}

DStarLite::Step DStarLite::next(std::uint32_t state) const noexcept {
  Step step;
  if (state == goal_) {
    return step;
  }
  PathCost best = kBlocked;
  for (std::uint32_t half = first_half_[state]; half != kNoState; half = next_half_[half]) {
    const Edge& edge = edges_[half / 2];
    const std::uint32_t far = edge.ends[1 - half % 2];
    const PathCost through = sum(edge.cost, g_[far]);
    if (through < best || (through == best && through != kBlocked && half / 2 < step.edge)) {
      best = through;
      step = {far, half / 2};
    }
  }
  return step;
}

void DStarLite::place(std::uint32_t slot, std::uint32_t state) noexcept {
  heap_[slot] = state;
  slot_[state] = slot;
}

void DStarLite::insert(std::uint32_t state, Key key) noexcept {
  key_[state] = key;
  place(heap_size_, state);
  move_up(heap_size_++);
}

void DStarLite::remove(std::uint32_t state) noexcept {
  const std::uint32_t slot = slot_[state];
  slot_[state] = kNoState;
  --heap_size_;
  if (slot == heap_size_) {
    return;
  }
  const std::uint32_t last = heap_[heap_size_];
  place(slot, last);
  move_up(slot);
  move_down(slot_[last]);
}

void DStarLite::move_up(std::uint32_t slot) noexcept {
  const std::uint32_t state = heap_[slot];
  while (slot > 0 && key_[state] < key_[heap_[(slot - 1) / 2]]) {
    place(slot, heap_[(slot - 1) / 2]);
    slot = (slot - 1) / 2;
  }
  place(slot, state);
}

void DStarLite::move_down(std::uint32_t slot) noexcept {
  const std::uint32_t state = heap_[slot];
  for (;;) {
    std::uint32_t child = 2 * slot + 1;
    if (child >= heap_size_) {
      break;
    }
    if (child + 1 < heap_size_ && key_[heap_[child + 1]] < key_[heap_[child]]) {
      ++child;
    }
    if (!(key_[heap_[child]] < key_[state])) {
      break;
    }
    place(slot, heap_[child]);
    slot = child;
  }
  place(slot, state);
}

}  // namespace tcert
