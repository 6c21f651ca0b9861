#include <statistics/glmm/sparse_likelihood.hpp>
#include <statistics/glmm/term_modes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tcert::statistics {
namespace {

constexpr double kLargestEta = 600.0;

}  // namespace

SparseLikelihood::SparseLikelihood(const Eigen::MatrixXd& basis,
                                   const BinomialRows& rows,
                                   const std::vector<TermRows>& terms)
    : basis_(basis), rows_(rows), terms_(terms), curvature_(terms, basis.rows()) {
  for (const TermRows& term : terms_) {
    thetas_ += term.thetas();
  }
  a_.resize(basis_.rows(), curvature_.per_row());
  eta_.resize(basis_.rows());
  residual_.resize(basis_.rows());
  weight_.resize(basis_.rows());
  u_.setZero(curvature_.effects());
}

void SparseLikelihood::set_factors(const Eigen::VectorXd& parameters) {
  factors_.clear();
  Eigen::Index at = 0;
  Eigen::Index place = 0;
  for (const TermRows& term : terms_) {
    const Eigen::Index q = term.scale.size();
    Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(q, q);
    for (Eigen::Index j = 0; j < q; ++j) {
      for (Eigen::Index i = j; i < q; ++i) {
        factor(i, j) = parameters[at++];
      }
    }
    a_.middleCols(place, q).noalias() = term.design * factor;
    factors_.push_back(std::move(factor));
    place += q;
  }
  fixed_.noalias() = basis_ * parameters.tail(basis_.cols());
  if (rows_.offset.size() > 0) {
    fixed_ += rows_.offset;
  }
}

double SparseLikelihood::joint_density() {
  double loss = 0.0;
  for (Eigen::Index i = 0; i < basis_.rows(); ++i) {
    double eta = fixed_[i];
    const Eigen::Index* const at = curvature_.places(i);
    for (Eigen::Index k = 0; k < curvature_.per_row(); ++k) {
      eta += a_(i, k) * u_[at[k]];
    }
    if (!(std::abs(eta) <= kLargestEta)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double trials = rows_.trials[i];
    const double e = std::exp(-std::abs(eta));
    const double near = 1.0 / (1.0 + e);
    const double far = e * near;
    const double success = eta >= 0.0 ? near : far;
    loss += trials * std::log1p(e) +
            (eta >= 0.0 ? trials - rows_.successes[i] : rows_.successes[i]) * std::abs(eta);
    eta_[i] = eta;
    residual_[i] = rows_.successes[i] - trials * success;
    weight_[i] = trials * near * far;
  }
  return -loss - 0.5 * u_.squaredNorm();
}

Eigen::VectorXd SparseLikelihood::mode_gradient() const {
  Eigen::VectorXd gradient = -u_;
  for (Eigen::Index i = 0; i < basis_.rows(); ++i) {
    const Eigen::Index* const at = curvature_.places(i);
    for (Eigen::Index k = 0; k < curvature_.per_row(); ++k) {
      gradient[at[k]] += a_(i, k) * residual_[i];
    }
  }
  return gradient;
}

bool SparseLikelihood::find_mode() {
  double density = joint_density();
  if (!std::isfinite(density)) {
    u_.setZero();
    density = joint_density();
  }
  for (int iteration = 0; iteration < 100 && std::isfinite(density); ++iteration) {
    if (!curvature_.factorise(a_, weight_)) {
      return false;
    }
    const Eigen::VectorXd gradient = mode_gradient();
    const Eigen::VectorXd step = curvature_.solve(gradient);
    const double length = std::sqrt(std::max(0.0, gradient.dot(step)));
    const Eigen::VectorXd before = u_;
    double scale = 1.0;
    u_ = before + step;
    double next = joint_density();
    const double tolerance = 1e-12 * (1.0 + std::abs(density));
    while (!(next >= density - tolerance) && scale > 1e-10) {
      scale *= 0.5;
      u_ = before + scale * step;
      next = joint_density();
    }
    density = next;
    // What is left after this step is of the order of its square.
    if (length <= 1e-8) {
      return std::isfinite(density) && curvature_.factorise(a_, weight_);
    }
  }
  return false;
}

void SparseLikelihood::fill_gradient(LikelihoodPoint& point) {
  curvature_.invert();
  const Eigen::Index n = basis_.rows();
  const Eigen::Index per_row = curvature_.per_row();
  RowMajorMatrix inverse_a(n, per_row);  // each row: the inverse of H times a_i, at its places
  Eigen::VectorXd bend(n);               // how -log|H| / 2 moves with eta of each row
  Eigen::VectorXd right = Eigen::VectorXd::Zero(curvature_.effects());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index* const at = curvature_.places(i);
    double leverage = 0.0;
    for (Eigen::Index b = 0; b < per_row; ++b) {
      double sum = 0.0;
      for (Eigen::Index a = 0; a < per_row; ++a) {
        sum += curvature_.inverse(i, a, b) * a_(i, a);
      }
      inverse_a(i, b) = sum;
      leverage += sum * a_(i, b);
    }
    const double e = std::exp(-std::abs(eta_[i]));
    const double tilt = (eta_[i] >= 0.0 ? e - 1.0 : 1.0 - e) / (1.0 + e);  // 1 - 2 mu
    bend[i] = -0.5 * weight_[i] * tilt * leverage;
    for (Eigen::Index k = 0; k < per_row; ++k) {
      right[at[k]] += a_(i, k) * bend[i];
    }
  }
  const Eigen::VectorXd adjoint = curvature_.solve(right);
  Eigen::VectorXd slope(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index* const at = curvature_.places(i);
    double moved = 0.0;
    for (Eigen::Index k = 0; k < per_row; ++k) {
      moved += a_(i, k) * adjoint[at[k]];
    }
    slope[i] = residual_[i] + bend[i] - weight_[i] * moved;
  }
  point.gradient.setZero(size());
  point.gradient.tail(basis_.cols()).noalias() = basis_.transpose() * slope;
  Eigen::Index theta = 0;
  Eigen::Index first = 0;
  for (const TermRows& term : terms_) {
    const Eigen::Index q = term.scale.size();
    for (Eigen::Index b = 0; b < q; ++b) {
      for (Eigen::Index a = b; a < q; ++a, ++theta) {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < n; ++i) {
          const Eigen::Index place = curvature_.places(i)[first + b];
          sum += term.design(i, a) * (slope[i] * u_[place] + residual_[i] * adjoint[place] -
                                      weight_[i] * inverse_a(i, first + b));
        }
        point.gradient[theta] = sum;
      }
    }
    first += q;
  }
}

