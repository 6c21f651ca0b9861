#include <tcert/tcert.h>
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/flag_word.hpp>
#include <tcert/guards.hpp>
#include <tcert/struct_size.hpp>
#include <vector>

struct tcert_certifier {
  tcert::Certifier certifier;
  tcert::Guards guards;
  std::vector<tcert::RayReading> readings;  // one more than rays, so that a wrong number shows
};

namespace tcert {

// The last members of ABI version 1. What comes later is appended behind them.
#define TCERT_FIRST_SIZE(type, last) \
  template <>                        \
  inline constexpr std::size_t kFirstSize<type> = offsetof(type, last) + sizeof(type::last)
TCERT_FIRST_SIZE(tcert_robot, curvature_buffer_per_m);
TCERT_FIRST_SIZE(tcert_course, goal);
TCERT_FIRST_SIZE(tcert_parameters, tracking_radius_m);
TCERT_FIRST_SIZE(tcert_tick, segment_start);
TCERT_FIRST_SIZE(tcert_output, triggers_began);
TCERT_FIRST_SIZE(tcert_bottleneck, turn_radius_m);

namespace {

class WrongSize : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

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

template <typename Group>
Group known_from(const tcert_parameters& c) {
  Group known;
  copy_in(c, known);
  return known;
}

tcert_parameters defaults() noexcept {
  tcert_parameters c{};
  c.struct_size = sizeof c;
  copy_out(CertificateParameters{}, c);
  copy_out(SpeedLaw{}, c);
  copy_out(GuardParameters{}, c);
  return c;
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

Course to_course(const tcert_course& given) {
  require_size(given, "course");
  const tcert_course c = completed(given);
  require(c.reserved == 0, "course.reserved is not 0");
  return {to_region(c.start, "start"), to_region(c.goal, "goal")};
}

TrackingErrorTable to_table(const tcert_parameters& c) {
  if (c.tracking_radius_m == nullptr) {
    return TrackingErrorTable();
  }
  const std::size_t cells = std::size_t{c.tracking_speeds} * c.tracking_accelerations *
                            std::size_t{c.tracking_disturbances};
  return TrackingErrorTable(
      {list(c.tracking_speed_mps, c.tracking_speeds, "tracking_speed_mps"),
       list(c.tracking_acceleration_mps2, c.tracking_accelerations, "tracking_acceleration_mps2"),
       list(c.tracking_disturbance, c.tracking_disturbances, "tracking_disturbance"),
       list(c.tracking_radius_m, cells, "tracking_radius_m")});
}

Guards to_guards(const tcert_parameters& c) {
  return {known_from<SpeedLaw>(c), known_from<GuardParameters>(c), to_table(c)};
}

void say(char* message, std::size_t size, const char* text) noexcept {
  if (message == nullptr || size == 0) {
    return;
  }
  const std::size_t length = std::min(std::strlen(text), size - 1);
  std::memcpy(message, text, length);
  message[length] = '\0';
}

tcert_output to_output(const CertifiedTick& certified, const GuardedTick& guarded) noexcept {
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
  return out;
}

}  // namespace
}  // namespace tcert

using namespace tcert;

std::uint32_t tcert_abi_version(void) noexcept { return TCERT_ABI_VERSION; }

const char* tcert_version(void) noexcept { return TCERT_VERSION; }

const char* tcert_status_text(tcert_status status) noexcept {
  switch (status) {
    case TCERT_OK:
      return "done";
    case TCERT_ERROR_ARGUMENT:
      return "a null pointer where there must be none";
    case TCERT_ERROR_VERSION:
      return "a struct_size that is not set, or of a header that is newer than the library";
    case TCERT_ERROR_PARAMETER:
      return "robot, course or parameters out of range";
    case TCERT_ERROR_MEMORY:
      return "not enough memory";
    case TCERT_ERROR_INTERNAL:
      return "internal error";
  }
  return "unknown status";
}

const char* tcert_flag_text(std::uint32_t flag) noexcept { return flag_word(flag); }

tcert_status tcert_parameters_init_sized(tcert_parameters* parameters,
                                         std::uint32_t struct_size) noexcept {
  if (parameters == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_parameters>(struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  parameters->struct_size = struct_size;
  give(defaults(), *parameters);
  return TCERT_OK;
}

tcert_status tcert_create(const tcert_robot* robot,
                          const tcert_course* course,
                          const tcert_parameters* parameters,
                          tcert_certifier** certifier,
                          char* message,
                          std::size_t message_size) noexcept {
  if (certifier != nullptr) {
    *certifier = nullptr;
  }
  if (robot == nullptr || course == nullptr || parameters == nullptr || certifier == nullptr) {
    say(message, message_size, tcert_status_text(TCERT_ERROR_ARGUMENT));
    return TCERT_ERROR_ARGUMENT;
  }
  tcert_status status = TCERT_ERROR_INTERNAL;
  try {
    require_size(*parameters, "parameters");
    const tcert_parameters all = completed(*parameters, defaults());
    require(all.reserved == 0 && all.reserved_1 == 0 && all.reserved_2 == 0,
            "a reserved member of the parameters is not 0; tcert_parameters_init sets all of them");
    const Robot known = to_robot(*robot);
    *certifier = new tcert_certifier{
        Certifier(known, to_course(*course), known_from<CertificateParameters>(all)),
        to_guards(all),
        std::vector<RayReading>(known.rays.size() + 1)};
    say(message, message_size, "");
    return TCERT_OK;
  } catch (const WrongSize& error) {
    status = TCERT_ERROR_VERSION;
    say(message, message_size, error.what());
  } catch (const std::invalid_argument& error) {
    status = TCERT_ERROR_PARAMETER;
    say(message, message_size, error.what());
  } catch (const std::bad_alloc&) {
    status = TCERT_ERROR_MEMORY;
    say(message, message_size, tcert_status_text(status));
  } catch (const std::exception& error) {
    say(message, message_size, error.what());
  } catch (...) {
    say(message, message_size, tcert_status_text(status));
  }
  return status;
}

tcert_status tcert_update(tcert_certifier* certifier,
                          const tcert_tick* tick,
                          tcert_output* output) noexcept {
  if (certifier == nullptr || tick == nullptr || output == nullptr ||
      (tick->readings == nullptr && tick->reading_count > 0)) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_tick>(tick->struct_size) ||
      !is_known_size<tcert_output>(output->struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  const tcert_tick whole = completed(*tick);
  std::vector<RayReading>& readings = certifier->readings;
  const std::size_t count = std::min<std::size_t>(whole.reading_count, readings.size());
  for (std::size_t k = 0; k < count; ++k) {
    readings[k] = {whole.readings[k].value, whole.readings[k].force_n};
  }
  const Tick felt{whole.time_ns,
                  {{whole.x_m, whole.y_m}, whole.yaw_rad},
                  std::span(readings).first(count),
                  whole.stale != 0,
                  whole.segment_start != 0};
  const CertifiedTick certified = certifier->certifier.update(felt);
  give(to_output(certified, certifier->guards.update(felt, certified)), *output);
  return TCERT_OK;
}

tcert_status tcert_ray_margins(const tcert_certifier* certifier,
                               double* margins_m,
                               std::uint32_t count) noexcept {
  if (certifier == nullptr || (margins_m == nullptr && count > 0)) {
    return TCERT_ERROR_ARGUMENT;
  }
  const auto known = certifier->certifier.ray_margins();
  for (std::size_t k = 0; k < count; ++k) {
    margins_m[k] = k < known.size() ? known[k] : kMissing;
  }
  return TCERT_OK;
}

tcert_status tcert_find_bottleneck(const tcert_certifier* certifier,
                                   tcert_bottleneck* bottleneck,
                                   std::int32_t* found) noexcept {
  if (certifier == nullptr || bottleneck == nullptr || found == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_bottleneck>(bottleneck->struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  const auto narrowest = certifier->certifier.bottleneck();
  *found = narrowest ? 1 : 0;
  if (narrowest) {
    const tcert_bottleneck whole{sizeof whole,
                                 narrowest->edge,
                                 narrowest->pose.position.x_m,
                                 narrowest->pose.position.y_m,
                                 narrowest->pose.yaw_rad,
                                 narrowest->margin_m,
                                 narrowest->width_m,
                                 narrowest->turn_radius_m};
    give(whole, *bottleneck);
  }
  return TCERT_OK;
}

tcert_status tcert_reset(tcert_certifier* certifier) noexcept {
  if (certifier == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  certifier->certifier.reset();
  certifier->guards.reset();
  return TCERT_OK;
}

void tcert_destroy(tcert_certifier* certifier) noexcept { delete certifier; }
