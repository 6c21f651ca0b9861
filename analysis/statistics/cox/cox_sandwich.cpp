#include <statistics/cox/cox_sandwich.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/clusters/whitened_parts.hpp>
#include <statistics/cox/cox_hazard_steps.hpp>
#include <statistics/cox/cox_likelihood.hpp>
#include <statistics/cox/cox_robust.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

struct CoxClusters {
  CoxRows rows;
  table::Factor cluster;  ///< Compact: n codes.
  std::size_t count = 0;
  std::vector<std::string> names;
  Ties ties = Ties::efron;
  std::vector<Eigen::Index> ranked;  ///< Columns with an estimate in the likelihood.
  Eigen::MatrixXd functionals;       ///< r x p.
  Eigen::VectorXd estimates;         ///< p.
};

/// Cumulative sums over event times of the hazard, and of it times the mean and its square.
struct CumulativeMeans {
  std::vector<double> hazard;         ///< T + 1, with 0 before each stratum's first time.
  std::vector<Eigen::VectorXd> mean;  ///< Likewise.
  std::vector<Eigen::MatrixXd> square;
};

CumulativeMeans cumulative_means(const CoxRows& rows, const HazardSteps& steps) {
  const auto p = static_cast<Eigen::Index>(rows.columns);
  CumulativeMeans sums;
  sums.hazard.assign(rows.sets.times() + 1, 0.0);
  sums.mean.assign(rows.sets.times() + 1, Eigen::VectorXd::Zero(p));
  sums.square.assign(rows.sets.times() + 1, Eigen::MatrixXd::Zero(p, p));
  // Differences are taken within a stratum, so that sums may go on from one to the next.
  for (std::size_t t = 0; t < rows.sets.times(); ++t) {
    const Eigen::Map<const Eigen::VectorXd> mean(steps.mean.data() + t * rows.columns, p);
    sums.hazard[t + 1] = sums.hazard[t] + steps.hazard[t];
    sums.mean[t + 1] = sums.mean[t] + steps.hazard[t] * mean;
    sums.square[t + 1] = sums.square[t] + steps.hazard[t] * mean * mean.transpose();
  }
  return sums;
}

std::vector<Eigen::MatrixXd> information_by_cluster(const CoxClusters& data,
                                                    const Eigen::VectorXd& beta) {
  const CoxRows& rows = data.rows;
  const auto p = static_cast<Eigen::Index>(rows.columns);
  const HazardSteps steps = hazard_increments(rows, beta, data.ties);
  const CumulativeMeans sums = cumulative_means(rows, steps);
  std::vector<Eigen::MatrixXd> by_cluster(data.count, Eigen::MatrixXd::Zero(p, p));
  Eigen::VectorXd mean(p);
  for (std::size_t place = 0; place < rows.rows(); ++place) {
    const std::uint32_t row = rows.sets.order[place];
    const std::size_t end = rows.sets.last[row] + 1U;
    const std::size_t begin = rows.sets.first[row];
    const double* const x = rows.row(place);
    const double hazard = sums.hazard[end] - sums.hazard[begin];
    const double risk = rows.weight_of(place) * steps.risks.score[place];
    const Eigen::MatrixXd& square_end = sums.square[end];
    const Eigen::MatrixXd& square_begin = sums.square[begin];
    mean = sums.mean[end] - sums.mean[begin];
    Eigen::MatrixXd& one = by_cluster[data.cluster.codes[row]];
    for (Eigen::Index b = 0; b < p; ++b) {
      for (Eigen::Index a = b; a < p; ++a) {
        one(a, b) += risk * (hazard * x[a] * x[b] - x[a] * mean(b) - mean(a) * x[b] +
                             square_end(a, b) - square_begin(a, b));
      }
    }
  }
  for (Eigen::MatrixXd& one : by_cluster) {
    const Eigen::MatrixXd whole = one.selfadjointView<Eigen::Lower>();
    one = whole(data.ranked, data.ranked);
  }
  return by_cluster;
}

