#include <statistics/glmm/sparse_likelihood.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <statistics/glmm/selected_inverse.hpp>

namespace tcert::statistics {
namespace {

constexpr double kLargestEta = 600.0;

/// Place of the pair (a, b), a <= b, among the pairs of `size` things.
std::size_t pair_index(Eigen::Index a, Eigen::Index b) {
  return static_cast<std::size_t>(b * (b + 1) / 2 + a);
}

}  // namespace

SparseLikelihood::SparseLikelihood(const Eigen::MatrixXd& basis,
                                   const BinomialRows& rows,
                                   const std::vector<TermRows>& terms)
    : basis_(basis), rows_(rows), terms_(terms) {
  for (const TermRows& term : terms_) {
    thetas_ += term.thetas();
    per_row_ += term.scale.size();
    effects_ += term.scale.size() * static_cast<Eigen::Index>(term.levels.size());
  }
  lay_out();
  a_.resize(basis_.rows(), per_row_);
  eta_.resize(basis_.rows());
  residual_.resize(basis_.rows());
  weight_.resize(basis_.rows());
  u_.setZero(effects_);
}

void SparseLikelihood::lay_out() {
  const Eigen::Index n = basis_.rows();
  of_.resize(static_cast<std::size_t>(n * per_row_));
  Eigen::Index first = 0;
  Eigen::Index place = 0;
  for (const TermRows& term : terms_) {
    const Eigen::Index q = term.scale.size();
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < q; ++j) {
        of_[static_cast<std::size_t>(i * per_row_ + place + j)] =
            first + static_cast<Eigen::Index>(term.codes[static_cast<std::size_t>(i)]) * q + j;
      }
    }
    first += q * static_cast<Eigen::Index>(term.levels.size());
    place += q;
  }
  // Terms follow each other in u, so that a row's places ascend: (b, a) is below the diagonal.
  std::vector<Eigen::Triplet<double>> elements;
  for (Eigen::Index k = 0; k < effects_; ++k) {
    elements.emplace_back(static_cast<int>(k), static_cast<int>(k), 1.0);
  }
  const std::size_t pairs = pair_index(0, per_row_);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index* const at = of_.data() + i * per_row_;
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      for (Eigen::Index a = 0; a < b; ++a) {
        elements.emplace_back(static_cast<int>(at[b]), static_cast<int>(at[a]), 0.0);
      }
    }
  }
  h_.resize(effects_, effects_);
  h_.setFromTriplets(elements.begin(), elements.end());
  const auto place_of = [this](Eigen::Index row, Eigen::Index column) {
    const int* const begin = h_.innerIndexPtr() + h_.outerIndexPtr()[column];
    const int* const end = h_.innerIndexPtr() + h_.outerIndexPtr()[column + 1];
    return static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<int>(row)) -
                                    h_.innerIndexPtr());
  };
  for (Eigen::Index k = 0; k < effects_; ++k) {
    diagonal_.push_back(place_of(k, k));
  }
  pair_.resize(static_cast<std::size_t>(n) * pairs);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index* const at = of_.data() + i * per_row_;
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      for (Eigen::Index a = 0; a <= b; ++a) {
        pair_[static_cast<std::size_t>(i) * pairs + pair_index(a, b)] =
            static_cast<std::int32_t>(place_of(at[b], at[a]));
      }
    }
  }
  cholesky_.analyzePattern(h_);
}

