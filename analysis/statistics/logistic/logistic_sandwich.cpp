#include <statistics/logistic/logistic_sandwich.hpp>

#include <algorithm>
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
  Eigen::VectorXd estimates;    ///< p; NaN likewise.
  std::vector<std::string> names;
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

/// The same where the maximum lies at infinity: coefficients that stay finite beside those that do
/// not. `cause` says why any is missing.
Eigen::VectorXd finite_coefficients(const LogisticInput& input, std::string& cause) {
  const LogisticFit fit = fit_logistic(input);
  Eigen::VectorXd all = Eigen::VectorXd::Constant(input.design.cols(), table::kNaN);
  for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
    all[static_cast<Eigen::Index>(j)] = fit.coefficients[j].estimate.value_or(table::kNaN);
  }
  const auto worst = std::max_element(
      fit.conditions.begin(), fit.conditions.end(), [](const Condition& a, const Condition& b) {
        return a.severity < b.severity;
      });
  cause = worst == fit.conditions.end() ? "" : std::string(words(worst->kind));
  return all;
}

LeftOut without_clusters(const LogisticInput& input, const LogisticClusters& data) {
  const Eigen::Index rows = input.design.rows();
  LeftOut left_out;
  left_out.values.resize(input.design.cols(), static_cast<Eigen::Index>(data.cluster.count));
  left_out.causes.resize(data.cluster.count);
  LogisticInput others;
  others.design = input.design;
  others.successes = input.successes;
  others.trials = input.trials;
  others.offset = input.offset;
  others.columns = input.columns;
  others.term_of = input.term_of;
  others.terms = input.terms;
  for (std::size_t group = 0; group < data.cluster.count; ++group) {
    others.weights = input.weights.size() > 0 ? input.weights : Eigen::VectorXd::Ones(rows);
    for (std::size_t i = 0; i < data.problem.used.size(); ++i) {
      if (data.cluster.codes[i] == group) {
        others.weights[data.problem.used[i]] = 0.0;  // Which leaves the row out.
      }
    }
    Eigen::VectorXd refit = column_coefficients(others);
    if (!refit.allFinite()) {
      refit = finite_coefficients(others, left_out.causes[group]);
    }
    left_out.values.col(static_cast<Eigen::Index>(group)) = refit;
  }
  return left_out;
}

/// Null unless the fit has what is corrected.
std::shared_ptr<LogisticClusters> clusters_of(const LogisticInput& input, const LogisticFit& fit) {
  if (!input.cluster || !fit.log_likelihood || fit.separation != Separation::none) {
    return nullptr;
  }
  auto data = std::make_shared<LogisticClusters>();
  data->problem = logistic_problem(input);
  const LogisticProblem& problem = data->problem;
  std::vector<std::uint32_t> codes;
  for (const Eigen::Index row : problem.used) {
    codes.push_back(input.cluster->codes[static_cast<std::size_t>(row)]);
  }
  data->cluster = compact_codes(codes);
  data->names = cluster_names(*input.cluster, codes, data->cluster);
  const Eigen::MatrixXd back = inverse_triangle(problem.space);
  data->functionals =
      Eigen::MatrixXd::Constant(problem.space.rank(), input.design.cols(), table::kNaN);
  data->estimates = Eigen::VectorXd::Constant(input.design.cols(), table::kNaN);
  for (std::size_t j = 0; j < problem.space.kept.size(); ++j) {
    const std::size_t column = problem.space.kept[j];
    if (fit.coefficients[column].estimate) {
      data->estimates[static_cast<Eigen::Index>(column)] = *fit.coefficients[column].estimate;
      data->functionals.col(static_cast<Eigen::Index>(column)) =
          back.row(static_cast<Eigen::Index>(j)).transpose();
    }
  }
  return data;
}

std::optional<ClusteredFit> with_parts(const LogisticInput& input,
                                       const LogisticFit& fit,
                                       const std::shared_ptr<LogisticClusters>& data) {
  if (!data) {
    return std::nullopt;
  }
  const auto r = static_cast<double>(data->problem.space.rank());
  if (static_cast<double>(data->cluster.count) * r * r > kMostShareNumbers) {
    return std::nullopt;
  }
  const LogisticMaximum maximum = maximum_of(input, data->problem, fit.options.newton);
  auto parts = parts_of(*data, maximum.newton.coefficients);
  if (!parts) {
    return std::nullopt;
  }
  ClusteredFit clustered;
  clustered.parts = std::move(*parts);
  clustered.parts.estimates = data->estimates;
  clustered.names = data->names;
  clustered.parts_at = [&input, data](std::size_t k, double value) -> std::optional<SandwichParts> {
    const auto held = held_at(input, data->problem, k, value);
    return held ? parts_of(*data, *held) : std::nullopt;
  };
  clustered.left_out = [&input, data] { return without_clusters(input, *data); };
  return clustered;
}

}  // namespace

std::optional<ClusteredFit> clustered_fit(const LogisticInput& input, const LogisticFit& fit) {
  return with_parts(input, fit, clusters_of(input, fit));
}

ClusterInferences cluster_inferences(const LogisticInput& input,
                                     const LogisticFit& fit,
                                     std::optional<ClusterInference> inference,
                                     const WildOptions& options) {
  const auto clusters = clusters_of(input, fit);
  if (const auto clustered = with_parts(input, fit, clusters)) {
    return cluster_inferences(*clustered, inference, options);
  }
  const auto by = inference.value_or(default_inference(fit.clusters));
  if (by == ClusterInference::jackknife && clusters) {
    return by_jackknife(
        clusters->estimates, without_clusters(input, *clusters), clusters->names, options.level);
  }
  if (inference && by != ClusterInference::cr1 && fit.log_likelihood) {
    return not_to_be_had(
        by,
        fit.coefficients.size(),
        clusters ? "too many clusters and columns at once" : "the fit has no finite maximum");
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