/// `beta` of the scaled columns.
std::optional<SandwichParts> parts_of(const CoxClusters& data, const Eigen::VectorXd& beta) {
  const ClusterScores scores = cluster_scores(data.rows, beta, data.ties, &data.cluster);
  const Eigen::MatrixXd information = cox_derivatives(data.rows, beta, data.ties).information;
  return whitened_parts(information(data.ranked, data.ranked),
                        scores.sums(data.ranked, Eigen::all),
                        information_by_cluster(data, beta),
                        data.functionals);
}

CoxOptions of_refits(Ties ties) {
  CoxOptions options;
  options.ties = ties;
  options.inference = false;
  return options;
}

/// Coefficients with the k-th held; empty without a fit.
std::optional<Eigen::VectorXd> held_at(const CoxData& data,
                                       const CoxClusters& clusters,
                                       Eigen::Index k,
                                       double value) {
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(data.design.cols());
  beta(k) = value;
  CoxData rest = data;
  rest.cluster.reset();
  const Eigen::VectorXd offset = value * data.design.col(k);
  rest.offset = data.offset ? Eigen::VectorXd(*data.offset + offset) : offset;
  std::vector<Eigen::Index> kept;
  rest.columns.clear();
  rest.term_of.clear();
  for (const Eigen::Index j : clusters.ranked) {
    if (j != k) {
      kept.push_back(j);
      rest.columns.push_back(data.columns[static_cast<std::size_t>(j)]);
      rest.term_of.push_back(data.term_of[static_cast<std::size_t>(j)]);
    }
  }
  if (kept.empty()) {
    return beta;
  }
  rest.design = data.design(Eigen::all, kept);
  const CoxFit fit = fit_cox(rest, of_refits(clusters.ties));
  if (fit.summary.termination != CoxTermination::converged) {
    return std::nullopt;
  }
  beta(kept) = fit.beta;
  return beta;
}

/// Why a refit has not all coefficients; empty if it has.
std::string lack_of(const CoxFit& fit) {
  if (fit.summary.termination != CoxTermination::converged) {
    return std::string(to_string(fit.summary.termination));
  }
  const bool whole = std::all_of(
      fit.estimated.begin(), fit.estimated.end(), [](bool estimated) { return estimated; });
  return whole ? "" : "a constant or collinear column";
}

LeftOut without_clusters(const CoxData& data, const CoxClusters& clusters) {
  LeftOut left_out{Eigen::MatrixXd::Constant(
                       data.design.cols(), static_cast<Eigen::Index>(clusters.count), table::kNaN),
                   {}};
  for (std::size_t group = 0; group < clusters.count; ++group) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < data.rows(); ++row) {
      if (clusters.cluster.codes[row] != group) {
        rows.push_back(row);
      }
    }
    CoxData others = on_rows(data, rows);
    others.cluster.reset();
    const CoxFit fit = fit_cox(others, of_refits(clusters.ties));
    left_out.causes.push_back(lack_of(fit));
    // Beside a coefficient that runs to infinity the others have their limits.
    const bool has_numbers = fit.summary.termination == CoxTermination::converged ||
                             (fit.summary.termination == CoxTermination::monotone && fit.at_limit);
    for (Eigen::Index j = 0; has_numbers && j < fit.beta.size(); ++j) {
      if (fit.estimated[static_cast<std::size_t>(j)]) {
        left_out.values(j, static_cast<Eigen::Index>(group)) = fit.beta(j);
      }
    }
  }
  return left_out;
}