bool SparseLikelihood::value_and_gradient(const Eigen::VectorXd& parameters,
                                          bool with_gradient,
                                          LikelihoodPoint& point) {
  if (!parameters.allFinite()) {
    return false;
  }
  set_factors(parameters);
  if (!find_mode()) {
    u_.setZero();
    return false;
  }
  // find_mode has left the density's parts at the mode.
  const double density = joint_density();
  point.value = density - curvature_.half_log_determinant();
  if (with_gradient) {
    fill_gradient(point);
  }
  return std::isfinite(point.value);
}

bool SparseLikelihood::fill_hessian(const Eigen::VectorXd& parameters, LikelihoodPoint& point) {
  constexpr double kStep = 1e-3;
  const Eigen::Index count = size();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(count, count);
  const Eigen::VectorXd mode = u_;
  for (Eigen::Index j = 0; j < count; ++j) {
    for (const int shift : {-2, -1, 1, 2}) {
      Eigen::VectorXd moved = parameters;
      moved[j] += shift * kStep;
      LikelihoodPoint there;
      u_ = mode;
      if (!value_and_gradient(moved, true, there)) {
        return false;
      }
      const double weight = std::abs(shift) == 1 ? 8.0 * shift : -0.5 * shift;
      hessian.col(j) += (weight / (12.0 * kStep)) * there.gradient;
    }
  }
  u_ = mode;
  point.hessian = 0.5 * (hessian + hessian.transpose());
  return true;
}

bool SparseLikelihood::evaluate(const Eigen::VectorXd& parameters,
                                Derivatives wanted,
                                LikelihoodPoint& point) {
  point.hessian.resize(0, 0);
  if (!value_and_gradient(parameters, wanted != Derivatives::none, point)) {
    return false;
  }
  return wanted != Derivatives::hessian || fill_hessian(parameters, point);
}

std::vector<TermModes> SparseLikelihood::modes(const Eigen::VectorXd& parameters) {
  LikelihoodPoint point;
  const bool possible = value_and_gradient(parameters, false, point);
  if (possible) {
    curvature_.invert();
  }
  return term_modes(terms_, factors_, possible ? &curvature_ : nullptr, u_, 1.0);
}

}  // namespace tcert::statistics
