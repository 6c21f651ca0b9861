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
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
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
  using Matrix = Eigen::SparseMatrix<double>;

  void lay_out();
  void find_inverse_places();
  void set_factors(const Eigen::VectorXd& parameters);
  /// The joint log-density at u_; fills eta_, residual_, weight_. NaN where it overflows.
  double joint_density();
  [[nodiscard]] bool factorise();
  [[nodiscard]] Eigen::VectorXd mode_gradient() const;
  [[nodiscard]] bool find_mode();
  void take_inverse();
  void fill_gradient(LikelihoodPoint& point);
  [[nodiscard]] bool value_and_gradient(const Eigen::VectorXd& parameters,
                                        bool with_gradient,
                                        LikelihoodPoint& point);
  [[nodiscard]] bool fill_hessian(const Eigen::VectorXd& parameters, LikelihoodPoint& point);

  const Eigen::MatrixXd& basis_;
  const BinomialRows& rows_;
  const std::vector<TermRows>& terms_;
  Eigen::Index thetas_ = 0;
  Eigen::Index effects_ = 0;      ///< Elements of u.
  Eigen::Index per_row_ = 0;      ///< Elements of a row of A that are not 0.
  std::vector<Eigen::Index> of_;  ///< rows x per_row: their places in u.
  /// rows x pairs of them, the first no later in u than the second: places in the values of H.
  std::vector<std::int32_t> pair_;
  std::vector<std::size_t> diagonal_;      ///< Places of H's diagonal.
  std::vector<std::size_t> inverse_from_;  ///< Per element of H: place in the factor's inverse.
  Matrix h_;                               ///< Lower triangle.
  Eigen::SimplicialLLT<Matrix> cholesky_;

  std::vector<Eigen::MatrixXd> factors_;  ///< Lambda of each term.
  RowMajorMatrix a_;                      ///< rows x per_row.
  Eigen::VectorXd fixed_, eta_, residual_, weight_;
  Eigen::VectorXd u_;
  std::vector<double> inverse_;  ///< Per element of H.
};

}  // namespace tcert::statistics
