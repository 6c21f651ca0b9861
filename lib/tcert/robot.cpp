#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tcert/region_overlap.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

namespace tcert {
namespace {

constexpr double kFurthest = 1e5;  // m, of a mount and of what a ray reaches

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
  require_in_bounds({name + "mount.x_m", "m", from(-kFurthest, kFurthest), {}}, ray.mount.x_m);
  require_in_bounds({name + "mount.y_m", "m", from(-kFurthest, kFurthest), {}}, ray.mount.y_m);
  require_in_bounds({name + "bearing_rad", "rad", from(-kLargestBearing, kLargestBearing), {}},
                    ray.bearing_rad);
  require_in_bounds({name + "reach_m", "m", above(0.0, kFurthest), {}}, ray.reach_m);
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

void require_point(Point p, const std::string& name) {
  constexpr FieldBounds kPlace = from(-kLargestPose, kLargestPose);
  require_in_bounds({name + ".x_m", "m", kPlace, {}}, p.x_m);
  require_in_bounds({name + ".y_m", "m", kPlace, {}}, p.y_m);
}

void validate(const Region& region, const std::string& name) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    require_point(disc->centre, name + ".centre");
    require_in_bounds({name + ".radius_m", "m", above(0.0, kLargestPose), {}}, disc->radius_m);
    return;
  }
  const auto& vertices = std::get_if<Polygon>(&region)->vertices;
  require(vertices.size() >= 3, name + ": a polygon needs at least three vertices");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    require_point(vertices[i], name + ".vertices[" + std::to_string(i) + "]");
  }
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
  require_fields(robot);
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
  require(!course.start || !course.goal || !touch(*course.start, *course.goal),
          "goal: has a point in common with start, so that nothing lies between them");
}

}  // namespace tcert
