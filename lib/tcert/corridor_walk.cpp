#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/corridor_walk.hpp>
#include <tcert/join.hpp>
#include <tcert/lengths.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

CorridorWalk::CorridorWalk(const Robot& robot,
                           const CertificateParameters& parameters,
                           SweptMargins* swept)
    : robot_(robot),
      parameters_(parameters),
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
double CorridorWalk::certificate_m() const noexcept {
  return turning_ ? std::max(through_.sink(), std::min(turning_->sink(), 0.0)) : through_.sink();
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

// The path crosses the line through the node, perpendicular to its heading, near the node and
// along its heading.
CorridorWalk::Crossing CorridorWalk::crossing_of(std::uint32_t node,
                                                 const Evidence& now) const noexcept {
  const auto& [at, heading, in_start, in_goal] = graph_.nodes()[node];
  const double before_m = dot(last_.pose.position - at.position, heading);
  const double after_m = dot(now.pose.position - at.position, heading);
  if ((before_m < 0.0) == (after_m < 0.0)) {
    return {};
  }
  const double share = before_m / (before_m - after_m);
  const Point step = now.pose.position - last_.pose.position;
  const Point off = last_.pose.position + share * step - at.position;
  const double distance2 = dot(off, off);
  // Within half a body of each other both passes cover what lies between them; further off the
  // body must fit in what was felt on that side, all along the pass.
  const double half_body_m = 0.5 * robot_.body_width_m;
  const double aside_m = -dot(off, {-now.heading.y_m, now.heading.x_m});
  const double felt_m = aside_m > 0.0 ? pending_.left_m() : pending_.right_m();
  const double reach_m =
      std::min(parameters_.merge_radius_m, std::max(half_body_m, felt_m - half_body_m));
  if (exceeds(std::sqrt(distance2), reach_m)) {
    return {};
  }
  const double turned = std::abs(angle_between(at.yaw_rad, now.pose.yaw_rad));
  const double off_axis = std::min(turned, std::numbers::pi - turned);
  if (exceeds(off_axis, parameters_.merge_angle_rad)) {
    return {};
  }
  const double curvature =
      join_curvature(std::sqrt(distance2), off_axis, parameters_.edge_length_m);
  return {node,
          before_m < 0.0 ? Side::back : Side::front,
          distance2,
          at.position + off,
          1.0 / (curvature + 1.0 / now.turn_radius_m)};
}

// Ablation A3 charges no turning.
CorridorWalk::Turn CorridorWalk::turn_at(const Crossing& crossing,
                                         const Evidence& now) const noexcept {
  if (parameters_.curvature == CurvatureReading::none) {
    return {};
  }
  const double sure_radius_m = 1.0 / (1.0 / crossing.turn_radius_m + robot_.curvature_buffer_per_m);
  return {sure_radius_m - robot_.min_turn_radius_m,
          crossing.turn_radius_m,
          {crossing.at, now.pose.yaw_rad}};
}

// Of the known nodes other than u, the nearest to where the path crosses it; ties: lowest index.
CorridorWalk::Crossing CorridorWalk::nearest_crossing(const Evidence& now) const noexcept {
  const Point a = last_.pose.position;
  const Point b = now.pose.position;
  const Point margin{parameters_.merge_radius_m, parameters_.merge_radius_m};
  const Point low = Point{std::min(a.x_m, b.x_m), std::min(a.y_m, b.y_m)} - margin;
  const Point high = Point{std::max(a.x_m, b.x_m), std::max(a.y_m, b.y_m)} + margin;
  Crossing nearest;
  graph_.for_each_node_near(low, high, [&](std::uint32_t node) noexcept {
    if (node == at_node_) {
      return;
    }
    const Crossing found = crossing_of(node, now);
    if (found.node == kNone) {
      return;
    }
    const bool nearer = nearest.node == kNone || found.distance2 < nearest.distance2 ||
                        (found.distance2 == nearest.distance2 && found.node < nearest.node);
    if (nearer) {
      nearest = found;
    }
  });
  return nearest;
}

// Closes the pending edge at the known node that the path crosses, or restarts it at u. Both ends
// of the crossing interval count in both edges.
bool CorridorWalk::cross(const Evidence& now) noexcept {
  const Crossing known = nearest_crossing(now);
  if (known.node != kNone) {
    const Turn changed = join(known, now);
    if (at_node_ != kNone) {
      record({known.node, known.entered}, pending_.finish(), changed);
    }
    leave(known.node, opposite(known.entered), now);
    restart_pass(last_, changed);
    pending_.add(now);
    return true;
  }
  if (at_node_ == kNone) {
    return false;
  }
  const Crossing own = crossing_of(at_node_, now);
  if (own.node == kNone) {
    return false;
  }
  const Turn changed = join(own, now);
  leave(own.node, opposite(own.entered), now);
  restart_pass(last_, changed);
  pending_.add(now);
  return true;
}

void CorridorWalk::restart_pass(const Evidence& first, const Turn& changed) noexcept {
  pending_.restart(first);
  changed_ = changed;
  if (swept_ != nullptr) {
    swept_->start_pass();
  }
}

// Between where the path crosses a node's line and the node itself the body must fit and turn too.
CorridorWalk::Turn CorridorWalk::join(const Crossing& crossing, const Evidence& now) noexcept {
  const Turn changed = turn_at(crossing, now);
  if (swept_ != nullptr) {
    Evidence between = now;
    between.turn_slack_m = changed.slack_m;
    if (changed.slack_m < kInfinity) {
      between.turn_radius_m = changed.turn_radius_m;
    }
    swept_->add_join(crossing.at, between, graph_.nodes()[crossing.node]);
  }
  return changed;
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
