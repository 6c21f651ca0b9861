#include <statistics/logistic/one_sided_limit.hpp>

#include <cmath>
#include <limits>
#include <statistics/basics/normal.hpp>
#include <statistics/logistic/separation.hpp>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

/// The input without a column and without those that `problem` dropped.
LogisticInput without_column(const LogisticInput& input,
                             const LogisticProblem& problem,
                             std::size_t column) {
  LogisticInput rest = input;
  std::vector<Eigen::Index> kept;
  rest.columns.clear();
  rest.term_of.clear();
  for (const std::size_t j : problem.space.kept) {
    if (j != column) {
      kept.push_back(static_cast<Eigen::Index>(j));
      rest.columns.push_back(input.columns[j]);
      rest.term_of.push_back(input.term_of[j]);
    }
  }
  rest.design = input.design(Eigen::all, kept);
  return rest;
}

/// The log-likelihood with one coefficient held, maximised over the others.
class HeldProfile {
 public:
  HeldProfile(const LogisticInput& input,
              const LogisticProblem& problem,
              std::size_t column,
              const NewtonOptions& options)
      : options_(options) {
    const LogisticInput rest = without_column(input, problem, column);
    part_ = logistic_problem(rest);
    // Offsets do not move the directions of recession, so one answer serves all values.
    const SeparationResult separation =
        find_separation(part_.space.basis, part_.rows.successes, part_.rows.trials);
    if (separation.kind != Separation::none) {
      part_ = part_of(rest, part_, separation.overlaps);
    }
    held_ = input.design(part_.used, static_cast<Eigen::Index>(column));
    offset_ = part_.rows.offset.size() > 0 ? part_.rows.offset
                                           : Eigen::VectorXd(Eigen::VectorXd::Zero(held_.size()));
  }

  /// False if the others cannot be maximised there.
  bool move(double to) {
    part_.rows.offset = offset_ + to * held_;
    NewtonResult next = maximise(start_ ? *start_ : starting_point(part_));
    if (!next.converged() && start_) {
      next = maximise(starting_point(part_));
    }
    if (!next.converged()) {
      return false;
    }
    value_ = next.at.log_likelihood;
    const Eigen::VectorXd eta = part_.space.basis * next.coefficients + part_.rows.offset;
    slope_ = 0.0;
    for (Eigen::Index i = 0; i < held_.size(); ++i) {
      slope_ += (part_.rows.successes[i] - part_.rows.trials[i] * inverse_logit(eta[i])) * held_[i];
    }
    start_ = std::move(next.coefficients);
    return true;
  }

  [[nodiscard]] double value() const noexcept { return value_; }
  /// By the held coefficient: the others' gradient is 0.
  [[nodiscard]] double slope() const noexcept { return slope_; }
  /// One over the range of the held column, or over its size if it is constant.
  [[nodiscard]] double unit() const {
    if (held_.size() == 0) {
      return 1.0;
    }
    const double range = held_.maxCoeff() - held_.minCoeff();
    const double size = range > 0.0 ? range : held_.cwiseAbs().maxCoeff();
    return size > 0.0 ? 1.0 / size : 1.0;
  }

 private:
  [[nodiscard]] NewtonResult maximise(const Eigen::VectorXd& start) const {
    return maximise_binomial(part_.space.basis, part_.rows, start, std::nullopt, options_);
  }

  const NewtonOptions& options_;
  LogisticProblem part_;
  Eigen::VectorXd held_;
  Eigen::VectorXd offset_;
  std::optional<Eigen::VectorXd> start_;
  double value_ = 0.0;
  double slope_ = 0.0;
};

}  // namespace

std::optional<double> one_sided_limit(const LogisticInput& input,
                                      const LogisticProblem& problem,
                                      std::size_t column,
                                      double sign,
                                      double supremum,
                                      const LogisticOptions& options) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  HeldProfile profile(input, problem, column, options.newton);
  const double factor = normal_factor(options.level);
  const double wanted = factor * factor;
  // Along u = sign * coefficient the drop falls from infinity to 0.
  double below = -kInfinity;  // too large a drop
  double above = kInfinity;   // too small a one
  double step = profile.unit();
  double u = 0.0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (!profile.move(sign * u)) {
      return std::nullopt;
    }
    const double drop = 2.0 * (supremum - profile.value());
    if (std::abs(std::sqrt(std::max(0.0, drop)) - factor) <= 1e-9 * factor) {
      return sign * u;
    }
    (drop > wanted ? below : above) = u;
    // Newton's method on the logarithm of the drop, which is straight where the drop fades.
    const double rate = -2.0 * sign * profile.slope() / drop;
    double next = u - std::log(drop / wanted) / rate;
    if (!std::isfinite(below) || !std::isfinite(above)) {
      const double outward = std::isfinite(below) ? step : -step;
      const bool takes = std::isfinite(next) && (next - u) * outward > 0.0 &&
                         std::abs(next - u) <= std::abs(4.0 * outward);
      next = takes ? next : u + outward;
      step *= 2.0;
    } else if (!(next > below && next < above)) {
      next = 0.5 * (below + above);
    }
    u = next;
  }
  return std::nullopt;
}

}  // namespace tcert::statistics
