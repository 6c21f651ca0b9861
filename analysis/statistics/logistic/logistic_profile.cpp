#include <statistics/logistic/logistic_profile.hpp>

#include <statistics/logistic/likelihood_profile.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <statistics/logistic/one_sided_limit.hpp>

namespace tcert::statistics {
namespace {

ProfilePoint point_of(const NewtonResult& newton) {
  return {newton.coefficients, newton.at.log_likelihood, newton.at.gradient, newton.at.information};
}

/// Limits of the coefficients that the solved problem determines.
class SolvedProfile {
 public:
  SolvedProfile(const LogisticProblem& solved,
                const NewtonResult& newton,
                const LogisticOptions& options)
      : level_(options.level),
        maximum_(point_of(newton)),
        back_(inverse_triangle(solved.space)),
        maximise_([&](const Eigen::VectorXd& start, const Eigen::MatrixXd& subspace) {
          const NewtonResult result =
              maximise_binomial(solved.space.basis, solved.rows, start, subspace, options.newton);
          return result.converged() ? std::optional(point_of(result)) : std::nullopt;
        }) {}

  /// Of kept column `k`.
  [[nodiscard]] ProfileLimits limits(Eigen::Index k, bool ran_away) const {
    const Eigen::VectorXd functional = back_.row(k).transpose();
    const auto end = [&](double sign) {
      return profile_end(maximum_, functional, maximise_, level_, sign);
    };
    ProfileLimits limits;
    const bool positive = functional.dot(maximum_.coefficients) >= 0.0;
    limits.open_low = ran_away && !positive;
    limits.open_high = ran_away && positive;
    limits.low = limits.open_low ? std::nullopt : end(-1.0);
    limits.high = limits.open_high ? std::nullopt : end(1.0);
    return limits;
  }

 private:
  double level_;
  ProfilePoint maximum_;
  Eigen::MatrixXd back_;
  ConstrainedMaximum maximise_;
};

}  // namespace

std::vector<ProfileLimits> profile_limits(const LogisticInput& input,
                                          const LogisticOptions& options,
                                          const std::function<void()>& advance) {
  std::vector<ProfileLimits> all(input.columns.size());
  const LogisticFit fit = fit_logistic(input, options);
  if (!fit.log_likelihood) {
    return all;
  }
  const LogisticProblem problem = logistic_problem(input);
  const LogisticMaximum maximum = maximum_of(input, problem, options.newton);
  const LogisticProblem& solved = maximum.solved(problem);
  const SolvedProfile profile(solved, maximum.newton, options);
  // Where each column of the input stands among the kept ones of the solved problem.
  std::vector<std::optional<Eigen::Index>> place(input.columns.size());
  for (std::size_t k = 0; k < solved.space.kept.size(); ++k) {
    const std::size_t j = solved.space.kept[k];
    place[fit.separation == Separation::none ? j : problem.space.kept[j]] =
        static_cast<Eigen::Index>(k);
  }
  for (std::size_t j = 0; j < all.size(); ++j) {
    const CoefficientKind kind = fit.coefficients[j].kind;
    const bool up = kind == CoefficientKind::plus_infinity;
    if (up || kind == CoefficientKind::minus_infinity) {
      (up ? all[j].open_high : all[j].open_low) = true;
      (up ? all[j].low : all[j].high) = one_sided_limit(
          input, problem, j, up ? 1.0 : -1.0, maximum.newton.at.log_likelihood, options);
    } else if (kind == CoefficientKind::diverging) {
      all[j].open_low = all[j].open_high = true;
    } else if (place[j] && (kind == CoefficientKind::finite || kind == CoefficientKind::ran_away)) {
      all[j] = profile.limits(*place[j], kind == CoefficientKind::ran_away);
    }
    if (advance) {
      advance();
    }
  }
  return all;
}

std::vector<std::optional<Interval>> profile_intervals(const LogisticInput& input,
                                                       const LogisticOptions& options) {
  std::vector<std::optional<Interval>> intervals;
  for (const ProfileLimits& one : profile_limits(input, options)) {
    intervals.push_back(one.low && one.high
                            ? std::optional(Interval{*one.low, *one.high, options.level})
                            : std::nullopt);
  }
  return intervals;
}

double profile_work(const LogisticInput& input) {
  const auto rows = static_cast<double>(input.design.rows());
  const auto columns = static_cast<double>(input.design.cols());
  return rows * columns * (columns * columns + 40.0);
}

}  // namespace tcert::statistics
