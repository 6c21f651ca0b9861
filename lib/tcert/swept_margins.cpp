#include <algorithm>
#include <limits>
#include <tcert/lengths.hpp>
#include <tcert/swept_margins.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Certified kNothingYet{kInfinity, {}, 0.0, 0.0};

std::size_t capacity(const CertificateParameters& parameters) {
  // A step in every dead band of travel, and as many joins.
  return 2 * (static_cast<std::size_t>(parameters.swept_lag_m / parameters.travel_deadband_m) + 3);
}

const Certified& smaller(const Certified& a, const Certified& b) noexcept {
  return b.margin_m < a.margin_m ? b : a;
}

}  // namespace

SweptMargins::SweptMargins(const Robot& robot,
                           const Course& course,
                           const CertificateParameters& parameters)
    : area_(robot, course, parameters),
      needed_width_m_(robot.body_width_m + 2.0 * robot.tracking_buffer_m),
      lag_m_(parameters.swept_lag_m),
      least_step_m_(parameters.travel_deadband_m),
      steps_(capacity(parameters)),
      passes_(capacity(parameters)) {}

void SweptMargins::begin(const Evidence& first) noexcept {
  first_step_ = next_step_ = tick_step_ = 0;
  first_pass_ = pass_count_ = 0;
  break_path(first);
}

void SweptMargins::break_path(const Evidence& now) noexcept {
  last_ = now.pose.position;
  Step here;
  here.from = here.to = last_;
  here.travel_m = now.travel_m;
  here.turn_slack_m = now.turn_slack_m;
  here.certified.narrowest = now.pose;
  here.certified.turn_radius_m = now.turn_radius_m;
  push(here);
  tick_step_ = next_step_ - 1;
  start_pass();
}

// A tick within the dead band of the last step's end is taken into that step.
void SweptMargins::add(const Evidence& now) noexcept {
  const Point from = last_;
  last_ = now.pose.position;
  Step& newest = step(tick_step_);
  const double off_m = distance(newest.to, last_);
  if (tick_step_ + 1 == next_step_ && !reaches(off_m, least_step_m_)) {
    newest.spread_m = std::max(newest.spread_m, off_m);
    if (now.turn_slack_m < newest.turn_slack_m) {
      newest.turn_slack_m = now.turn_slack_m;
      newest.certified.turn_radius_m = now.turn_radius_m;
    }
    newest.seen = false;
    newest.open = true;
    newest.certified.margin_m = -needed_width_m_;
    return;
  }
  Step next;
  next.from = from;
  next.to = last_;
  next.travel_m = now.travel_m;
  next.turn_slack_m = now.turn_slack_m;
  next.certified.narrowest = now.pose;
  next.certified.turn_radius_m = now.turn_radius_m;
  push(next);
  tick_step_ = next_step_ - 1;
}

void SweptMargins::add_join(Point crossing, const Evidence& now, const Node& node) noexcept {
  Step join;
  join.from = crossing;
  join.to = node.pose.position;
  join.travel_m = now.travel_m;
  join.turn_slack_m = now.turn_slack_m;
  join.certified.narrowest = {node.pose.position, now.pose.yaw_rad};
  join.certified.turn_radius_m = now.turn_radius_m;
  push(join);
}

void SweptMargins::start_pass() noexcept {
  current_ = {};
  current_.first = tick_step_;
  current_.settled = kNothingYet;
}

Certified SweptMargins::finish_pass(EdgeEnd from, EdgeEnd to) noexcept {
  if (pass_count_ == passes_.size()) {
    first_pass_ = (first_pass_ + 1) % passes_.size();
    --pass_count_;
  }
  FollowedPass pass = current_;
  pass.from = from;
  pass.to = to;
  pass.last = next_step_ - 1;
  const Certified now = margin_of(pass);
  pass.margin_m = now.margin_m;
  followed(pass_count_) = pass;
  ++pass_count_;
  return now;
}

void SweptMargins::push(const Step& next) noexcept {
  if (next_step_ - first_step_ == steps_.size()) {
    settle_oldest();
  }
  while (first_step_ < next_step_ && exceeds(next.travel_m - step(first_step_).travel_m, lag_m_)) {
    settle_oldest();
  }
  Step& pushed = step(next_step_);
  pushed = next;
  pushed.certified.margin_m = -needed_width_m_;
  ++next_step_;
}

// Its margin goes into the passes that it is part of.
void SweptMargins::settle_oldest() noexcept {
  Step& oldest = step(first_step_);
  look_at(oldest);
  if (current_.first <= first_step_) {
    current_.settled = smaller(current_.settled, oldest.certified);
  }
  for (std::size_t i = 0; i < pass_count_; ++i) {
    FollowedPass& pass = followed(i);
    if (pass.first <= first_step_ && first_step_ <= pass.last) {
      pass.settled = smaller(pass.settled, oldest.certified);
    }
  }
  ++first_step_;
}

void SweptMargins::forget_settled_passes() noexcept {
  while (pass_count_ > 0 && followed(0).last < first_step_) {
    first_pass_ = (first_pass_ + 1) % passes_.size();
    --pass_count_;
  }
}

void SweptMargins::look_at(Step& s) noexcept {
  if (s.seen && (!s.open || !area_.is_free(*s.clearance.nearest))) {
    return;
  }
  s.seen = true;
  s.clearance = area_.clearance(s.from, s.to);
  s.open = s.clearance.nearest.has_value();
  s.certified.width_m = 2.0 * (s.clearance.distance_m - s.spread_m);
  s.certified.margin_m = std::min(s.certified.width_m - needed_width_m_, s.turn_slack_m);
}

void SweptMargins::look_at_open_steps() noexcept {
  for (std::uint64_t n = first_step_; n < next_step_; ++n) {
    look_at(step(n));
  }
}

Certified SweptMargins::margin_of(const FollowedPass& pass) noexcept {
  Certified least = pass.settled;
  for (std::uint64_t n = std::max(pass.first, first_step_); n <= pass.last; ++n) {
    least = smaller(least, step(n).certified);
  }
  return least;
}

}  // namespace tcert
