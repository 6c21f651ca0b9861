#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/corridor_walk.hpp>
#include <tcert/lengths.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

CorridorWalk::CorridorWalk(const Robot& robot,
                           const CertificateParameters& parameters,
                           SweptMargins* swept)
    : parameters_(parameters),
      rule_(robot, parameters),
      swept_(swept),
      graph_(parameters.max_nodes,
             parameters.max_edges,
             2.0 * parameters.merge_radius_m + parameters.max_step_m),
      through_(WidestLabels::Kind::sided, WidestLabels::Margin::certified, parameters.max_nodes),
      reached_(WidestLabels::Kind::sideless, WidestLabels::Margin::felt, parameters.max_nodes) {
  if (robot.min_turn_radius_m == 0.0) {
    turning_.emplace(
        WidestLabels::Kind::sideless, WidestLabels::Margin::certified, parameters.max_nodes);
  }
}

// To turn on the spot is to drive a radius of 0: the margin is at most 0 - R_min = 0.
double CorridorWalk::certificate_m(double since_start_m) const noexcept {
  return turning_ ? std::max(through_.sink(), std::min(turning_->sink(), since_start_m))
                  : through_.sink();
}

void CorridorWalk::clear() noexcept {
  graph_.clear();
  through_.clear();
  if (turning_) {
    turning_->clear();
  }
  reached_.clear();
  at_node_ = kNone;
  goal_entered_ = false;
  capacity_exceeded_ = false;
}

double CorridorWalk::reached_m() const noexcept {
  return at_node_ == kNone ? carried_m_ : reached_.at(at_node_);
}

double CorridorWalk::pending_value_m(const Evidence& now) const noexcept {
  return std::min(reached_m(), pending_.margin_m() - now.memory_deduction_m);
}

void CorridorWalk::begin(const Evidence& evidence, bool outside_start) noexcept {
  outside_start_ = outside_start;
  if (swept_ != nullptr) {
    swept_->begin(evidence);
  }
  start_component(evidence, -kInfinity);
  goal_entered_ = evidence.in_goal;
  corridor_value_m_ = pending_value_m(evidence);
  last_ = evidence;
}

void CorridorWalk::advance_after_break(const Evidence& evidence, double bridge_m) noexcept {
  const std::uint32_t before = at_node_;
  const Side left_by = left_by_;
  if (swept_ != nullptr) {
    swept_->break_path(evidence);
  }
  start_component(evidence, corridor_value_m_);
  if (bridge_m > -kInfinity && before != kNone && at_node_ != kNone) {
    const EdgeEnd to{at_node_, Side::back};
    keep(graph_.record_pass(
        {before, left_by},
        to,
        {bridge_m, evidence.pose, evidence.width_m, evidence.turn_radius_m, {}, {}}));
  }
  goal_entered_ = goal_entered_ || evidence.in_goal;
  corridor_value_m_ = pending_value_m(evidence);
  last_ = evidence;
}

void CorridorWalk::advance(const Evidence& evidence) noexcept {
  pending_.add(evidence);
  if (swept_ != nullptr) {
    swept_->add(evidence);
  }
  follow_motion(evidence);
  if (!cross(evidence)) {
    const Side entered = forward_ ? Side::back : Side::front;
    if (reaches(furthest_m_ - progress_m_, parameters_.reversal_m)) {
      close_at_new_node(evidence, entered, entered);
    } else if (reaches(evidence.travel_m - node_travel_m_, parameters_.edge_length_m)) {
      close_at_new_node(evidence, entered, opposite(entered));
    }
  }
  if (evidence.in_goal && !goal_entered_) {
    goal_entered_ = true;
    if (at_node_ != kNone && !graph_.nodes()[at_node_].in_goal) {
      const Side entered = forward_ ? Side::back : Side::front;
      close_at_new_node(evidence, entered, opposite(entered));
    }
  }
  if (evidence.in_goal) {
    look_again();
  }
  corridor_value_m_ = pending_value_m(evidence);
  last_ = evidence;
}

void CorridorWalk::follow_motion(const Evidence& now) noexcept {
  const double along_m = dot(now.pose.position - last_.pose.position, now.heading);
  progress_m_ += forward_ ? along_m : -along_m;
  furthest_m_ = std::max(furthest_m_, progress_m_);
}

// Closes the pending edge at the known node that the path crosses, or restarts it at u.
bool CorridorWalk::cross(const Evidence& now) noexcept {
  const PathStep step{last_, now, pending_};
  const Crossing known = nearest_crossing(graph_, at_node_, step, rule_);
  if (known.node != kNone) {
    join(known, now);
    if (at_node_ != kNone) {
      record({known.node, known.entered}, pending_.finish(), known.turn);
    }
    pass_node(known, now);
    return true;
  }
  const Crossing own = at_node_ == kNone ? Crossing{} : crossing_of(graph_, at_node_, step, rule_);
  if (own.node == kNone) {
    return false;
  }
  join(own, now);
  pass_node(own, now);
  return true;
}

// Both ends of the crossing interval count in both edges.
void CorridorWalk::pass_node(const Crossing& crossing, const Evidence& now) noexcept {
  leave(crossing.node, opposite(crossing.entered), now);
  restart_pass(last_, crossing.turn);
  pending_.add(now);
}

