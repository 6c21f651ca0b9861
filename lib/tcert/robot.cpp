#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/robot.hpp>

namespace tcert {
namespace {

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) noexcept {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) {
    return y.front();
  }
  if (above == x.end()) {
    return y.back();
  }
  const auto i = static_cast<std::size_t>(above - x.begin());
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

void require(bool holds, const std::string& what) {
  if (!holds) {
    throw std::invalid_argument(what);
  }
}

bool is_monotone(const std::vector<double>& y) {
  return std::is_sorted(y.begin(), y.end()) || std::is_sorted(y.rbegin(), y.rend());
}

void validate(const Ray& ray) {
  const std::string name = "ray '" + ray.name + "': ";
  require(std::isfinite(ray.mount.x_m) && std::isfinite(ray.mount.y_m),
          name + "mount must be finite");
  require(std::isfinite(ray.bearing_rad), name + "bearing_rad must be finite");
  require(ray.reach_m > 0.0 && std::isfinite(ray.reach_m), name + "reach_m must be above 0");
  if (ray.kind != RayKind::bend) {
    return;
  }
  const auto& [bend, clearance] = ray.calibration;
  require(!bend.empty() && bend.size() == clearance.size(),
          name + "calibration needs as many bend_rad as clearance_m knots, at least one");
  const auto finite = [](double v) { return std::isfinite(v); };
  require(std::all_of(bend.begin(), bend.end(), finite) &&
              std::all_of(clearance.begin(), clearance.end(), finite),
          name + "calibration knots must be finite");
  require(std::adjacent_find(bend.begin(), bend.end(), std::greater_equal<>{}) == bend.end(),
          name + "calibration bend_rad must be strictly increasing");
  require(is_monotone(clearance), name + "calibration clearance_m must be monotone");
}

bool is_finite(Point p) { return std::isfinite(p.x_m) && std::isfinite(p.y_m); }

void validate(const Region& region, const std::string& name) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    require(is_finite(disc->centre) && std::isfinite(disc->radius_m), name + " must be finite");
    require(disc->radius_m > 0.0, name + ": the radius of the disc must be above 0");
    return;
  }
  const auto& vertices = std::get_if<Polygon>(&region)->vertices;
  require(vertices.size() >= 3, name + ": a polygon needs at least three vertices");
  require(std::all_of(vertices.begin(), vertices.end(), is_finite), name + " must be finite");
}

}  // namespace

double calibrated_clearance(const Calibration& calibration, double bend_rad) noexcept {
  return interpolate(calibration.bend_rad, calibration.clearance_m, bend_rad);
}

double longest_clearance(const Ray& ray) noexcept {
  const auto& clearance = ray.calibration.clearance_m;
  return ray.kind == RayKind::bend
             ? std::min(ray.reach_m, std::max(clearance.front(), clearance.back()))
             : ray.reach_m;
}

double calibrated_bend(const Calibration& calibration, double clearance_m) noexcept {
  const auto& bend = calibration.bend_rad;
  const auto& clearance = calibration.clearance_m;
  if (clearance_m == clearance.front()) {
    return bend.front();
  }
  const bool rising = clearance.back() > clearance.front();
  const auto beyond = [&](double knot) {
    return rising ? knot >= clearance_m : knot <= clearance_m;
  };
  for (std::size_t i = 0; i < bend.size(); ++i) {
    if (!beyond(clearance[i])) {
      continue;
    }
    if (i == 0) {
      return bend.front();
    }
    const double share = (clearance_m - clearance[i - 1]) / (clearance[i] - clearance[i - 1]);
    return bend[i - 1] + share * (bend[i] - bend[i - 1]);
  }
  return bend.back();
}

void validate(const Robot& robot) {
  require(robot.body_width_m > 0.0 && std::isfinite(robot.body_width_m),
          "body_width_m must be above 0");
  require(robot.min_turn_radius_m >= 0.0 && std::isfinite(robot.min_turn_radius_m),
          "min_turn_radius_m must not be negative");
  require(robot.tracking_buffer_m >= 0.0 && std::isfinite(robot.tracking_buffer_m),
          "tracking_buffer_m must not be negative");
  require(robot.curvature_buffer_per_m >= 0.0 && std::isfinite(robot.curvature_buffer_per_m),
          "curvature_buffer_per_m must not be negative");
  for (const Ray& ray : robot.rays) {
    validate(ray);
  }
}

void validate(const Course& course) {
  if (course.start) {
    validate(*course.start, "start");
  }
  if (course.goal) {
    validate(*course.goal, "goal");
  }
}

}  // namespace tcert
