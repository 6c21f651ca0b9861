#include <tcert/c_conversions.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tcert::c_interface {
namespace {

template <typename Struct>
void require_size(const Struct& given, const char* name) {
  if (!is_known_size<Struct>(given.struct_size)) {
    throw WrongSize(std::string(name) + ".struct_size is " + std::to_string(given.struct_size) +
                    "; this library knows sizes from " + std::to_string(kFirstSize<Struct>) +
                    " to " + std::to_string(sizeof(Struct)));
  }
}

void require(bool holds, const std::string& what) {
  if (!holds) {
    throw std::invalid_argument(what);
  }
}

/// Between a member of the C struct and one of ours, which have the same value.
template <typename From, typename To>
void assign(const From& from, To& to) noexcept {
  to = static_cast<To>(from);
}

// The members of the C struct are named by the keys of the lists. A word is looked at before it
// becomes an enumerator, which may be narrower.
#define TCERT_IN_WORD(type, member, key, value, words, text) \
  require_known(WordField{#key, words, text}, c.key);        \
  assign(c.key, known.member);
#define TCERT_IN_NUMBER(type, member, key, ...) assign(c.key, known.member);
#define TCERT_OUT(type, member, key, ...) assign(known.member, c.key);

void copy_in(const tcert_parameters& c, CertificateParameters& known) {
#define TCERT_WORD TCERT_IN_WORD
#define TCERT_NUMBER TCERT_IN_NUMBER
#include <tcert/parameters/certificate.def>
}
void copy_in(const tcert_parameters& c, SpeedLaw& known) {
#define TCERT_WORD TCERT_IN_WORD
#define TCERT_NUMBER TCERT_IN_NUMBER
#include <tcert/parameters/speed_law.def>
}
void copy_in(const tcert_parameters& c, GuardParameters& known) {
#define TCERT_WORD TCERT_IN_WORD
#define TCERT_NUMBER TCERT_IN_NUMBER
#include <tcert/parameters/guards.def>
}
void copy_out(const CertificateParameters& known, tcert_parameters& c) noexcept {
#define TCERT_WORD TCERT_OUT
#define TCERT_NUMBER TCERT_OUT
#include <tcert/parameters/certificate.def>
}
void copy_out(const SpeedLaw& known, tcert_parameters& c) noexcept {
#define TCERT_WORD TCERT_OUT
#define TCERT_NUMBER TCERT_OUT
#include <tcert/parameters/speed_law.def>
}
void copy_out(const GuardParameters& known, tcert_parameters& c) noexcept {
#define TCERT_WORD TCERT_OUT
#define TCERT_NUMBER TCERT_OUT
#include <tcert/parameters/guards.def>
}
void copy_in(const tcert_parameters& c, RiskParameters& known) {
#define TCERT_WORD TCERT_IN_WORD
#define TCERT_NUMBER TCERT_IN_NUMBER
#include <tcert/parameters/risk.def>
}
void copy_in(const tcert_parameters& c, FallbackParameters& known) {
#define TCERT_NUMBER TCERT_IN_NUMBER
#include <tcert/parameters/fallback.def>
}
void copy_out(const RiskParameters& known, tcert_parameters& c) noexcept {
#define TCERT_WORD TCERT_OUT
#define TCERT_NUMBER TCERT_OUT
#include <tcert/parameters/risk.def>
}
void copy_out(const FallbackParameters& known, tcert_parameters& c) noexcept {
#define TCERT_NUMBER TCERT_OUT
#include <tcert/parameters/fallback.def>
}

template <typename Group>
Group known_from(const tcert_parameters& c) {
  Group known;
  copy_in(c, known);
  return known;
}

void require_word(const char* name, std::int32_t value, std::int32_t last) {
  require(value >= 0 && value <= last,
          std::string(name) + " is " + std::to_string(value) + "; it must be from 0 to " +
              std::to_string(last));
}

std::vector<double> list(const double* values, std::size_t count, const std::string& name) {
  require(values != nullptr || count == 0, name + " is null");
  return {values, values + count};
}

Ray to_ray(const tcert_ray& c) {
  Ray ray;
  ray.name = c.name != nullptr ? c.name : "";
  require_word("ray kind", c.kind, TCERT_RANGE);
  ray.mount = {c.mount.x_m, c.mount.y_m};
  ray.bearing_rad = c.bearing_rad;
  ray.reach_m = c.reach_m;
  ray.kind = static_cast<RayKind>(c.kind);
  if (ray.kind == RayKind::bend) {
    ray.calibration = {list(c.bend_rad, c.knots, "ray '" + ray.name + "': bend_rad"),
                       list(c.clearance_m, c.knots, "ray '" + ray.name + "': clearance_m")};
  }
  return ray;
}

std::optional<Region> to_region(const tcert_region& c, const std::string& name) {
  require_word((name + ".kind").c_str(), c.kind, TCERT_POLYGON);
  if (c.kind == TCERT_NONE) {
    return std::nullopt;
  }
  if (c.kind == TCERT_DISC) {
    return Disc{{c.centre.x_m, c.centre.y_m}, c.radius_m};
  }
  require(c.vertices != nullptr || c.vertex_count == 0, name + ".vertices is null");
  Polygon polygon;
  for (std::uint32_t i = 0; i < c.vertex_count; ++i) {
    polygon.vertices.push_back({c.vertices[i].x_m, c.vertices[i].y_m});
  }
  return polygon;
}

TrackingErrorTable to_table(const tcert_parameters& c) {
  if (c.tracking_radius_m == nullptr) {
    return TrackingErrorTable();
  }
  const std::size_t cells = std::size_t{c.tracking_speeds} * c.tracking_accelerations *
                            std::size_t{c.tracking_disturbances};
  TrackingErrorGrid grid{
      list(c.tracking_speed_mps, c.tracking_speeds, "tracking_speed_mps"),
      {},
      list(c.tracking_disturbance, c.tracking_disturbances, "tracking_disturbance"),
      list(c.tracking_radius_m, cells, "tracking_radius_m")};
  if (c.tracking_speed_left_mps != nullptr) {
    grid.speed_left_mps =
        list(c.tracking_speed_left_mps, c.tracking_accelerations, "tracking_speed_left_mps");
    grid.hold_s = list(c.tracking_hold_s, c.tracking_accelerations, "tracking_hold_s");
  } else {
    grid.acceleration_mps2 =
        list(c.tracking_acceleration_mps2, c.tracking_accelerations, "tracking_acceleration_mps2");
  }
  return TrackingErrorTable(std::move(grid));
}

}  // namespace

tcert_parameters default_parameters() noexcept {
  tcert_parameters c{};
  c.struct_size = sizeof c;
  copy_out(CertificateParameters{}, c);
  copy_out(SpeedLaw{}, c);
  copy_out(GuardParameters{}, c);
  copy_out(RiskParameters{}, c);
  copy_out(FallbackParameters{}, c);
  return c;
}

tcert_parameters whole_parameters(const tcert_parameters& given) {
  require_size(given, "parameters");
  const tcert_parameters whole = completed(given, default_parameters());
  require(whole.reserved == 0 && whole.reserved_1 == 0 && whole.reserved_2 == 0 &&
              whole.reserved_3 == 0,
          "a reserved member of the parameters is not 0; tcert_parameters_init sets all of them");
  return whole;
}

Robot to_robot(const tcert_robot& given) {
  require_size(given, "robot");
  const tcert_robot c = completed(given);
  Robot robot;
  robot.body_width_m = c.body_width_m;
  robot.min_turn_radius_m = c.min_turn_radius_m;
  robot.tracking_buffer_m = c.tracking_buffer_m;
  robot.curvature_buffer_per_m = c.curvature_buffer_per_m;
  require(c.rays != nullptr || c.ray_count == 0, "robot.rays is null");
  for (std::uint32_t k = 0; k < c.ray_count; ++k) {
    robot.rays.push_back(to_ray(c.rays[k]));
  }
  return robot;
}

Course to_course(const tcert_course& given) {
  require_size(given, "course");
  const tcert_course c = completed(given);
  require(c.reserved == 0, "course.reserved is not 0");
  return {to_region(c.start, "start"), to_region(c.goal, "goal")};
}

CertificateParameters to_certificate_parameters(const tcert_parameters& whole) {
  return known_from<CertificateParameters>(whole);
}

ActionSetup to_actions(const tcert_parameters& whole, const Robot& robot) {
  require_word("keep_risk", whole.keep_risk, 1);
  ActionSetup setup{{robot,
                     to_certificate_parameters(whole),
                     known_from<SpeedLaw>(whole),
                     known_from<GuardParameters>(whole),
                     to_table(whole)},
                    std::nullopt,
                    whole.rules != nullptr ? parse_rules(whole.rules) : std::vector<Rule>{},
                    known_from<FallbackParameters>(whole)};
  if (whole.keep_risk != 0) {
    setup.risk = known_from<RiskParameters>(whole);
  }
  return setup;
}

tcert_output to_output(const RuntimeTick& tick) noexcept {
  const CertifiedTick& certified = tick.certified;
  const GuardedTick& guarded = tick.acted.guarded;
  tcert_output out{};
  out.struct_size = sizeof out;
  out.flags = certified.flags;
  out.time_ns = certified.time_ns;
  out.travel_m = certified.travel_m;
  out.left_m = certified.left_m;
  out.right_m = certified.right_m;
  out.width_m = certified.width_m;
  out.turn_radius_m = certified.turn_radius_m;
  out.margin_m = certified.margin_m;
  out.edge_margin_m = certified.edge_margin_m;
  out.memory = certified.memory;
  out.corridor_value_m = certified.corridor_value_m;
  out.certificate_m = certified.certificate_m;
  out.series_m = series_value(certified);
  out.contacts = certified.contacts;
  out.new_contacts = certified.new_contacts;
  out.nodes = certified.nodes;
  out.edges = certified.edges;
  out.labels_raised = certified.labels_raised;
  out.issued = certified.issued ? 1U : 0U;
  out.tracking_error_m = guarded.tracking_error_m;
  out.robust_margin_m = guarded.robust_margin_m;
  out.force_n = guarded.force_n;
  out.force_limit_n = guarded.force_limit_n;
  out.speed_mps = guarded.speed_mps;
  out.retreat_speed_mps = guarded.retreat_speed_mps;
  out.triggers = guarded.triggers;
  out.triggers_began = guarded.began;
  out.yaw_rate_rps = guarded.yaw_rate_rps;
  out.risk_ahead = tick.acted.risk_ahead;
  out.alarms = tick.acted.alarms;
  out.alarms_began = tick.acted.alarms_began;
  out.footing_slack_m = certified.footing_slack_m;
  out.valid_for_s = certified.valid_for_s;
  return out;
}

}  // namespace tcert::c_interface
