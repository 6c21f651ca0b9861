#include <statistics/glmm/glmm_profile.hpp>

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <statistics/basics/normal.hpp>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/glmm_solve.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

/// One number to be profiled: functional' parameters.
struct Target {
  Eigen::VectorXd functional;
  bool is_sd = false;
  double error = 0.0;  ///< About its standard error.
};

/// The likelihood along the target, maximised over the rest.
class Profile {
 public:
  Profile(const GlmmProblem& problem,
          int quadrature,
          const Target& target,
          const GlmmMaximum& maximum,
          const GlmmOptions& options)
      : likelihood_(problem.likelihood(quadrature)),
        options_(options),
        functional_(target.functional),
        highest_(maximum.at.value),
        at_(maximum) {
    // A reflection that takes the functional to the first axis: its other columns are orthonormal
    // and orthogonal to it.
    Eigen::VectorXd mirror = functional_.normalized();
    mirror[0] += mirror[0] < 0.0 ? -1.0 : 1.0;
    const Eigen::Index size = functional_.size();
    others_ = (Eigen::MatrixXd::Identity(size, size) -
               (2.0 / mirror.squaredNorm()) * mirror * mirror.transpose())
                  .rightCols(size - 1);
  }

  /// Maximises over the rest with the target at `to`; false if that fails.
  bool move(double to) {
    // Along the line on which the others stay best as far as the curvature here can tell.
    Eigen::VectorXd line = (-at_.at.hessian).fullPivLu().solve(functional_);
    if (!line.allFinite() || !(functional_.dot(line) > 0.0)) {
      line = functional_;
    }
    const Eigen::VectorXd start = at_.parameters + line * ((to - value()) / functional_.dot(line));
    GlmmMaximum next = newton_maximum(*likelihood_, start, others_, options_);
    if (!next.converged()) {
      return false;
    }
    at_ = std::move(next);
    return true;
  }

  [[nodiscard]] double value() const { return functional_.dot(at_.parameters); }
  [[nodiscard]] double root() const {
    return std::sqrt(2.0 * std::max(0.0, highest_ - at_.at.value));
  }
  /// Of the log-likelihood by the target: the others' gradient is 0 here.
  [[nodiscard]] double slope() const {
    return functional_.dot(at_.at.gradient) / functional_.squaredNorm();
  }

 private:
  std::unique_ptr<MixedLikelihood> likelihood_;
  const GlmmOptions& options_;
  Eigen::VectorXd functional_;
  Eigen::MatrixXd others_;
  double highest_;
  GlmmMaximum at_;
};

/// Where the root of the drop is `wanted`, below (`sign` -1) or above the estimate. The root is
/// nearly linear in the target, so Newton's method needs a few steps; they are kept within the
/// bracket found so far.
std::optional<double> profile_end(Profile& profile,
                                  const Target& target,
                                  double wanted,
                                  double sign) {
  double inside = profile.value();
  double outside = sign * std::numeric_limits<double>::infinity();
  double next = inside + sign * wanted * target.error;
  if (target.is_sd && sign < 0.0) {
    if (inside == 0.0 || !profile.move(0.0)) {
      return inside == 0.0 ? std::optional(0.0) : std::nullopt;
    }
    if (profile.root() <= wanted) {
      return 0.0;
    }
    outside = 0.0;
    next = std::max(next, 0.3 * inside);
  }
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (!profile.move(next)) {
      return std::nullopt;
    }
    const double root = profile.root();
    if (std::abs(root - wanted) <= 1e-9 * wanted) {
      return next;
    }
    (root < wanted ? inside : outside) = next;
    next += (root - wanted) * root / profile.slope();
    const bool within = (next - inside) * sign > 0.0 && (outside - next) * sign > 0.0;
    if (!within) {
      next =
          std::isfinite(outside) ? 0.5 * (inside + outside) : inside + sign * wanted * target.error;
    }
  }
  return std::nullopt;
}

/// About the standard error of each parameter: from its own curvature where all together fail.
double error_of(const Eigen::VectorXd& functional, const Eigen::MatrixXd& hessian) {
  const double variance = functional.dot((-hessian).fullPivLu().solve(functional));
  if (variance > 0.0 && std::isfinite(variance)) {
    return std::sqrt(variance);
  }
  const double curvature = std::abs(functional.dot(hessian * functional));
  return curvature > 0.0 ? functional.squaredNorm() / std::sqrt(curvature) : 1.0;
}

/// The coefficients that are estimated, then the terms of one column.
std::vector<Target> targets_of(const GlmmProblem& problem, const GlmmMaximum& maximum) {
  std::vector<Target> targets;
  const Eigen::Index size = problem.size();
  const Eigen::Index rank = problem.fixed.space.rank();
  const Eigen::MatrixXd back = inverse_triangle(problem.fixed.space);
  for (Eigen::Index k = 0; k < rank; ++k) {
    Target target;
    target.functional.setZero(size);
    target.functional.tail(rank) = back.row(k).transpose();
    targets.push_back(std::move(target));
  }
  Eigen::Index at = 0;
  for (const TermRows& term : problem.terms) {
    if (term.thetas() == 1) {
      Target target;
      target.functional.setZero(size);
      target.functional[at] = 1.0 / term.scale[0];
      target.is_sd = true;
      targets.push_back(std::move(target));
    }
    at += term.thetas();
  }
  for (Target& target : targets) {
    target.error = error_of(target.functional, maximum.at.hessian);
  }
  return targets;
}

GlmmProfile laid_out(const GlmmProblem& problem,
                     const std::vector<std::optional<Interval>>& intervals,
                     GlmmProfile profile) {
  std::size_t next = 0;
  for (const std::size_t column : problem.fixed.space.kept) {
    profile.coefficients[column] = intervals[next++];
  }
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    if (problem.terms[t].thetas() == 1) {
      profile.sds[t] = intervals[next++];
    }
  }
  return profile;
}

}  // namespace

GlmmProfile glmm_profile(const GlmmInput& input,
                         const GlmmOptions& options,
                         const GlmmProfileWatch& watch) {
  GlmmProfile profile;
  profile.coefficients.resize(input.fixed.columns.size());
  profile.sds.resize(input.random.size());
  Conditions conditions;
  const std::optional<GlmmProblem> problem = glmm_problem(input, options, conditions);
  if (!problem) {
    return profile;
  }
  const int quadrature =
      options.quadrature.value_or(problem->single_intercept() ? kDefaultQuadrature : 1);
  const GlmmMaximum maximum = solve(*problem, quadrature, options);
  if (!maximum.converged()) {
    return profile;
  }
  const std::vector<Target> targets = targets_of(*problem, maximum);
  const double wanted = normal_factor(options.level);
  std::vector<std::optional<double>> ends(2 * targets.size());
  if (watch.started) {
    watch.started(ends.size());
  }
  std::mutex watching;
  tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t k) {
    const Target& target = targets[k / 2];
    Profile along(*problem, quadrature, target, maximum, options);
    ends[k] = profile_end(along, target, wanted, k % 2 == 0 ? -1.0 : 1.0);
    if (watch.advance) {
      const std::lock_guard<std::mutex> lock(watching);
      watch.advance();
    }
  });
  std::vector<std::optional<Interval>> intervals(targets.size());
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (ends[2 * k] && ends[2 * k + 1]) {
      intervals[k] = Interval{*ends[2 * k], *ends[2 * k + 1], options.level};
    }
  }
  return laid_out(*problem, intervals, std::move(profile));
}

}  // namespace tcert::statistics
