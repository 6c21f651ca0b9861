#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tcert/certifier.hpp>
#include <tcert/contact_memory.hpp>
#include <tcert/corridor_walk.hpp>
#include <tcert/footing.hpp>
#include <tcert/lengths.hpp>
#include <tcert/proxies.hpp>
#include <tcert/swept_margins.hpp>
#include <utility>
#include <vector>

namespace tcert {
namespace {

constexpr double kNoPath = -std::numeric_limits<double>::infinity();

// NaN is not within it either.
bool is_usable(const Pose& pose) noexcept {
  return std::abs(pose.position.x_m) <= kLargestPose &&
         std::abs(pose.position.y_m) <= kLargestPose && std::abs(pose.yaw_rad) <= kLargestPose;
}

bool lies_in(const std::optional<Region>& region, Point p) noexcept {
  return region.has_value() && contains(*region, p);
}

bool lies_in(const Disc& disc, Point p) noexcept {
  const Point off = p - disc.centre;
  return dot(off, off) <= disc.radius_m * disc.radius_m;
}

}  // namespace

struct Certifier::State {
  State(const Robot& r, Course c, const CertificateParameters& p)
      : robot(r),
        course(std::move(c)),
        parameters(p),
        proxies(r, p),
        memory(p),
        swept(p.clearance == ClearanceReading::swept
                  ? std::make_optional<SweptMargins>(r, course, p)
                  : std::nullopt),
        walk(r, p, swept ? &*swept : nullptr),
        ray_margins(r.rays.size(), kMissing) {}

  [[nodiscard]] double needed_width_m() const noexcept {
    return robot.body_width_m + 2.0 * robot.tracking_buffer_m;
  }
  [[nodiscard]] bool is_optimistic() const noexcept {
    return parameters.unknown == UnknownSpace::free;
  }
  [[nodiscard]] bool accepts(const Tick& tick) const noexcept;
  void age(const Tick& tick) noexcept;
  CertifiedTick refuse(const Tick& tick) noexcept;
  [[nodiscard]] CertifiedTick unchanged(const Tick& tick, std::uint32_t flag) const noexcept;
  void certify(const Tick& tick) noexcept;
  void count_travel(Point position, bool broken) noexcept;
  Evidence weigh(const Tick& tick) noexcept;
  double underfoot(const Tick& tick) noexcept;
  [[nodiscard]] double certificate_m() const noexcept;
  void state_values(CertifiedTick& tick) const noexcept;

  Robot robot;
  Course course;
  Disc first_node;  // stands for S if the course has none
  CertificateParameters parameters;
  Proxies proxies;
  ContactMemory memory;
  std::optional<SweptMargins> swept;
  CorridorWalk walk;
  std::vector<double> ray_margins;

