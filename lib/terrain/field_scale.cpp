#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <terrain/confidence.hpp>
#include <terrain/field_scale.hpp>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>

namespace tcert::terrain {
namespace {

constexpr double kNugget = 1e-6;         // of the field's variance
constexpr double kLeastVariance = 1e-4;  // of the field's: what joins the skeleton
constexpr double kRounding = 1e-12;      // of the largest value: differences below it are none

/// P(gamma with shape a and scale 1 <= x): the series below a + 1, the continued fraction above
/// (Press et al., Numerical Recipes, section 6.2, after Lentz).
[[nodiscard]] double gamma_probability(double a, double x) {
  constexpr int kMostTerms = 10000;
  constexpr double kLast = 1e-15;
  const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a;
    double sum = term;
    for (int k = 1; k < kMostTerms && term > kLast * sum; ++k) {
      term *= x / (a + k);
      sum += term;
    }
    return front * sum;
  }
  constexpr double kTiny = 1e-300;
  double b = x + 1.0 - a;
  double c = 1.0 / kTiny;
  double d = 1.0 / b;
  double fraction = d;
  for (int k = 1; k < kMostTerms; ++k) {
    const double numerator = -k * (k - a);
    b += 2.0;
    d = numerator * d + b;
    d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
    c = b + numerator / c;
    c = std::abs(c) < kTiny ? kTiny : c;
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < kLast) {
      break;
    }
  }
  return 1.0 - front * fraction;
}

}  // namespace

double chi_square_quantile(double freedom, double level) {
  // Of the logarithm: lower quantiles of few degrees of freedom are tiny.
  double low = -700.0;
  double high = std::log(freedom + 100.0 * std::sqrt(freedom) + 1000.0);
  for (int i = 0; i < 200 && high - low > 1e-13; ++i) {
    const double middle = 0.5 * (low + high);
    (gamma_probability(0.5 * freedom, 0.5 * std::exp(middle)) < level ? low : high) = middle;
  }
  return std::exp(low);  // Below the quantile: a bound made with it is not too small.
}

FieldScale::FieldScale(const FieldAssumptions& assumptions)
    : assumptions_(assumptions), bound_(kUnbounded) {
  require_within("kernel-length-scale", assumptions.length_scale);
  require_within("noise-sd", assumptions.noise_sd);
  require_within("confidence", assumptions.confidence);
  require_within("gradient-prior", assumptions.gradient.sd);
  require_within("gradient-prior", assumptions.gradient.places);
}

double FieldScale::correlation(const Position& a, const Position& b) const {
  const double scale = assumptions_.length_scale * assumptions_.length_scale;
  return std::exp(-0.5 * (a - b).squaredNorm() / scale);
}

void FieldScale::add(const Measurement& m) {
  const std::size_t n = positions_.size();
  std::vector<double> row(n + 1);
  double pivot = 1.0;
  double value = n == 0 ? 0.0 : m.value - origin_;
  double one = 1.0;
  for (std::size_t j = 0; j < n; ++j) {
    double sum = correlation(m.at, positions_[j]);
    for (std::size_t k = 0; k < j; ++k) {
      sum -= row[k] * cholesky_[j][k];
    }
    row[j] = sum / cholesky_[j][j];
    pivot -= row[j] * row[j];
    value -= row[j] * whitened_values_[j];
    one -= row[j] * whitened_ones_[j];
  }
  const double of_mean = n == 0 ? 0.0 : one * one / ones_by_ones_;
  if (n > 0 && pivot + of_mean < kLeastVariance) {
    return;
  }
  const double root = std::sqrt(std::max(pivot, 0.0) + kNugget);
  row[n] = root;
  if (n == 0) {
    origin_ = m.value;
  }
  largest_ = std::max(largest_, std::abs(m.value));
  positions_.push_back(m.at);
  values_.push_back(m.value - origin_);
  cholesky_.push_back(std::move(row));
  whitened_values_.push_back(value / root);
  whitened_ones_.push_back(one / root);
  values_by_values_ += whitened_values_.back() * whitened_values_.back();
  values_by_ones_ += whitened_values_.back() * whitened_ones_.back();
  ones_by_ones_ += whitened_ones_.back() * whitened_ones_.back();
}

