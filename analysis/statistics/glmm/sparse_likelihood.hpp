#pragma once
/// \file
/// The Laplace likelihood of a logistic model with any random terms: several, nested or crossed
/// groups, random slopes.
///
/// With u of all terms, A = Z Lambda, f(u) the joint log-density and H = I + A' W A at its mode:
///     l = f(u0) - log|H| / 2
/// (Bates and DebRoy, 2004). The mode is found by Newton's method (penalised iteratively reweighted
/// least squares); the gradient is exact, by differentiating f_u(u0; p) = 0 and log|H|, and needs
/// of the inverse of H only the elements where it is not 0. The Hessian is made of central
/// differences of fourth order of the gradient.

#include <Eigen/Core>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <statistics/glmm/sparse_curvature.hpp>
#include <vector>

namespace tcert::statistics {

class SparseLikelihood final : public MixedLikelihood {
 public:
  /// All arguments must outlive the object. \pre every term has its design.
  SparseLikelihood(const Eigen::MatrixXd& basis,
                   const BinomialRows& rows,
                   const std::vector<TermRows>& terms);

  [[nodiscard]] Eigen::Index thetas() const noexcept override { return thetas_; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return thetas_ + basis_.cols(); }
  [[nodiscard]] bool has_cheap_hessian() const noexcept override { return false; }
  [[nodiscard]] bool evaluate(const Eigen::VectorXd& parameters,
                              Derivatives wanted,
                              LikelihoodPoint& point) override;
  [[nodiscard]] std::vector<TermModes> modes(const Eigen::VectorXd& parameters) override;

 private:
  void set_factors(const Eigen::VectorXd& parameters);
  /// The joint log-density at u_; fills eta_, residual_, weight_. NaN where it overflows.
  double joint_density();
  [[nodiscard]] Eigen::VectorXd mode_gradient() const;
  [[nodiscard]] bool find_mode();
  void fill_gradient(LikelihoodPoint& point);
  [[nodiscard]] bool value_and_gradient(const Eigen::VectorXd& parameters,
                                        bool with_gradient,
                                        LikelihoodPoint& point);
  [[nodiscard]] bool fill_hessian(const Eigen::VectorXd& parameters, LikelihoodPoint& point);

  const Eigen::MatrixXd& basis_;
  const BinomialRows& rows_;
  const std::vector<TermRows>& terms_;
  Eigen::Index thetas_ = 0;
  SparseCurvature curvature_;
  std::vector<Eigen::MatrixXd> factors_;  ///< Lambda of each term.
  RowMajorMatrix a_;                      ///< rows x per_row.
  Eigen::VectorXd fixed_, eta_, residual_, weight_;
  Eigen::VectorXd u_;
};

}  // namespace tcert::statistics
