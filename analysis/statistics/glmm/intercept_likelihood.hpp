#pragma once
/// \file
/// The likelihood of a logistic model with a single random intercept.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/glmm/grouped_rows.hpp>
#include <statistics/glmm/hermite_rule.hpp>
#include <statistics/glmm/intercept_group.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <vector>

namespace tcert::statistics {

/// Parameters are theta, the standard deviation between groups, and the coefficients along the
/// basis. Value, gradient and Hessian are exact up to rounding. Blocks of groups are worked on in
/// parallel and added in order: the same bytes for any number of threads.
class InterceptLikelihood final : public MixedLikelihood {
 public:
  /// `rows` must outlive the object. \throws std::invalid_argument as `hermite_rule`.
  InterceptLikelihood(const GroupedRows& rows, int quadrature);

  [[nodiscard]] Eigen::Index thetas() const noexcept override { return 1; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return 1 + rows_.basis.cols(); }
  [[nodiscard]] bool evaluate(const Eigen::VectorXd& parameters,
                              Derivatives wanted,
                              LikelihoodPoint& point) override;
  [[nodiscard]] bool has_cheap_hessian() const noexcept override { return true; }
  [[nodiscard]] std::vector<TermModes> modes(const Eigen::VectorXd& parameters) override;

 private:
  /// Groups that are worked on together.
  struct Block {
    Eigen::Index first = 0;  ///< Groups.
    Eigen::Index last = 0;
    bool possible = true;
    InterceptSum sum;
  };

  [[nodiscard]] InterceptGroup group(Eigen::Index index,
                                     const double* fixed,
                                     const double* odds) const;
  void add_block(const Eigen::VectorXd& parameters, Derivatives wanted, Block& block);

  const GroupedRows& rows_;
  HermiteRule rule_;
  std::vector<Block> blocks_;
  std::vector<double> modes_;
};

}  // namespace tcert::statistics
