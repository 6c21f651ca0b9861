#pragma once
/// \file
/// The point of a polyhedral cone that is nearest to a given one.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace tcert::statistics {

/// The projection of a target onto {d : rows * d >= 0}; rows have length 1. By Moreau it is what
/// non-negative least squares leaves of the target after the best combination of -rows. Lawson and
/// Hanson's active-set method, its orthogonal factors kept from step to step: exact up to rounding,
/// O((rows + r) r) an iteration of r columns and usually few times as many iterations as columns.
class ConeProjection {
 public:
  explicit ConeProjection(Eigen::VectorXd target);

  /// Begins where the call before has ended, whose rows come first among `rows`. A projection
  /// shorter than `smallest` is 0. Empty if it does not end within 50 (r + 10) iterations, which
  /// only rounding could bring about.
  [[nodiscard]] std::optional<Eigen::VectorXd> onto(const Eigen::MatrixXd& rows, double smallest);

 private:
  void let_in(const Eigen::MatrixXd& rows, Eigen::Index entering);
  void move_towards(const Eigen::MatrixXd& rows, const Eigen::VectorXd& wanted);
  void append(const Eigen::VectorXd& row);
  [[nodiscard]] Eigen::Index size() const noexcept {
    return static_cast<Eigen::Index>(active_.size());
  }

  Eigen::VectorXd target_;
  Eigen::VectorXd residual_;          ///< target + A' weights, A the active rows.
  std::vector<Eigen::Index> active_;  ///< The rows that carry weight.
  std::vector<double> weights_;
  Eigen::MatrixXd orthogonal_;  ///< A' is `orthogonal_` times `triangle_`, in their first columns.
  Eigen::MatrixXd triangle_;
};

/// From the beginning.
[[nodiscard]] std::optional<Eigen::VectorXd> project_on_cone(const Eigen::MatrixXd& rows,
                                                             const Eigen::VectorXd& target,
                                                             double smallest);

}  // namespace tcert::statistics
