#include "analysis/study/h1/nested_models.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <utility>

#include "analysis/study/h1/model_left_out.hpp"

namespace tcert::study {
namespace {

/// The coefficient of what is added, with each cluster left out in turn.
std::vector<double> without_clusters(const H1Data& data, const H1Model& model, bool timed) {
  const auto plan = statistics::ResamplingPlan::of_clusters(data.cluster.codes);
  if (plan.units() > statistics::kMostJackknifeClusters) {
    return (timed ? cox_left_out(data, model, plan) : logistic_left_out(data, model, plan)).added;
  }
  const statistics::Statistic statistic =
      statistics::scalar_statistic(data.rows(), [&model, timed] {
        return [&model, timed](std::span<const std::uint32_t> multiplicity) {
          return timed ? model.added_cox_coefficient(multiplicity)
                       : model.added_logistic_coefficient(multiplicity);
        };
      });
  return statistics::leave_one_out(statistic, plan).front();
}

std::optional<double> test_of(const H1Data& data, const H1Model& model, bool timed, H1Row& row) {
  const std::vector<std::uint32_t> once(data.rows(), 1);
  const std::vector<double> without = without_clusters(data, model, timed);
  const auto failed =
      std::count_if(without.begin(), without.end(), [](double b) { return std::isnan(b); });
  if (failed > 0) {
    row.conditions.push_back({statistics::ConditionKind::no_jackknife,
                              statistics::ConditionSeverity::warning,
                              "",
                              std::string(timed ? "Cox model: " : "logistic model: ") +
                                  std::to_string(failed) + " of " + std::to_string(without.size()) +
                                  " clusters"});
  }
  return cluster_jackknife_p(
      timed ? model.added_cox_coefficient(once) : model.added_logistic_coefficient(once), without);
}

std::optional<double> likelihood_ratio_p(const std::optional<double>& smaller,
                                         const std::optional<double>& larger,
                                         std::size_t df) {
  return !smaller || !larger || df == 0
             ? std::nullopt
             : std::optional(statistics::chi_square_test(2.0 * (*larger - *smaller), df).p_value);
}

/// A coefficient that has run away is finite in name only: a hair decides on it.
bool is_finite(const statistics::LogisticFit& fit) {
  return fit.separation == statistics::Separation::none && fit.log_likelihood.has_value() &&
         std::none_of(fit.coefficients.begin(),
                      fit.coefficients.end(),
                      [](const statistics::LogisticCoefficient& one) {
                        return one.kind == statistics::CoefficientKind::ran_away;
                      });
}

bool is_finite(const statistics::CoxFit& fit) {
  return fit.summary.termination == statistics::CoxTermination::converged &&
         !statistics::has(fit.conditions, statistics::ConditionKind::near_separation);
}

void test_success(const H1Data& data, const H1Models& models, H1Row& added) {
  const statistics::LogisticFit small = statistics::fit_logistic(models.models[0].logistic());
  const statistics::LogisticFit large = statistics::fit_logistic(models.models[1].logistic());
  added.conditions.insert(added.conditions.end(), large.conditions.begin(), large.conditions.end());
  if (is_finite(small) && is_finite(large) && large.rank > small.rank) {
    added.auc_lr_p =
        likelihood_ratio_p(small.log_likelihood, large.log_likelihood, large.rank - small.rank);
    added.auc_p = test_of(data, models.models[1], false, added);
  }
}

void test_time(const H1Data& data, const H1Models& models, H1Row& added) {
  const statistics::CoxFit small = statistics::fit_cox(models.models[0].cox());
  const statistics::CoxFit large = statistics::fit_cox(models.models[1].cox());
  if (is_finite(small) && is_finite(large) && large.df > small.df) {
    added.c_lr_p = likelihood_ratio_p(small.loglik, large.loglik, large.df - small.df);
    added.c_p = test_of(data, models.models[1], true, added);
  }
}

}  // namespace

std::optional<double> cluster_jackknife_p(double estimate,
                                          std::span<const double> without_cluster) {
  const auto clusters = static_cast<double>(without_cluster.size());
  double squares = 0.0;
  for (const double one : without_cluster) {
    squares += (one - estimate) * (one - estimate);
  }
  const double variance = (clusters - 1.0) / clusters * squares;
  if (!(variance > 0.0) || !std::isfinite(estimate)) {
    return std::nullopt;
  }
  return statistics::t_p_value(
      estimate / std::sqrt(variance), clusters - 1.0, statistics::Alternative::two_sided);
}

void add_nested_tests(const H1Data& data, const H1Models& models, H1Panel& panel) {
  if (models.models.empty()) {
    return;
  }
  test_success(data, models, panel.rows.back());
  if (data.censored) {
    test_time(data, models, panel.rows.back());
  }
}

}  // namespace tcert::study