double FieldScale::quadratic_form(double variance) const {
  const auto n = static_cast<Eigen::Index>(values_.size());
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      k(i, j) = variance * correlation(positions_[static_cast<std::size_t>(i)],
                                       positions_[static_cast<std::size_t>(j)]);
    }
    k(i, i) += variance * kNugget + assumptions_.noise_sd * assumptions_.noise_sd;
  }
  const Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> llt(k);
  const Eigen::VectorXd y =
      llt.matrixL().solve(Eigen::Map<const Eigen::VectorXd>(values_.data(), n));
  const Eigen::VectorXd one = llt.matrixL().solve(Eigen::VectorXd::Ones(n));
  const double cross = y.dot(one);
  return std::max(y.squaredNorm() - cross * cross / one.squaredNorm(), 0.0);
}

double FieldScale::freedom() const noexcept {
  return static_cast<double>(values_.size()) - 1.0 + assumptions_.gradient.places;
}

double FieldScale::squares() const {
  const double least = static_cast<double>(values_.size()) * std::pow(kRounding * largest_, 2.0);
  const double squares = values_by_values_ - values_by_ones_ * values_by_ones_ / ones_by_ones_;
  return squares > least ? squares : 0.0;
}

double FieldScale::squares_of_prior() const {
  const GradientPrior& prior = assumptions_.gradient;
  return prior.places * std::pow(prior.sd * assumptions_.length_scale, 2.0);
}

double FieldScale::form(double variance) const {
  return assumptions_.noise_sd > 0.0 ? quadratic_form(variance) + squares_of_prior() / variance
                                     : (squares() + squares_of_prior()) / variance;
}

double FieldScale::bound_at(double quantile) const {
  // Without noise the form is exactly inverse in the variance; with noise that is too large.
  double high = (squares() + squares_of_prior()) / quantile;
  double low = 1e-12 * high;
  if (!(low > 0.0) || !std::isfinite(high)) {
    return kUnbounded;
  }
  if (assumptions_.noise_sd > 0.0) {
    if (form(low) < quantile) {
      return kUnbounded;  // Noise alone explains them: they say nothing of the field.
    }
    for (int i = 0; i < 40 && high > 1.01 * low; ++i) {
      const double middle = std::sqrt(low * high);
      (form(middle) < quantile ? high : low) = middle;
    }
  }
  return high;
}

bool FieldScale::renew() {
  const std::size_t innovations = values_.empty() ? 0 : values_.size() - 1;
  if (innovations == looked_) {
    return false;
  }
  looked_ = innovations;
  const double half_risk = 0.5 * (1.0 - assumptions_.confidence);
  const bool is_contradicted =
      bound_ < kUnbounded && form(bound_) > chi_square_quantile(freedom(), 1.0 - half_risk);
  const bool is_due = innovations >= next_;
  if (!is_contradicted && !is_due) {
    return false;
  }
  // A contradicted bound is replaced at the share that it had.
  const int share = bounds_ + (is_due ? 1 : 0);
  const double bound = bound_at(chi_square_quantile(freedom(), std::ldexp(half_risk, -share)));
  if (is_due && bound < kUnbounded) {
    next_ = std::max(innovations + 1, (3 * innovations + 1) / 2);
    bounds_ = share;
  }
  const double earlier = bound_;
  bound_ = is_contradicted ? bound : std::min(bound_, bound);
  return bound_ != earlier;
}

double FieldScale::lipschitz_bound(const Grid& grid) const {
  if (bound_ == kUnbounded) {
    return kUnbounded;
  }
  const double half_risk = 0.5 * (1.0 - assumptions_.confidence);
  return std::sqrt(bound_) / assumptions_.length_scale *
         steepest_factor(grid, assumptions_.length_scale, half_risk);
}

}  // namespace tcert::terrain
