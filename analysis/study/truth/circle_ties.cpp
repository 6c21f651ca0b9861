#include "analysis/study/truth/circle_ties.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace tcert::study {
namespace {

using Complex = std::complex<double>;

/// constant + dot(slope, u) for unit vectors u.
struct Linear {
  double constant = 0.0;
  Point slope;
};

Linear operator-(const Linear& a, const Linear& b) {
  return {a.constant - b.constant, a.slope - b.slope};
}

/// Squared distance from the obstacle's centre to the point of the circle in direction u.
Linear squared_distance(const Disc& circle, const Disc& disc) {
  const Point d = circle.centre - disc.centre;
  return {dot(d, d) + circle.radius_m * circle.radius_m, 2.0 * circle.radius_m * d};
}

Linear wall_distance(const Disc& circle, const Wall& wall) {
  return {surface_distance(wall, circle.centre), circle.radius_m * wall.normal};
}

/// linear(u) + square_weight * square(u)^2 = 0, u = exp(i angle).
struct TrigonometricEquation {
  Linear linear;
  double square_weight = 0.0;
  Linear square;
};

TrigonometricEquation equation(const Disc& circle, const Disc& a, const Disc& b) {
  const double step = a.radius_m - b.radius_m;
  const Linear from_b = squared_distance(circle, b);
  Linear difference = squared_distance(circle, a) - from_b;
  difference.constant -= step * step;
  if (step == 0.0) {
    return {difference, 0.0, {}};
  }
  const double weight = -4.0 * step * step;
  return {{weight * from_b.constant, weight * from_b.slope}, 1.0, difference};
}

TrigonometricEquation equation(const Disc& circle, const Disc& a, const Wall& b) {
  Linear reach = wall_distance(circle, b);
  reach.constant += a.radius_m;
  return {squared_distance(circle, a), -1.0, reach};
}

TrigonometricEquation equation(const Disc& circle, const Wall& a, const Disc& b) {
  return equation(circle, b, a);
}

TrigonometricEquation equation(const Disc& circle, const Wall& a, const Wall& b) {
  return {wall_distance(circle, a) - wall_distance(circle, b), 0.0, {}};
}

/// Coefficients of z^0 ... z^4 of z^2 times the left side.
std::array<Complex, 5> polynomial(const TrigonometricEquation& e) {
  const Point p = e.square.slope;
  const double m = e.square.constant;
  const double w = e.square_weight;
  const double constant = e.linear.constant + w * (m * m + 0.5 * dot(p, p));
  const Point first = e.linear.slope + 2.0 * w * m * p;
  const Complex one(0.5 * first.x_m, -0.5 * first.y_m);
  const Complex two(0.25 * w * (p.x_m * p.x_m - p.y_m * p.y_m), -0.5 * w * p.x_m * p.y_m);
  return {std::conj(two), std::conj(one), constant, one, two};
}

/// Roots of sum of c[k] z^k, the highest coefficient not 0.
template <int degree>
std::vector<Complex> roots(const Complex* c) {
  using Matrix = Eigen::Matrix<Complex, degree, degree>;
  Matrix companion = Matrix::Zero();
  for (int k = 0; k < degree; ++k) {
    companion(k, degree - 1) = -c[k] / c[degree];
    if (k > 0) {
      companion(k, k - 1) = 1.0;
    }
  }
  const Eigen::ComplexEigenSolver<Matrix> solver(companion, false);
  const auto& values = solver.eigenvalues();
  return {values.data(), values.data() + degree};
}

}  // namespace

std::vector<Point> circle_ties(const Disc& circle, const Obstacle& a, const Obstacle& b) {
  const TrigonometricEquation e =
      std::visit([&](const auto& x, const auto& y) { return equation(circle, x, y); }, a, b);
  const std::array<Complex, 5> c = polynomial(e);
  // What rounding leaves of a coefficient that is 0 does not count.
  const double scale = std::max({std::abs(c[2]), std::abs(c[3]), std::abs(c[4])});
  constexpr double kRounding = 1e-14;
  std::vector<Complex> z;
  if (std::abs(c[4]) > kRounding * scale) {
    z = roots<4>(c.data());
  } else if (std::abs(c[3]) > kRounding * scale) {
    z = roots<2>(c.data() + 1);
  }
  constexpr double kOnCircle = 1e-3;  // double roots come out to the square root of the rounding
  std::vector<Point> points;
  for (const Complex& root : z) {
    if (std::abs(std::abs(root) - 1.0) <= kOnCircle) {
      points.push_back(circle.centre + circle.radius_m * direction(std::arg(root)));
    }
  }
  return points;
}

}  // namespace tcert::study
