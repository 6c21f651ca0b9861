#include <statistics/lmm/lmm_likelihood.hpp>

#include <cmath>
#include <numbers>
#include <statistics/basics/linalg.hpp>
#include <statistics/glmm/term_modes.hpp>

namespace tcert::statistics {

LmmLikelihood::LmmLikelihood(const Eigen::MatrixXd& basis,
                             const Eigen::VectorXd& y,
                             const std::vector<TermRows>& terms,
                             const Eigen::VectorXd& root_weights,
                             bool restricted)
    : joint_(basis.rows(), basis.cols() + 1),
      terms_(terms),
      restricted_(restricted),
      df_(static_cast<double>(restricted ? basis.rows() - basis.cols() : basis.rows())),
      curvature_(terms, basis.rows()),
      a_(basis.rows(), curvature_.per_row()) {
  joint_ << basis, y;
  for (const TermRows& term : terms_) {
    thetas_ += term.thetas();
    designs_.push_back(term.design);
    if (root_weights.size() > 0) {
      designs_.back().array().colwise() *= root_weights.array();
    }
  }
}

void LmmLikelihood::set_factors(const Eigen::VectorXd& parameters) {
  factors_.clear();
  Eigen::Index at = 0;
  Eigen::Index place = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const Eigen::Index q = terms_[t].scale.size();
    Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(q, q);
    for (Eigen::Index j = 0; j < q; ++j) {
      for (Eigen::Index i = j; i < q; ++i) {
        factor(i, j) = parameters[at++];
      }
    }
    a_.middleCols(place, q).noalias() = designs_[t] * factor;
    factors_.push_back(std::move(factor));
    place += q;
  }
}

Eigen::VectorXd LmmLikelihood::crossed(const Eigen::VectorXd& rows) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(curvature_.effects());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const Eigen::Index* const at = curvature_.places(i);
    for (Eigen::Index k = 0; k < curvature_.per_row(); ++k) {
      sum[at[k]] += a_(i, k) * rows[i];
    }
  }
  return sum;
}

Eigen::VectorXd LmmLikelihood::spread(const Eigen::VectorXd& effects) const {
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(a_.rows());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const Eigen::Index* const at = curvature_.places(i);
    for (Eigen::Index k = 0; k < curvature_.per_row(); ++k) {
      rows[i] += a_(i, k) * effects[at[k]];
    }
  }
  return rows;
}

bool LmmLikelihood::parts_at(const Eigen::VectorXd& parameters, bool with_slopes, LmmPoint& at) {
  if (!parameters.allFinite()) {
    return false;
  }
  set_factors(parameters);
  if (!curvature_.factorise(a_, Eigen::VectorXd::Ones(a_.rows()))) {
    return false;
  }
  const Eigen::Index p = joint_.cols() - 1;
  effects_.resize(curvature_.effects(), p + 1);
  whitened_.resize(joint_.rows(), p + 1);
  for (Eigen::Index j = 0; j <= p; ++j) {
    effects_.col(j) = curvature_.solve(crossed(joint_.col(j)));
    whitened_.col(j) = joint_.col(j) - spread(effects_.col(j));
  }
  const Eigen::MatrixXd products = joint_.transpose() * whitened_;
  at.information = 0.5 * (products.topLeftCorner(p, p) + products.topLeftCorner(p, p).transpose());
  const Cholesky cholesky(at.information);
  if (p > 0 && !cholesky.succeeded()) {
    return false;
  }
  at.fixed = p > 0 ? cholesky.solve(Eigen::VectorXd(products.col(p).head(p))) : Eigen::VectorXd();
  // The response becomes what the fixed part leaves of it, so that no large sums cancel.
  effects_.col(p) -= effects_.leftCols(p) * at.fixed;
  whitened_.col(p) -= whitened_.leftCols(p) * at.fixed;
  at.residual = whitened_.col(p).squaredNorm() + effects_.col(p).squaredNorm();
  at.log_determinants = 2.0 * curvature_.half_log_determinant();
  if (restricted_ && p > 0) {
    at.log_determinants += 2.0 * cholesky.pivots().array().log().sum();
  }
  if (with_slopes) {
    add_slopes(at);
  }
  return std::isfinite(at.log_determinants) && at.residual > 0.0;
}

