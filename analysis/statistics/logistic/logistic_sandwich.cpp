#include <statistics/logistic/logistic_sandwich.hpp>

#include <cmath>
#include <memory>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/clusters/whitened_parts.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// The rows that are fitted, their clusters, and what each coefficient is along the basis.
struct LogisticClusters {
  LogisticProblem problem;
  CompactCodes cluster;
  Eigen::MatrixXd functionals;  ///< r x p; NaN without an estimate.
};

/// What the clusters' scores and information are at coefficients along the basis.
std::optional<SandwichParts> parts_of(const LogisticClusters& data,
                                      const Eigen::VectorXd& coefficients) {
  const Eigen::MatrixXd& basis = data.problem.space.basis;
  const Eigen::Index r = basis.cols();
  Eigen::VectorXd eta = basis * coefficients;
  if (data.problem.rows.offset.size() > 0) {
    eta += data.problem.rows.offset;
  }
  const std::size_t groups = data.cluster.count;
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(r, static_cast<Eigen::Index>(groups));
  std::vector<Eigen::MatrixXd> by_cluster(groups, Eigen::MatrixXd::Zero(r, r));
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(r, r);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const std::size_t group = data.cluster.codes[static_cast<std::size_t>(i)];
    const double share = inverse_logit(eta[i]);
    const Eigen::VectorXd x = basis.row(i).transpose();
    scores.col(static_cast<Eigen::Index>(group)) +=
        (data.problem.rows.successes[i] - data.problem.rows.trials[i] * share) * x;
    by_cluster[group] += data.problem.rows.trials[i] * share * (1.0 - share) * x * x.transpose();
  }
  for (const Eigen::MatrixXd& one : by_cluster) {
    information += one;
  }
  return whitened_parts(information, scores, by_cluster, data.functionals);
}

/// Coefficients of the columns by a maximum along a basis; NaN where there is none.
Eigen::VectorXd column_coefficients(const LogisticInput& input) {
  Eigen::VectorXd all = Eigen::VectorXd::Constant(input.design.cols(), table::kNaN);
  const LogisticProblem problem = logistic_problem(input);
  const LogisticMaximum maximum = maximum_of(input, problem, {});
  if (maximum.newton.converged() && maximum.separation.kind == Separation::none) {
    all(problem.space.kept) = inverse_triangle(problem.space) * maximum.newton.coefficients;
  }
  return all;
}

/// Along the basis, with the k-th column's coefficient held; empty without a fit.
std::optional<Eigen::VectorXd> held_at(const LogisticInput& input,
                                       const LogisticProblem& problem,
                                       std::size_t k,
                                       double value) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(input.design.cols());
  LogisticInput rest;
  rest.successes = input.successes;
  rest.trials = input.trials;
  rest.weights = input.weights;
  rest.offset = value * input.design.col(static_cast<Eigen::Index>(k));
  if (input.offset.size() > 0) {
    rest.offset += input.offset;
  }
  std::vector<std::size_t> kept;
  for (const std::size_t j : problem.space.kept) {
    if (j != k) {
      kept.push_back(j);
      rest.columns.push_back(input.columns[j]);
    }
  }
  rest.design = input.design(Eigen::all, kept);
  const Eigen::VectorXd fitted = column_coefficients(rest);
  if (!fitted.allFinite()) {
    return std::nullopt;
  }
  all(kept) = fitted;
  all[static_cast<Eigen::Index>(k)] = value;
  const Eigen::VectorXd columns = all(problem.space.kept);
  return problem.space.triangle.triangularView<Eigen::Upper>() * columns;
}

Eigen::MatrixXd without_clusters(const LogisticInput& input, const LogisticClusters& data) {
  const Eigen::Index rows = input.design.rows();
  Eigen::MatrixXd left_out(input.design.cols(), static_cast<Eigen::Index>(data.cluster.count));
  LogisticInput others;
  others.design = input.design;
  others.successes = input.successes;
  others.trials = input.trials;
  others.offset = input.offset;
  for (std::size_t group = 0; group < data.cluster.count; ++group) {
    others.weights = input.weights.size() > 0 ? input.weights : Eigen::VectorXd::Ones(rows);
    for (std::size_t i = 0; i < data.problem.used.size(); ++i) {
      if (data.cluster.codes[i] == group) {
        others.weights[data.problem.used[i]] = 0.0;  // Which leaves the row out.
      }
    }
    left_out.col(static_cast<Eigen::Index>(group)) = column_coefficients(others);
  }
  return left_out;
}

}  // namespace

std::optional<ClusteredFit> clustered_fit(const LogisticInput& input, const LogisticFit& fit) {
  if (!input.cluster || !fit.log_likelihood || fit.separation != Separation::none) {
    return std::nullopt;
  }
  auto data = std::make_shared<LogisticClusters>();
  data->problem = logistic_problem(input);
  const LogisticProblem& problem = data->problem;
  std::vector<std::uint32_t> codes;
  for (const Eigen::Index row : problem.used) {
    codes.push_back(input.cluster->codes[static_cast<std::size_t>(row)]);
  }
  data->cluster = compact_codes(codes);
  const auto r = static_cast<double>(problem.space.rank());
  if (static_cast<double>(data->cluster.count) * r * r > kMostShareNumbers) {
    return std::nullopt;
  }
  const Eigen::MatrixXd back = inverse_triangle(problem.space);
  data->functionals =
      Eigen::MatrixXd::Constant(problem.space.rank(), input.design.cols(), table::kNaN);
  Eigen::VectorXd estimates = Eigen::VectorXd::Constant(input.design.cols(), table::kNaN);
  for (std::size_t j = 0; j < problem.space.kept.size(); ++j) {
    const std::size_t column = problem.space.kept[j];
    if (fit.coefficients[column].estimate) {
      estimates[static_cast<Eigen::Index>(column)] = *fit.coefficients[column].estimate;
      data->functionals.col(static_cast<Eigen::Index>(column)) =
          back.row(static_cast<Eigen::Index>(j)).transpose();
    }
  }
  const LogisticMaximum maximum = maximum_of(input, problem, fit.options.newton);
  auto parts = parts_of(*data, maximum.newton.coefficients);
  if (!parts) {
    return std::nullopt;
  }
  ClusteredFit clustered;
  clustered.parts = std::move(*parts);
  clustered.parts.estimates = std::move(estimates);
  clustered.parts_at = [&input, data](std::size_t k, double value) -> std::optional<SandwichParts> {
    const auto held = held_at(input, data->problem, k, value);
    return held ? parts_of(*data, *held) : std::nullopt;
  };
  clustered.left_out = [&input, data] { return without_clusters(input, *data); };
  return clustered;
}

ClusterInferences cluster_inferences(const LogisticInput& input,
                                     const LogisticFit& fit,
                                     std::optional<ClusterInference> inference,
                                     const WildOptions& options) {
  if (const auto clustered = clustered_fit(input, fit)) {
    return cluster_inferences(*clustered, inference, options);
  }
  ClusterInferences uncorrected{ClusterInference::cr1, {}, fit.covariance};
  if (fit.clusters > 1) {
    uncorrected.covariance *=
        static_cast<double>(fit.clusters) / (static_cast<double>(fit.clusters) - 1.0);
  }
  for (const LogisticCoefficient& one : fit.coefficients) {
    uncorrected.of.push_back(
        cr1_estimate(one.estimate, one.standard_error, fit.clusters, options.level));
  }
  return uncorrected;
}

}  // namespace tcert::statistics
