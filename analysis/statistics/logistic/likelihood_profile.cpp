#include <statistics/logistic/likelihood_profile.hpp>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/normal.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

/// The likelihood along one coefficient: functional' gamma, maximised over the rest.
class CoefficientProfile {
 public:
  CoefficientProfile(const ProfilePoint& maximum,
                     const Eigen::VectorXd& functional,
                     const ConstrainedMaximum& maximise)
      : maximise_(maximise),
        functional_(functional),
        others_(orthogonal_complement(functional)),
        highest_(maximum.value),
        at_(maximum) {}

  /// Goes to value `to` of the coefficient; false if the rest cannot be maximised there.
  bool move(double to) {
    // Along the line on which the others stay best as far as the curvature here can tell.
    const Eigen::VectorXd line = Cholesky(at_.information).solve(functional_);
    const Eigen::VectorXd start =
        at_.coefficients + line * ((to - value()) / functional_.dot(line));
    std::optional<ProfilePoint> next = maximise_(start, others_);
    if (!next) {
      return false;
    }
    at_ = std::move(*next);
    return true;
  }

  [[nodiscard]] double value() const { return functional_.dot(at_.coefficients); }
  /// The square root of twice the drop.
  [[nodiscard]] double root() const { return std::sqrt(2.0 * std::max(0.0, highest_ - at_.value)); }
  /// Of the log-likelihood by the coefficient: the others' gradient is 0 here.
  [[nodiscard]] double slope() const {
    return functional_.dot(at_.gradient) / functional_.squaredNorm();
  }

 private:
  const ConstrainedMaximum& maximise_;
  Eigen::VectorXd functional_;
  Eigen::MatrixXd others_;
  double highest_;
  ProfilePoint at_;
};

/// Where the root of the drop is `target` on the side of `sign`. The root is nearly linear in the
/// coefficient, so Newton's method needs a few steps; they are kept within the bracket found so
/// far.
std::optional<double> end_along(CoefficientProfile profile,
                                double error,
                                double target,
                                double sign) {
  double inside = profile.value();
  double outside = sign * std::numeric_limits<double>::infinity();
  double next = inside + sign * target * error;
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (!profile.move(next)) {
      return std::nullopt;
    }
    const double root = profile.root();
    if (std::abs(root - target) <= 1e-10 * target) {
      return next;
    }
    (root < target ? inside : outside) = next;
    next -= (root - target) * root / -profile.slope();
    const bool within = (next - inside) * sign > 0.0 && (outside - next) * sign > 0.0;
    if (!within) {
      next = std::isfinite(outside) ? 0.5 * (inside + outside) : inside + sign * target * error;
    }
  }
  return std::nullopt;
}

}  // namespace

Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& functionals) {
  const Eigen::Index size = functionals.rows();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functionals);
  const Eigen::MatrixXd whole = qr.householderQ() * Eigen::MatrixXd::Identity(size, size);
  return whole.rightCols(size - functionals.cols());
}

std::optional<double> profile_end(const ProfilePoint& maximum,
                                  const Eigen::VectorXd& functional,
                                  const ConstrainedMaximum& maximise,
                                  double level,
                                  double sign) {
  const double error = std::sqrt(functional.dot(Cholesky(maximum.information).solve(functional)));
  return end_along(
      CoefficientProfile(maximum, functional, maximise), error, normal_factor(level), sign);
}

std::optional<Interval> profile_interval(const ProfilePoint& maximum,
                                         const Eigen::VectorXd& functional,
                                         const ConstrainedMaximum& maximise,
                                         double level) {
  const auto low = profile_end(maximum, functional, maximise, level, -1.0);
  const auto high = profile_end(maximum, functional, maximise, level, 1.0);
  return low && high ? std::optional(Interval{*low, *high, level}) : std::nullopt;
}

}  // namespace tcert::statistics