/// Null unless the fit has what is corrected.
std::shared_ptr<CoxClusters> clusters_of(const CoxData& data, const CoxFit& fit) {
  if (!data.cluster || fit.ties == Ties::exact ||
      fit.summary.termination != CoxTermination::converged || fit.coefficients.empty()) {
    return nullptr;
  }
  auto clusters = std::make_shared<CoxClusters>();
  CompactCodes codes = compact_codes(data.cluster->codes);
  clusters->count = codes.count;
  clusters->names = cluster_names(*data.cluster, data.cluster->codes, codes);
  clusters->cluster.codes = std::move(codes.codes);
  clusters->cluster.levels.resize(clusters->count);
  clusters->rows = cox_rows(data);
  clusters->ties = fit.ties;
  const Eigen::Index p = data.design.cols();
  for (Eigen::Index j = 0; j < p; ++j) {
    if (fit.estimated[static_cast<std::size_t>(j)]) {
      clusters->ranked.push_back(j);
    }
  }
  const auto r = static_cast<Eigen::Index>(clusters->ranked.size());
  clusters->functionals = Eigen::MatrixXd::Constant(r, p, table::kNaN);
  clusters->estimates = Eigen::VectorXd::Constant(p, table::kNaN);
  for (Eigen::Index j = 0; j < r; ++j) {
    const Eigen::Index column = clusters->ranked[static_cast<std::size_t>(j)];
    if (const auto estimate = fit.coefficients[static_cast<std::size_t>(column)].estimate) {
      clusters->estimates(column) = *estimate;
      clusters->functionals.col(column).setZero();
      clusters->functionals(j, column) = 1.0 / clusters->rows.scale(column);
    }
  }
  return clusters;
}

std::optional<ClusteredFit> with_parts(const CoxData& data,
                                       const CoxFit& fit,
                                       const std::shared_ptr<CoxClusters>& clusters) {
  if (!clusters) {
    return std::nullopt;
  }
  const auto p = static_cast<double>(data.design.cols());
  if (static_cast<double>(clusters->count + clusters->rows.sets.times()) * p * p >
      kMostShareNumbers) {
    return std::nullopt;
  }
  auto parts = parts_of(*clusters, fit.beta.cwiseProduct(clusters->rows.scale));
  if (!parts) {
    return std::nullopt;
  }
  ClusteredFit clustered;
  clustered.parts = std::move(*parts);
  clustered.parts.estimates = clusters->estimates;
  clustered.names = clusters->names;
  clustered.parts_at = [&data, clusters](std::size_t k,
                                         double value) -> std::optional<SandwichParts> {
    const auto held = held_at(data, *clusters, static_cast<Eigen::Index>(k), value);
    return held ? parts_of(*clusters, held->cwiseProduct(clusters->rows.scale)) : std::nullopt;
  };
  clustered.left_out = [&data, clusters] { return without_clusters(data, *clusters); };
  return clustered;
}

}  // namespace

std::optional<ClusteredFit> clustered_fit(const CoxData& data, const CoxFit& fit) {
  return with_parts(data, fit, clusters_of(data, fit));
}

ClusterInferences cluster_inferences(const CoxData& data,
                                     const CoxFit& fit,
                                     std::optional<ClusterInference> inference,
                                     const WildOptions& options) {
  const auto clusters = clusters_of(data, fit);
  if (const auto clustered = with_parts(data, fit, clusters)) {
    return cluster_inferences(*clustered, inference, options);
  }
  const auto by = inference.value_or(default_inference(fit.clusters));
  if (by == ClusterInference::jackknife && clusters) {
    return by_jackknife(
        clusters->estimates, without_clusters(data, *clusters), clusters->names, options.level);
  }
  if (inference && by != ClusterInference::cr1 && !fit.coefficients.empty()) {
    return not_to_be_had(by,
                         fit.coefficients.size(),
                         clusters ? "too many times, clusters and columns at once"
                                  : "the fit has no finite maximum");
  }
  ClusterInferences uncorrected{ClusterInference::cr1, {}, fit.vcov};
  if (fit.clusters > 1) {
    uncorrected.covariance *=
        static_cast<double>(fit.clusters) / (static_cast<double>(fit.clusters) - 1.0);
  }
  for (const CoxCoefficient& one : fit.coefficients) {
    uncorrected.of.push_back(
        cr1_estimate(one.estimate, one.robust_se, fit.clusters, options.level));
  }
  return uncorrected;
}

}  // namespace tcert::statistics
