#pragma once
/// \file
/// The marginal log-likelihood of a mixed model as a function to be maximised. Internal to the
/// estimator.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace tcert::statistics {

enum class Derivatives : std::uint8_t { none, gradient, hessian };

struct LikelihoodPoint {
  double value = 0.0;  ///< Without the binomial coefficients of counts.
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// Of every level of one random term.
struct TermModes {
  Eigen::MatrixXd modes;  ///< levels x columns.
  Eigen::MatrixXd sds;
};

/// Parameters are theta (the elements of the terms' factors, one after the other, each lower
/// triangle by columns) and then gamma, the coefficients along the fixed part's basis. The
/// function is even in each column of each factor. Evaluations start from the modes of the last
/// one, so an object belongs to one thread.
class MixedLikelihood {
 public:
  MixedLikelihood() = default;
  MixedLikelihood(const MixedLikelihood&) = delete;
  MixedLikelihood& operator=(const MixedLikelihood&) = delete;
  MixedLikelihood(MixedLikelihood&&) = delete;
  MixedLikelihood& operator=(MixedLikelihood&&) = delete;
  virtual ~MixedLikelihood() = default;

  [[nodiscard]] virtual Eigen::Index thetas() const noexcept = 0;
  [[nodiscard]] virtual Eigen::Index size() const noexcept = 0;

  /// False where it cannot be computed: a linear predictor beyond 300, modes not found.
  [[nodiscard]] virtual bool evaluate(const Eigen::VectorXd& parameters,
                                      Derivatives wanted,
                                      LikelihoodPoint& point) = 0;

  /// False if the Hessian is made of differences of gradients, which costs as many of them.
  [[nodiscard]] virtual bool has_cheap_hessian() const noexcept = 0;

  /// One entry a term. \pre `parameters` can be evaluated.
  [[nodiscard]] virtual std::vector<TermModes> modes(const Eigen::VectorXd& parameters) = 0;
};

}  // namespace tcert::statistics
