#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/contact_curvature.hpp>
#include <tcert/lengths.hpp>

namespace tcert {

CircleFit circle_through(Point a, Point b, Point c) noexcept {
  const Point ab = b - a;
  const Point ac = c - a;
  const double twice_area = cross(ab, ac);
  const double ab2 = dot(ab, ab);
  const double ac2 = dot(ac, ac);
  CircleFit fit;
  fit.longest_m = std::max({std::sqrt(ab2), std::sqrt(ac2), distance(b, c)});
  fit.height_m = fit.longest_m > 0.0 ? std::abs(twice_area) / fit.longest_m : 0.0;
  if (twice_area == 0.0) {
    fit.radius_m = std::numeric_limits<double>::infinity();
    return fit;
  }
  const double scale = 0.5 / twice_area;
  const Point offset{scale * (ac.y_m * ab2 - ab.y_m * ac2), scale * (ab.x_m * ac2 - ac.x_m * ab2)};
  fit.centre = a + offset;
  fit.radius_m = norm(offset);
  return fit;
}

double path_radius_along(const std::array<Contact, 3>& triple,
                         const CertificateParameters& parameters) noexcept {
  const CircleFit fit = circle_through(triple[0].point, triple[1].point, triple[2].point);
  const bool literal = parameters.curvature == CurvatureReading::contact_literal;
  const double flat = parameters.contact_flatness * fit.longest_m;
  const double least_height = literal ? flat : std::max(flat, 3.0 * parameters.sigma_contact_m);
  if (!std::isfinite(fit.radius_m) || fit.height_m < least_height) {
    return std::numeric_limits<double>::infinity();
  }
  if (literal) {
    return fit.radius_m;
  }
  const Contact& middle = triple[1];
  const double centre_left = dot(fit.centre - middle.point, middle.left);
  const bool wall_inside = (centre_left > 0.0) == (middle.lateral_m > 0.0);
  const double lateral_m = std::abs(middle.lateral_m);
  return wall_inside ? fit.radius_m + lateral_m : fit.radius_m - lateral_m;
}

ContactCurvature::ContactCurvature(std::size_t rays, const CertificateParameters& parameters)
    : parameters_(parameters), tracks_(rays) {}

void ContactCurvature::clear() noexcept {
  for (Track& track : tracks_) {
    track.count = 0;
  }
}

void ContactCurvature::add(std::size_t ray, const Contact& contact) noexcept {
  Track& track = tracks_[ray];
  const double spacing_m =
      is_literal() ? parameters_.contact_literal_spacing_m : parameters_.contact_spacing_m;
  if (track.count > 0 && !reaches(distance(track.last[2].point, contact.point), spacing_m)) {
    return;
  }
  track.last = {track.last[1], track.last[2], contact};
  track.count = std::min<std::size_t>(track.count + 1, 3);
  if (track.count == 3) {
    track.triple_radius_m = path_radius_along(track.last, parameters_);
  }
}

double ContactCurvature::radius(double travel_m, double path_radius_m) const noexcept {
  double smallest_m = path_radius_m;
  for (const Track& track : tracks_) {
    if (track.count < 3 ||
        exceeds(travel_m - track.last[0].travel_m, parameters_.contact_window_m)) {
      continue;
    }
    const double candidate_m = track.triple_radius_m;
    const bool agrees = candidate_m > 0.0 && candidate_m <= 2.0 * path_radius_m &&
                        2.0 * candidate_m >= path_radius_m;
    if (is_literal() || agrees) {
      smallest_m = std::min(smallest_m, candidate_m);
    }
  }
  return smallest_m;
}

}  // namespace tcert
