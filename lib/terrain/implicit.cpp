#include <cmath>
#include <terrain/implicit.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] double even_power(double base) {
  const double b2 = base * base;
  const double b4 = b2 * b2;
  return b4 * b4 * b2;
}
static_assert(kConjunctionPower == 10, "even_power is the tenth power");

[[nodiscard]] double ninth_power(double base) {
  const double b2 = base * base;
  const double b4 = b2 * b2;
  return b4 * b4 * base;
}

}  // namespace

Implicit conjunction(const Implicit& a, const Implicit& b) {
  // Scaled, so that the tenth powers neither overflow nor vanish.
  const double scale = std::max(std::abs(a.value), std::abs(b.value));
  if (scale == 0.0) {
    return {0.0, a.gradient + b.gradient};
  }
  const double root =
      std::pow(even_power(a.value / scale) + even_power(b.value / scale), 1.0 / kConjunctionPower);
  const double radius = scale * root;
  return {a.value + b.value - radius,
          (1.0 - ninth_power(a.value / radius)) * a.gradient +
              (1.0 - ninth_power(b.value / radius)) * b.gradient};
}

Implicit half_plane(const Position& x, const Position& on, const Eigen::Vector2d& normal) {
  return {(x - on).dot(normal), normal};
}

std::vector<Eigen::Vector2d> inward_normals(const std::vector<Position>& polygon) {
  std::vector<Eigen::Vector2d> normals;
  normals.reserve(polygon.size());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector2d edge = (polygon[(k + 1) % polygon.size()] - polygon[k]).normalized();
    normals.emplace_back(-edge.y(), edge.x());
  }
  return normals;
}

}  // namespace tcert::terrain