void SparseLikelihood::find_inverse_places() {
  const Matrix& factor = cholesky_.matrixL().nestedExpression();
  const auto& order = cholesky_.permutationP().indices();
  inverse_from_.resize(static_cast<std::size_t>(h_.nonZeros()));
  for (int column = 0; column < h_.outerSize(); ++column) {
    for (Matrix::InnerIterator it(h_, column); it; ++it) {
      const int a = order.size() > 0 ? order[static_cast<Eigen::Index>(it.row())]
                                     : static_cast<int>(it.row());
      const int b = order.size() > 0 ? order[column] : column;
      const int* const begin = factor.innerIndexPtr() + factor.outerIndexPtr()[std::min(a, b)];
      const int* const end = factor.innerIndexPtr() + factor.outerIndexPtr()[std::min(a, b) + 1];
      inverse_from_[static_cast<std::size_t>(&it.value() - h_.valuePtr())] =
          static_cast<std::size_t>(std::lower_bound(begin, end, std::max(a, b)) -
                                   factor.innerIndexPtr());
    }
  }
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
    const Eigen::Index* const at = of_.data() + i * per_row_;
    for (Eigen::Index k = 0; k < per_row_; ++k) {
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

bool SparseLikelihood::factorise() {
  double* const value = h_.valuePtr();
  std::fill_n(value, h_.nonZeros(), 0.0);
  for (const std::size_t place : diagonal_) {
    value[place] = 1.0;
  }
  const std::int32_t* place = pair_.data();
  for (Eigen::Index i = 0; i < basis_.rows(); ++i) {
    const double* const row = a_.data() + i * per_row_;
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      const double weighted = weight_[i] * row[b];
      for (Eigen::Index a = 0; a <= b; ++a) {
        value[*place++] += weighted * row[a];
      }
    }
  }
  cholesky_.factorize(h_);
  return cholesky_.info() == Eigen::Success;
}

Eigen::VectorXd SparseLikelihood::mode_gradient() const {
  Eigen::VectorXd gradient = -u_;
  for (Eigen::Index i = 0; i < basis_.rows(); ++i) {
    const Eigen::Index* const at = of_.data() + i * per_row_;
    for (Eigen::Index k = 0; k < per_row_; ++k) {
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
    if (!factorise()) {
      return false;
    }
    const Eigen::VectorXd gradient = mode_gradient();
    const Eigen::VectorXd step = cholesky_.solve(gradient);
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
      return std::isfinite(density) && factorise();
    }
  }
  return false;
}

void SparseLikelihood::take_inverse() {
  if (inverse_from_.empty()) {
    find_inverse_places();
  }
  const std::vector<double> all = selected_inverse(cholesky_.matrixL().nestedExpression());
  inverse_.resize(inverse_from_.size());
  for (std::size_t k = 0; k < inverse_.size(); ++k) {
    inverse_[k] = all[inverse_from_[k]];
  }
}

void SparseLikelihood::fill_gradient(LikelihoodPoint& point) {
  take_inverse();
  const Eigen::Index n = basis_.rows();
  const std::size_t pairs = pair_index(0, per_row_);
  RowMajorMatrix inverse_a(n, per_row_);  // each row: the inverse of H times a_i, at its places
  Eigen::VectorXd bend(n);                // how -log|H| / 2 moves with eta of each row
  Eigen::VectorXd right = Eigen::VectorXd::Zero(effects_);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::int32_t* const place = pair_.data() + static_cast<std::size_t>(i) * pairs;
    const Eigen::Index* const at = of_.data() + i * per_row_;
    double leverage = 0.0;
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      double sum = 0.0;
      for (Eigen::Index a = 0; a < per_row_; ++a) {
        sum +=
            inverse_[static_cast<std::size_t>(place[pair_index(std::min(a, b), std::max(a, b))])] *
            a_(i, a);
      }
      inverse_a(i, b) = sum;
      leverage += sum * a_(i, b);
    }
    const double e = std::exp(-std::abs(eta_[i]));
    const double tilt = (eta_[i] >= 0.0 ? e - 1.0 : 1.0 - e) / (1.0 + e);  // 1 - 2 mu
    bend[i] = -0.5 * weight_[i] * tilt * leverage;
    for (Eigen::Index k = 0; k < per_row_; ++k) {
      right[at[k]] += a_(i, k) * bend[i];
    }
  }
  const Eigen::VectorXd adjoint = cholesky_.solve(right);
  Eigen::VectorXd slope(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index* const at = of_.data() + i * per_row_;
    double moved = 0.0;
    for (Eigen::Index k = 0; k < per_row_; ++k) {
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
          const Eigen::Index place = of_[static_cast<std::size_t>(i * per_row_ + first + b)];
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
  const Matrix& factor = cholesky_.matrixL().nestedExpression();
  double log_pivots = 0.0;
  for (int j = 0; j < factor.outerSize(); ++j) {
    log_pivots += std::log(factor.valuePtr()[factor.outerIndexPtr()[j]]);
  }
  point.value = density - log_pivots;
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
  std::vector<TermModes> result;
  LikelihoodPoint point;
  const bool possible = value_and_gradient(parameters, false, point);
  if (possible) {
    take_inverse();
  }
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const Eigen::Index q = terms_[t].scale.size();
    const auto levels = static_cast<Eigen::Index>(terms_[t].levels.size());
    const Eigen::MatrixXd factor = terms_[t].scale.cwiseInverse().asDiagonal() * factors_[t];
    TermModes modes;
    modes.modes.setConstant(levels, q, std::nan(""));
    modes.sds = modes.modes;
    for (Eigen::Index level = 0; level < levels && possible; ++level, first += q) {
      modes.modes.row(level) = (factor * u_.segment(first, q)).transpose();
      Eigen::MatrixXd block(q, q);
      for (Eigen::Index b = 0; b < q; ++b) {
        for (Eigen::Index a = b; a < q; ++a) {
          // Effects of one level stand together, so that these follow the diagonal in H's column.
          block(a, b) = inverse_[diagonal_[static_cast<std::size_t>(first + b)] +
                                 static_cast<std::size_t>(a - b)];
          block(b, a) = block(a, b);
        }
      }
      modes.sds.row(level) =
          (factor * block * factor.transpose()).diagonal().cwiseSqrt().transpose();
    }
    result.push_back(std::move(modes));
  }
  return result;
}

}  // namespace tcert::statistics
