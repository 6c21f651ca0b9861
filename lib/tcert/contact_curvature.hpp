#pragma once
/// \file
/// Turn radius from successive contacts with a wall (paper 3.1, P2).

#include <array>
#include <cstddef>
#include <tcert/geometry.hpp>
#include <tcert/parameters.hpp>
#include <vector>

namespace tcert {

/// A point of a wall, as felt.
struct Contact {
  Point point;             ///< In the odometry frame.
  double lateral_m = 0.0;  ///< In the body frame, positive to the left.
  Point left;              ///< Unit vector to the robot's left when it was felt.
  double travel_m = 0.0;
};

/// Radius of the circle through three points and the least height of their triangle.
struct CircleFit {
  double radius_m = 0.0;
  Point centre;
  double height_m = 0.0;
  double longest_m = 0.0;
};

/// Infinite radius if the points are collinear.
[[nodiscard]] CircleFit circle_through(Point a, Point b, Point c) noexcept;

/// Radius of the robot's path round the wall that three contacts of one ray describe: the wall's
/// radius plus the lateral distance if the wall is on the inside of the turn, minus it if outside.
/// May be negative (a kink of the wall, not a bend); infinite if the triple is too flat to tell.
[[nodiscard]] double path_radius_along(const std::array<Contact, 3>& triple,
                                       const CertificateParameters& parameters) noexcept;

/// The last contacts of every ray, spaced apart, taken greedily forward.
class ContactCurvature {
 public:
  ContactCurvature(std::size_t rays, const CertificateParameters& parameters);

  void clear() noexcept;

  /// \pre `contact.travel_m` never falls between two clears; ray below the number of rays.
  void add(std::size_t ray, const Contact& contact) noexcept;

  /// The smallest radius that the triples within the contact window state; `path_radius_m`, the
  /// estimate from the executed path, is always a candidate. O(rays).
  [[nodiscard]] double radius(double travel_m, double path_radius_m) const noexcept;

 private:
  struct Track {
    std::array<Contact, 3> last;
    std::size_t count = 0;
    double triple_radius_m = 0.0;
  };
  [[nodiscard]] bool is_literal() const noexcept {
    return parameters_.curvature == CurvatureReading::contact_literal;
  }

  CertificateParameters parameters_;
  std::vector<Track> tracks_;
};

}  // namespace tcert