  bool began = false;
  bool has_time = false;
  bool gap_before_next = false;
  std::int64_t first_ns = 0;
  std::int64_t last_ns = 0;
  Point last_position;
  Point counted_position;
  double travel_m = 0.0;
  double since_start_m = 0.0;
  Footing footing;
  Footing unseen_footing;  // the worst since the last tick that was evidence
  std::uint32_t lasting_flags = 0;
  CertifiedTick out;
};

bool Certifier::State::accepts(const Tick& tick) const noexcept {
  return is_usable(tick.pose) && tick.rays.size() == robot.rays.size() &&
         (!has_time || tick.time_ns > last_ns);
}

// A tick that is no evidence: what was known stays known.
CertifiedTick Certifier::State::unchanged(const Tick& tick, std::uint32_t flag) const noexcept {
  CertifiedTick same = out;
  same.time_ns = tick.time_ns;
  same.left_m = same.right_m = same.width_m = same.turn_radius_m = kMissing;
  same.margin_m = same.footing_slack_m = kMissing;
  same.contacts = same.new_contacts = same.labels_raised = 0;
  same.flags = lasting_flags | flag;
  return same;
}

// Time goes on without evidence, too: where obstacles move what was known is worth less.
void Certifier::State::age(const Tick& tick) noexcept {
  if (began && parameters.obstacle_speed_mps > 0.0) {
    since_start_m = 2.0 * parameters.obstacle_speed_mps * elapsed_s(first_ns, tick.time_ns);
    state_values(out);
  }
}

// Nobody knows whether its time is right, so only what is said of this tick is of that time.
CertifiedTick Certifier::State::refuse(const Tick& tick) noexcept {
  const CertifiedTick known = out;
  const double known_m = since_start_m;
  if (tick.time_ns > last_ns) {
    age(tick);
  }
  const CertifiedTick aged = unchanged(tick, flag_bad_input);
  out = known;
  since_start_m = known_m;
  return aged;
}

// Travel counts only past the dead band, so that pose noise at a standstill is no travel.
// The jump of a break is none either.
void Certifier::State::count_travel(Point position, bool broken) noexcept {
  const double step_m = distance(counted_position, position);
  if (!broken && !reaches(step_m, parameters.travel_deadband_m)) {
    return;
  }
  travel_m += broken ? 0.0 : step_m;
  counted_position = position;
}

Evidence Certifier::State::weigh(const Tick& tick) noexcept {
  const Point position = tick.pose.position;
  const double time_s = elapsed_s(first_ns, tick.time_ns);
  const bool in_start =
      course.start.has_value() ? lies_in(course.start, position) : lies_in(first_node, position);
  const LocalGeometry local = proxies.update(tick, travel_m, time_s, in_start, memory);
  const double sure_radius_m = 1.0 / (1.0 / local.turn_radius_m + robot.curvature_buffer_per_m);
  double turn_slack_m = sure_radius_m - robot.min_turn_radius_m;
  if (parameters.footing == FootingReading::felt) {
    turn_slack_m = std::min(turn_slack_m, underfoot(tick));
  }

  out.left_m = local.left_m;
  out.right_m = local.right_m;
  out.width_m = local.width_m;
  out.turn_radius_m = local.turn_radius_m;
  out.margin_m = std::min(local.width_m - needed_width_m(), turn_slack_m);
  out.contacts = local.contacts;
  out.new_contacts = local.new_contacts;
  out.flags |= local.missing_ray ? flag_missing_ray : 0U;
  out.flags |= local.across_heading ? flag_across_heading : 0U;
  out.memory = memory.largest_within(position, 0.5 * robot.body_width_m, time_s);
  for (std::size_t k = 0; k < ray_margins.size(); ++k) {
    const double clearance_m = proxies.clearances()[k];
    ray_margins[k] = std::isnan(clearance_m)
                         ? kMissing
                         : std::min(clearance_m - robot.body_width_m, turn_slack_m);
  }
  return {tick.pose,
          direction(tick.pose.yaw_rad),
          travel_m,
          out.margin_m + since_start_m,
          local.left_m,
          local.right_m,
          local.width_m,
          local.turn_radius_m,
          parameters.memory_weight_m * out.memory,
          in_start,
          lies_in(course.goal, position),
          turn_slack_m,
          since_start_m};
}

// Slope, step and slip where the robot stands, as metres.
double Certifier::State::underfoot(const Tick& tick) noexcept {
  keep_known(tick.footing, footing);
  // A step that was felt while another stream was silent lies on the way to here, too.
  Footing worst = footing;
  keep_worst(unseen_footing, worst);
  unseen_footing = {};
  const double scale_m = parameters.footing_scale_m > 0.0 ? parameters.footing_scale_m
                                                          : proxies.widest_m() - needed_width_m();
  const double slack_m = footing_slack(worst, parameters, scale_m);
  out.footing_slack_m = slack_m < std::numeric_limits<double>::infinity() ? slack_m : kMissing;
  return slack_m;
}

// Ablation A2 credits what lies ahead of the last node with the reach of the rays.
double Certifier::State::certificate_m() const noexcept {
  if (!is_optimistic()) {
    return walk.certificate_m(since_start_m) - since_start_m;
  }
  const double ahead_m = proxies.reach_width_m() - needed_width_m();
  return std::max(walk.certificate_m(since_start_m) - since_start_m,
                  std::min(walk.reached_m() - since_start_m, ahead_m));
}

// What is known holds now, and for so long.
void Certifier::State::state_values(CertifiedTick& tick) const noexcept {
  tick.edge_margin_m = walk.edge_margin_m() - since_start_m;
  tick.corridor_value_m = walk.corridor_value_m() - since_start_m;
  tick.certificate_m = certificate_m();
  tick.valid_for_s = parameters.obstacle_speed_mps > 0.0 && tick.certificate_m > 0.0
                         ? tick.certificate_m / (2.0 * parameters.obstacle_speed_mps)
                         : kMissing;
}

void Certifier::State::certify(const Tick& tick) noexcept {
  const Point position = tick.pose.position;
  const bool broken = began && (gap_before_next ||
                                exceeds(distance(last_position, position), parameters.max_step_m));
  out.flags = 0;
  if (!began) {
    first_ns = tick.time_ns;
    counted_position = position;
    first_node = {position, 0.5 * robot.body_width_m};
  } else {
    count_travel(position, broken);
  }
  since_start_m = 2.0 * parameters.obstacle_speed_mps * elapsed_s(first_ns, tick.time_ns);
  if (broken) {
    out.flags |= flag_break;
    proxies.restart_windows();
  }
  const Evidence evidence = weigh(tick);
  const std::uint64_t raised_before = walk.labels_raised();
  if (swept) {
    if (!began) {
      swept->area().begin(tick.pose);
    } else if (broken) {
      swept->area().break_path();
    }
    swept->area().sweep(tick.pose, proxies.clearances(), proxies.bearings());
  }
  if (!began) {
    lasting_flags |= evidence.in_start ? 0U : flag_start_outside;
    walk.begin(evidence, !evidence.in_start);
    began = true;
  } else if (broken) {
    const double bridge_m = is_optimistic() ? proxies.reach_width_m() - needed_width_m() : kNoPath;
    walk.advance_after_break(evidence, bridge_m + since_start_m);
  } else {
    walk.advance(evidence);
  }
  gap_before_next = false;
  last_position = position;

  const bool exceeded = walk.capacity_exceeded() || (swept && swept->area().full());
  lasting_flags |= exceeded ? flag_capacity_exceeded : 0U;
  lasting_flags |= memory.evicted() ? flag_memory_evicted : 0U;
  lasting_flags |= evidence.in_goal ? flag_goal_reached : 0U;
  out.flags |= lasting_flags;
  out.time_ns = tick.time_ns;
  out.travel_m = travel_m;
  state_values(out);
  out.nodes = static_cast<std::uint32_t>(walk.graph().nodes().size());
  out.edges = static_cast<std::uint32_t>(walk.graph().edges().size());
  out.labels_raised = static_cast<std::uint32_t>(walk.labels_raised() - raised_before);
  out.issued = out.issued || out.certificate_m > 0.0;
}

Certifier::Certifier(const Robot& robot,
                     const Course& course,
                     const CertificateParameters& parameters) {
  validate(robot, parameters);
  validate(course);
  if (parameters.clearance == ClearanceReading::witness) {
    throw std::invalid_argument(
        "clearance: found witness, which is looked for at the end of a trial, by 'certify'; from "
        "tick to tick take width, radial or swept");
  }
  state_ = std::make_unique<State>(robot, course, parameters);
  reset();
}

Certifier::~Certifier() = default;
Certifier::Certifier(Certifier&&) noexcept = default;
Certifier& Certifier::operator=(Certifier&&) noexcept = default;

CertifiedTick Certifier::update(const Tick& tick) noexcept {
  State& state = *state_;
  state.gap_before_next = state.gap_before_next || tick.segment_start;
  if (!state.accepts(tick)) {
    return state.refuse(tick);
  }
  state.has_time = true;
  state.last_ns = tick.time_ns;
  if (tick.stale) {
    state.age(tick);
    keep_worst(tick.footing, state.unseen_footing);
    keep_known(tick.footing, state.footing);
    return state.unchanged(tick, flag_stale);
  }
  state.certify(tick);
  return state.out;
}

std::span<const double> Certifier::ray_margins() const noexcept { return state_->ray_margins; }

const CorridorGraph& Certifier::graph() const noexcept { return state_->walk.graph(); }

double Certifier::since_start_m() const noexcept { return state_->since_start_m; }

std::uint32_t Certifier::last_node() const noexcept { return state_->walk.last_node(); }

std::optional<Bottleneck> Certifier::bottleneck() const noexcept {
  return bottleneck_of(state_->walk, state_->since_start_m);
}

void Certifier::reset() noexcept {
  State& state = *state_;
  state.proxies.clear();
  state.memory.clear();
  state.walk.clear();
  std::fill(state.ray_margins.begin(), state.ray_margins.end(), kMissing);
  state.began = state.has_time = state.gap_before_next = false;
  state.travel_m = 0.0;
  state.since_start_m = 0.0;
  state.footing = state.unseen_footing = {};
  state.lasting_flags = 0;
  state.out = {};
  state.out.certificate_m = kNoPath;
  state.out.corridor_value_m = kNoPath;
}

double series_value(const CertifiedTick& tick) noexcept {
  return tick.certificate_m > kNoPath ? tick.certificate_m : tick.corridor_value_m;
}

}  // namespace tcert
