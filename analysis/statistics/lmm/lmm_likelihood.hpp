#pragma once
/// \file
/// The profiled likelihood of a linear mixed model as a function of the random effects' factors.
///
/// With A = Z Lambda and H = I + A'A, the criterion is (Bates, Maechler, Bolker and Walker, 2015)
///     log|H| + n (1 + log(2 pi r / n)),        r = min |y - X beta - A u|^2 + |u|^2,
/// or, restricted, log|H| + log|X' V^-1 X| + (n - p) (1 + log(2 pi r / (n - p))), V = I + A A'.
/// Gradients are exact: those of r and of log|X' V^-1 X| by the envelope theorem, that of log|H|
/// by the elements of the inverse of H where it is not 0. The Hessian is made of central
/// differences of fourth order of the gradient. Internal to the estimator.

#include <Eigen/Core>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <statistics/glmm/sparse_curvature.hpp>
#include <vector>

namespace tcert::statistics {

/// The parts of the criterion at one factor.
struct LmmPoint {
  double log_determinants = 0.0;  ///< log|H|, and log|X' V^-1 X| if restricted.
  double residual = 0.0;          ///< r.
  Eigen::VectorXd fixed;          ///< beta, along the basis.
  Eigen::MatrixXd information;    ///< X' V^-1 X.
  Eigen::VectorXd determinant_slope;
  Eigen::VectorXd residual_slope;
  std::vector<Eigen::MatrixXd> information_slopes;
};

class LmmLikelihood final : public MixedLikelihood {
 public:
  /// Rows of `basis`, `y` and the terms' designs are multiplied by `root_weights` (empty: 1), the
  /// first two by the caller. `terms` must outlive the object. \pre every term has its design.
  LmmLikelihood(const Eigen::MatrixXd& basis,
                const Eigen::VectorXd& y,
                const std::vector<TermRows>& terms,
                const Eigen::VectorXd& root_weights,
                bool restricted);

  [[nodiscard]] Eigen::Index thetas() const noexcept override { return thetas_; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return thetas_; }
  [[nodiscard]] bool has_cheap_hessian() const noexcept override { return false; }
  /// n, or n - p if restricted.
  [[nodiscard]] double df() const noexcept { return df_; }

  /// Minus half the criterion, without the constants of weights and of the basis.
  [[nodiscard]] bool evaluate(const Eigen::VectorXd& parameters,
                              Derivatives wanted,
                              LikelihoodPoint& point) override;
  [[nodiscard]] std::vector<TermModes> modes(const Eigen::VectorXd& parameters) override;

  /// False where H or X' V^-1 X is not positive definite.
  [[nodiscard]] bool parts_at(const Eigen::VectorXd& parameters, bool with_slopes, LmmPoint& at);

 private:
  void set_factors(const Eigen::VectorXd& parameters);
  [[nodiscard]] Eigen::VectorXd crossed(const Eigen::VectorXd& rows) const;    ///< A' rows.
  [[nodiscard]] Eigen::VectorXd spread(const Eigen::VectorXd& effects) const;  ///< A effects.
  void add_slopes(LmmPoint& at);

  Eigen::MatrixXd joint_;  ///< The basis and y: rows x (p + 1).
  const std::vector<TermRows>& terms_;
  std::vector<RowMajorMatrix> designs_;
  bool restricted_;
  double df_ = 0.0;
  Eigen::Index thetas_ = 0;
  SparseCurvature curvature_;
  std::vector<Eigen::MatrixXd> factors_;
  RowMajorMatrix a_;          ///< rows x effects of a row.
  Eigen::MatrixXd effects_;   ///< Of each column of joint_: H^-1 A' column.
  Eigen::MatrixXd whitened_;  ///< V^-1 column.
};

}  // namespace tcert::statistics