void LmmLikelihood::add_slopes(LmmPoint& at) {
  curvature_.invert();
  const Eigen::Index p = joint_.cols() - 1;
  const Eigen::MatrixXd inverse =
      p > 0 ? Cholesky(at.information).inverse() : Eigen::MatrixXd(0, 0);
  at.determinant_slope.setZero(thetas_);
  at.residual_slope.setZero(thetas_);
  at.information_slopes.assign(static_cast<std::size_t>(thetas_), Eigen::MatrixXd::Zero(p, p));
  Eigen::Index theta = 0;
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const Eigen::Index q = terms_[t].scale.size();
    for (Eigen::Index b = 0; b < q; ++b) {
      for (Eigen::Index a = b; a < q; ++a, ++theta) {
        double determinant = 0.0;
        Eigen::MatrixXd felt(a_.rows(), p + 1);  // Each row's own effects, times z.
        for (Eigen::Index i = 0; i < a_.rows(); ++i) {
          const double z = designs_[t](i, a);
          double inverse_a = 0.0;
          for (Eigen::Index k = 0; k < curvature_.per_row(); ++k) {
            inverse_a += curvature_.inverse(i, k, first + b) * a_(i, k);
          }
          determinant += 2.0 * z * inverse_a;
          felt.row(i) = z * effects_.row(curvature_.places(i)[first + b]);
        }
        const Eigen::MatrixXd moved = whitened_.transpose() * felt;
        const auto k = static_cast<std::size_t>(theta);
        at.information_slopes[k] =
            -(moved.topLeftCorner(p, p) + moved.topLeftCorner(p, p).transpose());
        at.residual_slope[theta] = -2.0 * moved(p, p);
        at.determinant_slope[theta] =
            determinant +
            (restricted_ ? inverse.cwiseProduct(at.information_slopes[k]).sum() : 0.0);
      }
    }
    first += q;
  }
}

bool LmmLikelihood::evaluate(const Eigen::VectorXd& parameters,
                             Derivatives wanted,
                             LikelihoodPoint& point) {
  LmmPoint at;
  if (!parts_at(parameters, wanted != Derivatives::none, at)) {
    return false;
  }
  point.value = -0.5 * (at.log_determinants +
                        df_ * (1.0 + std::log(2.0 * std::numbers::pi * at.residual / df_)));
  point.hessian.resize(0, 0);
  if (wanted == Derivatives::none) {
    return std::isfinite(point.value);
  }
  point.gradient = -0.5 * (at.determinant_slope + df_ / at.residual * at.residual_slope);
  if (wanted == Derivatives::gradient) {
    return point.gradient.allFinite();
  }
  constexpr double kStep = 1e-3;
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(thetas_, thetas_);
  for (Eigen::Index j = 0; j < thetas_; ++j) {
    for (const int shift : {-2, -1, 1, 2}) {
      Eigen::VectorXd moved = parameters;
      moved[j] += shift * kStep;
      LikelihoodPoint there;
      if (!evaluate(moved, Derivatives::gradient, there)) {
        return false;
      }
      const double weight = std::abs(shift) == 1 ? 8.0 * shift : -0.5 * shift;
      hessian.col(j) += (weight / (12.0 * kStep)) * there.gradient;
    }
  }
  point.hessian = 0.5 * (hessian + hessian.transpose());
  return point.hessian.allFinite();
}

std::vector<TermModes> LmmLikelihood::modes(const Eigen::VectorXd& parameters) {
  LmmPoint at;
  const bool possible = parts_at(parameters, false, at);
  if (possible) {
    curvature_.invert();
  }
  return term_modes(terms_,
                    factors_,
                    possible ? &curvature_ : nullptr,
                    effects_.col(joint_.cols() - 1),
                    std::sqrt(at.residual / df_));
}

}  // namespace tcert::statistics
