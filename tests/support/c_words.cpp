#include "support/c_words.hpp"

namespace tcert::test_support {

CSetup::CSetup(const Robot& from, const Course& of) {
  for (const Ray& ray : from.rays) {
    rays.push_back({ray.name.c_str(),
                    {ray.mount.x_m, ray.mount.y_m},
                    ray.bearing_rad,
                    ray.reach_m,
                    ray.kind == RayKind::bend ? TCERT_BEND : TCERT_RANGE,
                    static_cast<std::uint32_t>(ray.calibration.bend_rad.size()),
                    ray.calibration.bend_rad.data(),
                    ray.calibration.clearance_m.data()});
  }
  robot = {sizeof robot,
           static_cast<std::uint32_t>(rays.size()),
           rays.data(),
           from.body_width_m,
           from.min_turn_radius_m,
           from.tracking_buffer_m,
           from.curvature_buffer_per_m};
  course.struct_size = sizeof course;
  if (of.start) {
    course.start = to_c(*of.start);
  }
  if (of.goal) {
    course.goal = to_c(*of.goal);
  }
  static_cast<void>(tcert_parameters_init(&parameters));
}

tcert_region CSetup::to_c(const Region& region) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return {TCERT_DISC, 0, {disc->centre.x_m, disc->centre.y_m}, disc->radius_m, nullptr};
  }
  std::vector<tcert_point>& points = polygons_.emplace_back();
  for (const Point& p : std::get<Polygon>(region).vertices) {
    points.push_back({p.x_m, p.y_m});
  }
  return {TCERT_POLYGON, static_cast<std::uint32_t>(points.size()), {}, 0.0, points.data()};
}

tcert_status CSetup::create(tcert_certifier*& certifier) {
  return tcert_create(&robot, &course, &parameters, &certifier, message.data(), message.size());
}

tcert_tick to_c(const Tick& tick, std::vector<tcert_reading>& readings) {
  readings.clear();
  for (const RayReading& reading : tick.rays) {
    readings.push_back({reading.value, reading.fsr_n});
  }
  return {sizeof(tcert_tick),
          static_cast<std::uint32_t>(readings.size()),
          readings.data(),
          tick.time_ns,
          tick.pose.position.x_m,
          tick.pose.position.y_m,
          tick.pose.yaw_rad,
          tick.stale ? 1 : 0,
          tick.segment_start ? 1 : 0,
          nullptr,
          tick.footing.pitch_rad,
          tick.footing.roll_rad,
          tick.footing.step_m,
          tick.footing.slip};
}

tcert_output empty_output() noexcept {
  tcert_output out{};
  out.struct_size = sizeof out;
  return out;
}

CertifiedTick certified(const tcert_output& c) noexcept {
  CertifiedTick tick;
  tick.time_ns = c.time_ns;
  tick.travel_m = c.travel_m;
  tick.left_m = c.left_m;
  tick.right_m = c.right_m;
  tick.width_m = c.width_m;
  tick.turn_radius_m = c.turn_radius_m;
  tick.margin_m = c.margin_m;
  tick.edge_margin_m = c.edge_margin_m;
  tick.memory = c.memory;
  tick.corridor_value_m = c.corridor_value_m;
  tick.certificate_m = c.certificate_m;
  tick.contacts = c.contacts;
  tick.new_contacts = c.new_contacts;
  tick.nodes = c.nodes;
  tick.edges = c.edges;
  tick.labels_raised = c.labels_raised;
  tick.flags = c.flags;
  tick.issued = c.issued != 0;
  return tick;
}

GuardedTick guarded(const tcert_output& c) noexcept {
  GuardedTick tick;
  tick.tracking_error_m = c.tracking_error_m;
  tick.robust_margin_m = c.robust_margin_m;
  tick.force_n = c.force_n;
  tick.force_limit_n = c.force_limit_n;
  tick.speed_mps = c.speed_mps;
  tick.retreat_speed_mps = c.retreat_speed_mps;
  tick.triggers = c.triggers;
  tick.began = c.triggers_began;
  return tick;
}

}  // namespace tcert::test_support
