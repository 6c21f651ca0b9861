#include "cli/runs/fit/contrasts.hpp"

#include <statistics/clusters/contrast_inference.hpp>
#include <statistics/model/level_means.hpp>
#include <statistics/model/pairwise.hpp>

#include "reports/fit/contrast_table.hpp"
#include "reports/fit/lmm_report.hpp"

namespace tcert::cli {
namespace {

const char* const kByModel =
    "By the normal distribution and the covariance of the coefficients (vcov).";

template <class Coefficients>
std::vector<std::optional<double>> estimates_of(const Coefficients& coefficients) {
  std::vector<std::optional<double>> estimates;
  for (const auto& one : coefficients) {
    estimates.push_back(one.estimate);
  }
  return estimates;
}

void add_pairs(const FitInput& from,
               const statistics::LevelMeans& means,
               const statistics::CoefficientSums& sums,
               const std::optional<RatioName>& ratio,
               const std::string& by,
               FitReport& report) {
  report.tables.push_back(
      contrast_table(statistics::pairwise_contrasts(means, sums, from.request.level),
                     from.request.contrasts,
                     ratio,
                     by));
}

statistics::LevelMeans means_of(const FitInput& from) {
  return statistics::level_means(
      from.formula, from.table, from.frame, from.options, from.request.contrasts);
}

/// What --inference makes of clusters, else the covariance of the fit.
template <class Fit>
void add_by_clusters(const FitInput& from,
                     const Fit& fit,
                     const Eigen::MatrixXd& covariance,
                     const statistics::LevelMeans& means,
                     const std::optional<statistics::ClusteredFit>& clustered,
                     const statistics::ClusterInferences& inferences,
                     const RatioName& ratio,
                     FitReport& report) {
  const auto estimates = estimates_of(fit.coefficients);
  if (inferences.of.empty()) {
    add_pairs(
        from,
        means,
        [&](const Eigen::MatrixXd& weights) {
          return statistics::sums_by_covariance(estimates, covariance, {}, weights);
        },
        ratio,
        kByModel,
        report);
    return;
  }
  add_pairs(
      from,
      means,
      [&](const Eigen::MatrixXd& weights) {
        return statistics::cluster_sums(clustered, inferences, estimates, fit.clusters, weights);
      },
      ratio,
      inferences.by == statistics::ClusterInference::wild
          ? "The wild bootstrap is of a coefficient, a contrast has none: take another --inference."
          : "By the same inference of clusters as the t columns of the coefficients.",
      report);
}

}  // namespace

void add_contrasts(const FitInput& from,
                   const statistics::LogisticFit& fit,
                   const std::optional<statistics::ClusteredFit>& clustered,
                   const statistics::ClusterInferences& inferences,
                   FitReport& report) {
  if (!from.request.contrasts.empty() && fit.log_likelihood) {
    add_by_clusters(from,
                    fit,
                    fit.covariance,
                    means_of(from),
                    clustered,
                    inferences,
                    odds_ratio_name(),
                    report);
  }
}

void add_contrasts(const FitInput& from,
                   const statistics::CoxFit& fit,
                   const std::optional<statistics::ClusteredFit>& clustered,
                   const statistics::ClusterInferences& inferences,
                   FitReport& report) {
  if (from.request.contrasts.empty() || statistics::has_error(fit.conditions)) {
    return;
  }
  statistics::LevelMeans means = means_of(from);
  std::vector<Eigen::Index> columns;  // Without the intercept, which a Cox model has not.
  for (std::size_t j = 0; j < from.frame.columns.size(); ++j) {
    if (from.frame.term_of[j] != 0) {
      columns.push_back(static_cast<Eigen::Index>(j));
    }
  }
  means.design = Eigen::MatrixXd(means.design(Eigen::all, columns));
  add_by_clusters(from, fit, fit.vcov, means, clustered, inferences, hazard_ratio_name(), report);
}

void add_contrasts(const FitInput& from, const statistics::GlmmFit& fit, FitReport& report) {
  if (from.request.contrasts.empty() || !fit.log_likelihood) {
    return;
  }
  const auto estimates = estimates_of(fit.coefficients);
  add_pairs(
      from,
      means_of(from),
      [&](const Eigen::MatrixXd& weights) {
        return statistics::sums_by_covariance(estimates, fit.covariance, {}, weights);
      },
      odds_ratio_name(),
      kByModel,
      report);
}

void add_contrasts(const FitInput& from, const statistics::LmmFit& fit, FitReport& report) {
  if (from.request.contrasts.empty() || !fit.log_likelihood) {
    return;
  }
  const auto estimates = estimates_of(fit.coefficients);
  add_pairs(
      from,
      means_of(from),
      [&](const Eigen::MatrixXd& weights) {
        auto sums = statistics::sums_by_covariance(estimates, fit.covariance, {}, weights);
        for (std::size_t k = 0; k < sums.size(); ++k) {
          sums[k].df =
              statistics::lmm_contrast(fit, weights.row(static_cast<Eigen::Index>(k)).transpose())
                  .df;
        }
        return sums;
      },
      ratio_of_response(from.formula),
      "By t with Satterthwaite's degrees of freedom.",
      report);
}

}  // namespace tcert::cli
