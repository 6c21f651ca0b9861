#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <terrain/triangle_map.hpp>

namespace tcert::terrain {
namespace {

constexpr double kDiscShare = 0.8;

struct Switch {
  double value = 0.0;
  Eigen::Vector2d gradient{0.0, 0.0};
};

/// 1 at the triangle, 0 at distance `reach` of it.
[[nodiscard]] Switch beta_switch(const Implicit& beta, const MapParameters& p) {
  const double left = p.beta_reach - beta.value;
  if (!(left > 0.0)) {
    return {};
  }
  const double value = std::exp(p.beta_weight / p.beta_reach - p.beta_weight / left);
  return {value, -p.beta_weight * value / (left * left) * beta.gradient};
}

/// 0 at the collar's border and beyond.
[[nodiscard]] Switch gamma_switch(const Implicit& gamma,
                                  const Eigen::Vector2d& from_centre,
                                  const MapParameters& p) {
  if (!(gamma.value > 0.0)) {
    return {};
  }
  const double distance = from_centre.norm();
  const double alpha = gamma.value / distance;
  const Eigen::Vector2d gradient =
      gamma.gradient / distance - gamma.value / (distance * distance * distance) * from_centre;
  const double value = std::exp(-p.gamma_weight / alpha);
  return {value, p.gamma_weight * value / (alpha * alpha) * gradient};
}

[[nodiscard]] Switch combined(const Switch& beta, const Switch& gamma) {
  if (beta.value == 1.0 && gamma.value == 0.0) {
    return {1.0, {0.0, 0.0}};
  }
  const double product = gamma.value * beta.value;
  const double sum = product + 1.0 - beta.value;
  const Eigen::Vector2d product_gradient =
      gamma.value * beta.gradient + beta.value * gamma.gradient;
  const Eigen::Vector2d sum_gradient = product_gradient - beta.gradient;
  return {product / sum, product_gradient / sum - product / (sum * sum) * sum_gradient};
}

}  // namespace

double distance_to_segment(const Position& p, const Position& a, const Position& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double at = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - at * along).norm();
}

TriangleMap::TriangleMap(const std::vector<Position>& triangle,
                         std::vector<Position> collar,
                         const MapParameters& parameters)
    : vertices_(triangle),
      normals_(inward_normals(triangle)),
      collar_(std::move(collar)),
      collar_normals_(inward_normals(collar_)),
      parameters_(parameters) {
  bound();
  centre_ = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  double nearest = distance_to_segment(centre_, triangle[0], triangle[1]);
  nearest = std::min(nearest, distance_to_segment(centre_, triangle[1], triangle[2]));
  nearest = std::min(nearest, distance_to_segment(centre_, triangle[2], triangle[0]));
  radius_ = kDiscShare * nearest;
}

TriangleMap::TriangleMap(const std::vector<Position>& triangle,
                         std::vector<Position> collar,
                         const Position& centre,
                         const MapParameters& parameters)
    : vertices_(triangle),
      normals_(inward_normals(triangle)),
      collar_(std::move(collar)),
      collar_normals_(inward_normals(collar_)),
      centre_(centre),
      disc_(false),
      parameters_(parameters) {
  bound();
  const Eigen::Vector2d in = (centre - triangle[0]).normalized();
  const Eigen::Vector2d out = (triangle[1] - centre).normalized();
  centre_normals_[0] = {-in.y(), in.x()};
  centre_normals_[1] = {-out.y(), out.x()};
}

void TriangleMap::bound() {
  if (vertices_.size() != 3 || collar_.size() < 3) {
    throw std::invalid_argument("a triangle needs three corners and a collar of at least three");
  }
  low_ = high_ = collar_.front();
  for (const Position& p : collar_) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
}

bool TriangleMap::outside(const Position& x) const noexcept {
  return x.x() < low_.x() || x.y() < low_.y() || x.x() > high_.x() || x.y() > high_.y();
}

Implicit TriangleMap::beta(const Position& x) const {
  const Implicit sides = conjunction(half_plane(x, vertices_[2], normals_[1]),
                                     half_plane(x, vertices_[2], normals_[2]));
  const Implicit base = disc_ ? half_plane(x, vertices_[0], normals_[0])
                              : conjunction(half_plane(x, centre_, centre_normals_[0]),
                                            half_plane(x, centre_, centre_normals_[1]));
  const Implicit inside = conjunction(sides, base);
  return {-inside.value, -inside.gradient};
}

Implicit TriangleMap::gamma(const Position& x) const {
  Implicit inside = half_plane(x, collar_[0], collar_normals_[0]);
  for (std::size_t k = 1; k < collar_.size(); ++k) {
    inside = conjunction(inside, half_plane(x, collar_[k], collar_normals_[k]));
  }
  return inside;
}

Mapped TriangleMap::map(const Position& x) const {
  const Implicit b = beta(x);
  const Implicit g = gamma(x);
  const Eigen::Vector2d r = x - centre_;
  const Switch sigma_beta = beta_switch(b, parameters_);
  const Switch sigma_gamma = gamma_switch(g, r, parameters_);
  const Switch sigma = combined(sigma_beta, sigma_gamma);
  double nu = 0.0;
  Eigen::Vector2d nu_gradient;
  if (disc_) {
    const double distance = r.norm();
    nu = radius_ / distance;
    nu_gradient = -radius_ / (distance * distance * distance) * r;
  } else {
    const Eigen::Vector2d& normal = normals_[0];
    const double edge = (vertices_[0] - centre_).dot(normal);
    const double height = r.dot(normal);
    nu = edge / height;
    nu_gradient = -edge / (height * height) * normal;
  }
  Mapped m;
  m.beta = b.value;
  m.gamma = g.value;
  m.sigma_beta = sigma_beta.value;
  m.sigma_gamma = sigma_gamma.value;
  m.sigma = sigma.value;
  m.nu = nu;
  m.x = sigma.value * (centre_ + nu * r) + (1.0 - sigma.value) * x;
  m.jacobian = (nu - 1.0) * r * sigma.gradient.transpose() +
               sigma.value * r * nu_gradient.transpose() +
               (1.0 + sigma.value * (nu - 1.0)) * Eigen::Matrix2d::Identity();
  return m;
}

}  // namespace tcert::terrain
