#include <algorithm>
#include <array>
#include <cmath>
#include <statistics/concordance/concordance.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/cox/cox_residuals.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/cox/cox_terms.hpp>
#include <statistics/cox/cox_zph.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/cluster_options.hpp"
#include "cli/runs/fit/contrasts.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "cli/runs/fit/predictions.hpp"
#include "reports/fit/cox_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kTies{
    statistics::Ties::efron, statistics::Ties::breslow, statistics::Ties::exact};
constexpr std::array kTransforms{statistics::TimeTransform::km,
                                 statistics::TimeTransform::rank,
                                 statistics::TimeTransform::identity,
                                 statistics::TimeTransform::log};

/// Of the linear predictor, within strata and by clusters, as R's summary gives it.
std::optional<statistics::ConcordanceResult> concordance_of(const statistics::CoxData& data,
                                                            const statistics::CoxFit& fit) {
  if (fit.df == 0 || statistics::has_error(fit.conditions)) {
    return std::nullopt;
  }
  const statistics::Predictor predictor{
      "linear predictor",
      {fit.linear_predictors.data(), static_cast<std::size_t>(fit.linear_predictors.size())},
      statistics::LargerMeans::shorter_time};
  statistics::ConcordanceOptions options;
  options.level = fit.level;
  options.strata = data.strata ? &*data.strata : nullptr;
  options.cluster = data.cluster ? &*data.cluster : nullptr;
  if (data.weights) {
    options.weights = {data.weights->data(), static_cast<std::size_t>(data.weights->size())};
  }
  return statistics::concordance(data.outcome, {&predictor, 1}, options);
}

void add_residuals(const FitInput& from,
                   const statistics::CoxData& data,
                   const statistics::CoxFit& fit,
                   FitReport& report) {
  const std::vector<std::string> known{
      "martingale", "deviance", "score", "dfbeta", "dfbetas", "schoenfeld", "scaledsch"};
  const std::vector<std::string> words = words_of(from.request.residuals);
  for (const std::string& word : words) {
    static_cast<void>(choice("residuals", word, known));
    if (fit.ties == statistics::Ties::exact && word != "martingale" && word != "deviance") {
      throw UsageError("--residuals: with exact ties there are only martingale and deviance");
    }
  }
  if (words.empty()) {
    return;
  }
  const statistics::CoxResiduals residuals = statistics::cox_residuals(data, fit);
  for (const std::string& word : words) {
    report.details.push_back(residual_table(residuals, word, data.columns, from.frame.rows));
  }
}

/// Rows of the table, counted from 1, as rows of the frame. \throws UsageError for one that is not.
std::vector<std::size_t> frame_rows(const FitInput& from) {
  std::vector<std::size_t> rows;
  for (const double number : numbers_of("curves", from.request.curves)) {
    const auto& known = from.frame.rows;
    const auto found = std::find_if(known.begin(), known.end(), [&](std::size_t row) {
      return static_cast<double>(row + 1) == number;
    });
    if (found == known.end()) {
      throw UsageError("--curves: there is no complete row " + significant(number, 9));
    }
    rows.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  return rows;
}

void add_curves(const FitInput& from,
                const statistics::CoxData& data,
                const statistics::CoxFit& fit,
                FitReport& report) {
  const std::vector<std::size_t> rows = frame_rows(from);
  if (rows.empty()) {
    return;
  }
  Eigen::MatrixXd design(static_cast<Eigen::Index>(rows.size()), data.design.cols());
  Eigen::VectorXd offset;
  if (data.offset) {
    offset.resize(design.rows());
  }
  std::vector<std::size_t> names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const auto row = static_cast<Eigen::Index>(rows[i]);
    design.row(at) = data.design.row(row);
    if (data.offset) {
      offset[at] = (*data.offset)[row];
    }
    names.push_back(from.frame.rows[rows[i]] + 1);
  }
  report.details.push_back(curve_table(statistics::cox_curves(data, fit, design, offset), names));
}

/// Says from when on a cumulative baseline hazard is NA.
void add_infinite_hazards(const std::vector<statistics::BaselineHazard>& baseline,
                          FitReport& report) {
  for (const statistics::BaselineHazard& one : baseline) {
    const auto first = std::find_if(
        one.hazard.begin(), one.hazard.end(), [](double hazard) { return std::isinf(hazard); });
    if (first != one.hazard.end()) {
      const auto at = static_cast<std::size_t>(first - one.hazard.begin());
      report.conditions.push_back(
          {statistics::ConditionKind::infinite_hazard,
           statistics::ConditionSeverity::warning,
           "",
           "from " + significant(one.time[at], 9) + " on" +
               (one.stratum.empty() ? "" : ", stratum '" + one.stratum + "'")});
    }
  }
}

}  // namespace

FitReport fit_cox_model(const FitInput& from) {
  if (!std::holds_alternative<statistics::SurvivalOutcome>(from.frame.outcome)) {
    throw statistics::FormulaError("'" + from.frame.response +
                                   "': a Cox model needs Surv(time, event)");
  }
  statistics::CoxData data = statistics::cox_data(from.frame);
  statistics::CoxOptions options;
  options.level = from.request.level;
  options.ties = kTies[choice("ties", from.request.ties, {"efron", "breslow", "exact"})];
  if (from.request.robust) {
    options.robust = true;
  }
  if (options.ties == statistics::Ties::exact && (options.robust || data.cluster || data.weights)) {
    throw UsageError("--ties exact goes without --robust, --cluster, cluster() and --weights");
  }
  const statistics::TimeTransform transform =
      kTransforms[choice("transform", from.request.transform, {"km", "rank", "identity", "log"})];
  const auto inference = inference_of(from, data.cluster.has_value());
  const statistics::CoxFit fit = statistics::fit_cox(data, options);
  statistics::ClusterInferences inferences;
  if (data.cluster) {
    inferences = statistics::cluster_inferences(data, fit, inference, wild_options(from.request));
  }
  FitReport report = cox_report(fit, concordance_of(data, fit), inferences);
  std::optional<statistics::ClusteredFit> clustered;
  if (data.cluster) {
    clustered = statistics::clustered_fit(data, fit);
    add_cluster_tables(from, inferences, clustered, data.columns, *data.cluster, report);
  }
  add_contrasts(from, fit, clustered, inferences, report);
  if (statistics::has_error(fit.conditions)) {
    return report;
  }
  if (!fit.at_limit) {
    report.conditions.push_back({statistics::ConditionKind::not_converged,
                                 statistics::ConditionSeverity::warning,
                                 "",
                                 "rounding stops it before the limit of the coefficients that run "
                                 "to infinity: no tests of terms and hazards, no baseline hazard, "
                                 "residuals and curves"});
    return report;
  }
  if (fit.ties != statistics::Ties::exact && fit.df > 0) {
    add_proportionality(statistics::cox_zph(data, fit, transform, true),
                        statistics::cox_zph(data, fit, transform, false),
                        report);
  }
  if (!fit.robust) {
    add_term_tests(
        statistics::cox_anova(data, options), statistics::cox_drop1(data, options), report);
  }
  const std::vector<statistics::BaselineHazard> baseline = statistics::cox_baseline(data, fit);
  add_infinite_hazards(baseline, report);
  report.details.push_back(baseline_table(baseline));
  add_residuals(from, data, fit, report);
  add_curves(from, data, fit, report);
  add_time_scores(from, data, fit, report);
  add_predictions(from, data, fit, inferences, report);
  return report;
}

}  // namespace tcert::cli
