#include <stdexcept>
#include <string>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>

namespace tcert {
namespace {

/// Entries of a queue over travel: one for each dead band of the window.
constexpr double kMostDeadbands = 1e5;
/// Cells of memory along the reach of a contact, and along the body: the square of it is looked at
/// in every tick.
constexpr double kMostSigmaCells = 32.0;
constexpr double kMostBodyCells = 256.0;
/// Cells of the swept area along a ray and the body, and along what two readings may sweep.
constexpr double kMostReachCells = 5000.0;
constexpr double kMostObstacleCells = 500.0;

/// `larger` of at most `most` times `smaller`.
void require_ratio(
    const char* larger_name, double larger, const char* smaller_name, double smaller, double most) {
  if (!(larger <= most * smaller)) {
    throw std::invalid_argument(std::string(larger_name) + " is " + to_text(larger) +
                                "; it must be at most " + std::to_string(static_cast<long>(most)) +
                                " times " + smaller_name + ", which is " + to_text(smaller));
  }
}

/// Of two lengths of which the first has to fit into the second: what is never reached would
/// switch a constraint off.
void require_fits(const char* name, double length, const char* window_name, double window) {
  if (!(length <= window)) {
    throw std::invalid_argument(std::string(name) + " is " + to_text(length) +
                                "; it must be at most " + window_name + ", which is " +
                                to_text(window));
  }
}

}  // namespace

void validate(const CertificateParameters& p) {
  require_fields(p);
  if (p.contact_off_n > p.contact_on_n) {
    throw std::invalid_argument("contact_off_n must not be above contact_on_n");
  }
  if (p.obstacle_speed_mps > 0.0 &&
      (p.clearance == ClearanceReading::swept || p.clearance == ClearanceReading::witness)) {
    throw std::invalid_argument(
        "obstacle_speed_mps is " + to_text(p.obstacle_speed_mps) +
        "; with clearance=swept or witness it must be 0: what was swept has no time. Take width or "
        "radial where obstacles move");
  }
  if (p.curvature == CurvatureReading::path) {
    require_fits("curvature_min_travel_m",
                 p.curvature_min_travel_m,
                 "curvature_window_m",
                 p.curvature_window_m);
  } else if (p.curvature == CurvatureReading::contact) {
    require_fits("contact_spacing_m", p.contact_spacing_m, "contact_window_m", p.contact_window_m);
  } else if (p.curvature == CurvatureReading::contact_literal) {
    require_fits("contact_literal_spacing_m",
                 p.contact_literal_spacing_m,
                 "contact_window_m",
                 p.contact_window_m);
  }
  const auto require_deadbands = [&](const char* name, double window_m) {
    require_ratio(name, window_m, "travel_deadband_m", p.travel_deadband_m, kMostDeadbands);
  };
  require_deadbands("side_window_m", p.side_window_m);
  require_deadbands("curvature_window_m", p.curvature_window_m);
  require_deadbands("swept_lag_m", p.swept_lag_m);
  require_ratio(
      "memory_sigma_m", p.memory_sigma_m, "memory_cell_m", p.memory_cell_m, kMostSigmaCells);
  if (p.clearance == ClearanceReading::swept) {
    require_ratio(
        "least_obstacle_m", p.least_obstacle_m, "swept_cell_m", p.swept_cell_m, kMostObstacleCells);
  }
}

void validate(const Robot& robot, const CertificateParameters& p) {
  validate(robot);
  validate(p);
  require_ratio(
      "body_width_m", robot.body_width_m, "travel_deadband_m", p.travel_deadband_m, kMostDeadbands);
  require_ratio(
      "body_width_m", robot.body_width_m, "memory_cell_m", p.memory_cell_m, kMostBodyCells);
  if (p.clearance != ClearanceReading::swept) {
    return;
  }
  const auto require_cells = [&](const char* name, double length_m) {
    require_ratio(name, length_m, "swept_cell_m", p.swept_cell_m, kMostReachCells);
  };
  require_cells("body_width_m", robot.body_width_m);
  for (const Ray& ray : robot.rays) {
    require_cells(("ray '" + ray.name + "': mount and reach_m together").c_str(),
                  norm(ray.mount) + ray.reach_m);
  }
}

}  // namespace tcert
