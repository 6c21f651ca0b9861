#pragma once
/// \file
/// Maps one triangle of an obstacle onto its parent, a disc, or the border: the smooth step of
/// which the diffeomorphism is made (Vasilopoulos et al., 2020/2021).

#include <array>
#include <optional>
#include <terrain/implicit.hpp>
#include <vector>

namespace tcert::terrain {

struct MapParameters {
  double beta_reach = 4.0;     ///< epsilon: where the switch of beta ends.
  double beta_weight = 1.0;    ///< mu_1.
  double gamma_weight = 0.15;  ///< mu_2.
};

/// h(x) and its Jacobian, and what they were made of.
struct Mapped {
  Position x{0.0, 0.0};
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();
  double beta = 0.0;
  double gamma = 0.0;
  double sigma_beta = 0.0;
  double sigma_gamma = 0.0;
  double sigma = 0.0;
  double nu = 0.0;
};

/// One triangle with its collar, the convex polygon outside which the map is the identity.
class TriangleMap {
 public:
  /// A root within the workspace, mapped onto a disc round its centroid with 0.8 of the inradius'
  /// distance. `triangle` and `collar` are counter-clockwise.
  TriangleMap(const std::vector<Position>& triangle,
              std::vector<Position> collar,
              const MapParameters& parameters);

  /// A child, or a root on the border: mapped onto its edge v0-v1, seen from `centre` beyond it.
  TriangleMap(const std::vector<Position>& triangle,
              std::vector<Position> collar,
              const Position& centre,
              const MapParameters& parameters);

  [[nodiscard]] Mapped map(const Position& x) const;
  [[nodiscard]] Implicit beta(const Position& x) const;
  [[nodiscard]] Implicit gamma(const Position& x) const;

  [[nodiscard]] const Position& centre() const noexcept { return centre_; }
  [[nodiscard]] double radius() const noexcept { return radius_; }  ///< 0 but for inner roots.
  [[nodiscard]] const std::vector<Position>& collar() const noexcept { return collar_; }
  /// True where the map is known to be the identity without evaluating it.
  [[nodiscard]] bool outside(const Position& x) const noexcept;

 private:
  void bound();

  std::vector<Position> vertices_;
  std::vector<Eigen::Vector2d> normals_;
  std::vector<Position> collar_;
  std::vector<Eigen::Vector2d> collar_normals_;
  Position centre_{0.0, 0.0};
  double radius_ = 0.0;
  bool disc_ = true;
  std::array<Eigen::Vector2d, 2> centre_normals_;  // of v0 -> centre and centre -> v1
  Position low_{0.0, 0.0};
  Position high_{0.0, 0.0};
  MapParameters parameters_;
};

/// Distance of `p` to segment a-b.
[[nodiscard]] double distance_to_segment(const Position& p, const Position& a, const Position& b);

}  // namespace tcert::terrain