void CorridorWalk::restart_pass(const Evidence& first, const Turn& changed) noexcept {
  pending_.restart(first);
  changed_ = changed;
  if (swept_ != nullptr) {
    swept_->start_pass();
  }
}

// Between where the path crosses a node's line and the node itself the body must fit and turn too.
void CorridorWalk::join(const Crossing& crossing, const Evidence& now) noexcept {
  if (swept_ == nullptr) {
    return;
  }
  Evidence between = now;
  between.turn_slack_m = crossing.turn.slack_m;
  if (crossing.turn.slack_m < kInfinity) {
    between.turn_radius_m = crossing.turn.turn_radius_m;
  }
  swept_->add_join(crossing.at, between, graph_.nodes()[crossing.node]);
}

// What has been swept since may have raised the margins of passes nearby. Before G is reached that
// need not be known.
void CorridorWalk::look_again() noexcept {
  if (swept_ == nullptr) {
    return;
  }
  if (goal_entered_) {
    swept_->look_at_open_steps();
  }
  swept_->hand_out([this](EdgeEnd from, EdgeEnd to, const Certified& certified) noexcept {
    const std::uint32_t edge = graph_.find_edge(from, to);
    if (edge != kNone && graph_.certify(edge, certified)) {
      relax(edge);
    }
  });
}

void CorridorWalk::leave(std::uint32_t node, Side side, const Evidence& now) noexcept {
  const double along_m = dot(now.pose.position - last_.pose.position, now.heading);
  at_node_ = node;
  left_by_ = side;
  node_travel_m_ = now.travel_m;
  forward_ = along_m >= 0.0;
  progress_m_ = 0.0;
  furthest_m_ = 0.0;
}

// Entered and left by the same side, the path turns back here.
void CorridorWalk::close_at_new_node(const Evidence& now, Side entered, Side left) noexcept {
  if (at_node_ == kNone) {
    return;
  }
  const double corridor_value_m = pending_value_m(now);
  const std::uint32_t node = lay_node(now);
  if (node == kNone) {
    carried_m_ = corridor_value_m;
    at_node_ = kNone;
    return;
  }
  if (graph_.edges_full()) {
    capacity_exceeded_ = true;
    reached_.raise_node(graph_, node, corridor_value_m);
  } else {
    record({node, entered}, pending_.finish(), {});
  }
  at_node_ = node;
  left_by_ = left;
  node_travel_m_ = now.travel_m;
  forward_ = left == Side::front;
  progress_m_ = 0.0;
  furthest_m_ = 0.0;
  restart_pass(now, {});
}

void CorridorWalk::start_component(const Evidence& now, double corridor_value_m) noexcept {
  at_node_ = lay_node(now);
  carried_m_ = corridor_value_m;
  if (at_node_ != kNone) {
    reached_.raise_node(graph_, at_node_, corridor_value_m);
  }
  left_by_ = Side::front;
  node_travel_m_ = now.travel_m;
  forward_ = true;
  progress_m_ = 0.0;
  furthest_m_ = 0.0;
  restart_pass(now, {});
}

std::uint32_t CorridorWalk::lay_node(const Evidence& now) noexcept {
  const std::uint32_t node = graph_.add_node({now.pose, now.heading, now.in_start, now.in_goal});
  if (node == kNone) {
    capacity_exceeded_ = true;
    return kNone;
  }
  through_.add_node(node, now.in_goal);
  if (turning_) {
    turning_->add_node(node, now.in_goal);
  }
  reached_.add_node(node, now.in_goal);
  if (now.in_start && !outside_start_) {
    through_.raise_node(graph_, node, kInfinity);
    if (turning_) {
      turning_->raise_node(graph_, node, kInfinity);
    }
    reached_.raise_node(graph_, node, kInfinity);
  }
  return node;
}

// T_t takes what the changes at both ends of the pass ask for; V_t, on the path driven, does not.
void CorridorWalk::record(EdgeEnd to, const Pass& pass, const Turn& changed) noexcept {
  const EdgeEnd from{at_node_, left_by_};
  if (swept_ == nullptr) {
    Certified certified{pass.margin_m, pass.narrowest, pass.width_m, pass.turn_radius_m};
    for (const Turn& turn : {changed_, changed}) {
      if (turn.slack_m < certified.margin_m) {
        certified = {turn.slack_m, turn.pose, pass.width_m, turn.turn_radius_m};
      }
    }
    keep(graph_.record_pass(from, to, pass, certified));
    return;
  }
  keep(graph_.record_pass(from, to, pass, swept_->finish_pass(from, to)));
  look_again();
}

// Of T_t's labels.
void CorridorWalk::relax(std::uint32_t edge) noexcept {
  through_.relax_edge(graph_, edge);
  if (turning_) {
    turning_->relax_edge(graph_, edge);
  }
}

void CorridorWalk::keep(const CorridorGraph::Recorded& recorded) noexcept {
  if (recorded.edge == kNone) {
    capacity_exceeded_ = true;
  }
  if (recorded.changed) {
    relax(recorded.edge);
    reached_.relax_edge(graph_, recorded.edge);
  }
}

}  // namespace tcert
