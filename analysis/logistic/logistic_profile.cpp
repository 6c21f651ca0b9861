#include "analysis/logistic/logistic_profile.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/basics/normal.hpp"
#include "analysis/logistic/logistic_problem.hpp"

namespace tcert {
namespace {

/// The likelihood along one coefficient: functional' gamma, maximised over the rest.
class Profile {
 public:
  Profile(const LogisticProblem& problem,
          const NewtonResult& maximum,
          Eigen::VectorXd functional,
          const NewtonOptions& options)
      : problem_(problem),
        options_(options),
        functional_(std::move(functional)),
        highest_(maximum.at.log_likelihood),
        at_(maximum) {
    // A reflection that takes the functional to the first axis: its other columns are orthonormal
    // and orthogonal to it.
    Eigen::VectorXd mirror = functional_.normalized();
    mirror[0] += mirror[0] < 0.0 ? -1.0 : 1.0;
    const Eigen::Index size = functional_.size();
    const Eigen::MatrixXd reflection = Eigen::MatrixXd::Identity(size, size) -
                                       (2.0 / mirror.squaredNorm()) * mirror * mirror.transpose();
    others_ = reflection.rightCols(size - 1);
  }

  /// The square root of twice the drop at value `to` of the coefficient; false if the rest cannot
  /// be maximised there.
  bool move(double to) {
    // Along the line on which the others stay best as far as the curvature here can tell.
    const Eigen::VectorXd line = at_.at.information.llt().solve(functional_);
    const Eigen::VectorXd start =
        at_.coefficients + line * ((to - value()) / functional_.dot(line));
    NewtonResult next =
        maximise_binomial(problem_.space.basis, problem_.rows, start, others_, options_);
    if (!next.converged()) {
      return false;
    }
    at_ = std::move(next);
    return true;
  }

  [[nodiscard]] double value() const { return functional_.dot(at_.coefficients); }
  [[nodiscard]] double root() const {
    return std::sqrt(2.0 * std::max(0.0, highest_ - at_.at.log_likelihood));
  }
  /// Of the log-likelihood by the coefficient: the others' gradient is 0 here.
  [[nodiscard]] double slope() const {
    return functional_.dot(at_.at.gradient) / functional_.squaredNorm();
  }

 private:
  const LogisticProblem& problem_;
  const NewtonOptions& options_;
  Eigen::VectorXd functional_;
  Eigen::MatrixXd others_;
  double highest_;
  NewtonResult at_;
};

/// Where the root of the drop is `target` on the side of `sign`. The root is nearly linear in the
/// coefficient, so Newton's method needs a few steps; they are kept within the bracket found so
/// far.
std::optional<double> profile_end(Profile profile, double error, double target, double sign) {
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

std::vector<std::optional<Interval>> profile_intervals(const LogisticInput& input,
                                                       const LogisticOptions& options) {
  std::vector<std::optional<Interval>> intervals(input.columns.size());
  const LogisticFit fit = fit_logistic(input, options);
  if (has_error(fit.conditions) || fit.separation != Separation::none) {
    return intervals;
  }
  const LogisticProblem problem = logistic_problem(input);
  const NewtonResult newton = maximum_of(input, problem, options.newton).newton;
  const Eigen::MatrixXd back = inverse_triangle(problem.space);
  const Eigen::LLT<Eigen::MatrixXd> information(newton.at.information);
  const double target = normal_factor(options.level);
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    const Eigen::VectorXd functional = back.row(static_cast<Eigen::Index>(k)).transpose();
    const double error = std::sqrt(functional.dot(information.solve(functional)));
    const Profile profile(problem, newton, functional, options.newton);
    const auto low = profile_end(profile, error, target, -1.0);
    const auto high = profile_end(profile, error, target, 1.0);
    if (low && high) {
      intervals[problem.space.kept[k]] = Interval{*low, *high, options.level};
    }
  }
  return intervals;
}

}  // namespace tcert
