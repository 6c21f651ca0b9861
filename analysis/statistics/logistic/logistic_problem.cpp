#include <statistics/logistic/logistic_problem.hpp>

#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {
namespace {

Eigen::VectorXd gathered(const Eigen::VectorXd& values, const std::vector<Eigen::Index>& rows) {
  return values.size() > 0 ? Eigen::VectorXd(values(rows)) : values;
}

std::vector<Eigen::Index> used_rows(const LogisticInput& input) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index i = 0; i < input.successes.size(); ++i) {
    if ((input.trials.size() == 0 || input.trials[i] > 0.0) &&
        (input.weights.size() == 0 || input.weights[i] > 0.0)) {
      used.push_back(i);
    }
  }
  return used;
}

}  // namespace

LogisticProblem part_of(const LogisticInput& input,
                        const LogisticProblem& problem,
                        const std::vector<bool>& keep) {
  LogisticProblem part;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) {
      rows.push_back(static_cast<Eigen::Index>(i));
      part.used.push_back(problem.used[i]);
    }
  }
  part.rows.successes = gathered(problem.rows.successes, rows);
  part.rows.trials = gathered(problem.rows.trials, rows);
  part.rows.offset = gathered(problem.rows.offset, rows);
  part.space = orthonormal_basis(input.design(part.used, problem.space.kept));
  return part;
}

LogisticProblem logistic_problem(const LogisticInput& input) {
  LogisticProblem problem;
  problem.rows.successes = input.successes;
  problem.rows.trials =
      input.trials.size() > 0 ? input.trials : Eigen::VectorXd::Ones(input.successes.size());
  problem.rows.offset = input.offset;
  Eigen::VectorXd weights = input.weights;
  std::vector<Eigen::Index> used = used_rows(input);
  if (static_cast<Eigen::Index>(used.size()) == input.successes.size()) {
    problem.space = orthonormal_basis(input.design);
  } else {
    problem.rows.successes = gathered(problem.rows.successes, used);
    problem.rows.trials = gathered(problem.rows.trials, used);
    problem.rows.offset = gathered(problem.rows.offset, used);
    weights = gathered(weights, used);
    problem.space = orthonormal_basis(input.design(used, Eigen::all));
  }
  problem.used = std::move(used);
  problem.log_coefficients =
      log_binomial_coefficients(problem.rows.successes, problem.rows.trials, weights);
  if (weights.size() > 0) {
    problem.rows.successes.array() *= weights.array();
    problem.rows.trials.array() *= weights.array();
  }
  problem.saturated = saturated_log_likelihood(problem.rows);
  return problem;
}

Eigen::VectorXd starting_point(const LogisticProblem& problem) {
  const Eigen::MatrixXd& basis = problem.space.basis;
  const Eigen::Index rank = problem.space.rank();
  if (problem.rows.offset.size() == 0 || rank == 0) {
    return Eigen::VectorXd::Zero(rank);
  }
  const Eigen::ArrayXd share =
      (problem.rows.successes.array() + 0.5) / (problem.rows.trials.array() + 1.0);
  const Eigen::VectorXd weight = problem.rows.trials.array() * share * (1.0 - share);
  const Eigen::VectorXd wanted = (share / (1.0 - share)).log() - problem.rows.offset.array();
  const Eigen::MatrixXd normal = basis.transpose() * weight.asDiagonal() * basis;
  return solve_symmetric(normal, basis.transpose() * weight.cwiseProduct(wanted));
}

LogisticMaximum maximum_of(const LogisticInput& input,
                           const LogisticProblem& problem,
                           const NewtonOptions& options) {
  LogisticMaximum maximum;
  bool asked = false;
  const auto separated = [&] {
    asked = true;
    maximum.separation =
        find_separation(problem.space.basis, problem.rows.successes, problem.rows.trials);
    return maximum.separation.kind != Separation::none;
  };
  maximum.newton = maximise_binomial(
      problem.space.basis, problem.rows, starting_point(problem), std::nullopt, options, separated);
  if (!maximum.newton.converged() && !asked) {
    separated();
  }
  if (maximum.separation.kind == Separation::none) {
    return maximum;
  }
  maximum.limit = part_of(input, problem, maximum.separation.overlaps);
  maximum.newton = maximise_binomial(maximum.limit.space.basis,
                                     maximum.limit.rows,
                                     starting_point(maximum.limit),
                                     std::nullopt,
                                     options);
  return maximum;
}

Eigen::MatrixXd inverse_triangle(const OrthonormalBasis& space) {
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(space.rank(), space.rank());
  if (space.rank() > 0) {
    space.triangle.triangularView<Eigen::Upper>().solveInPlace(inverse);
  }
  return inverse;
}

}  // namespace tcert::statistics
