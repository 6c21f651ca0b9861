#include <algorithm>
#include <array>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/survival/fine_gray.hpp>
#include <stdexcept>
#include <table/nearest_name.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/cluster_options.hpp"
#include "cli/runs/fit/competing_causes.hpp"
#include "cli/runs/fit/contrasts.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/cox_report.hpp"

namespace tcert::cli {
namespace {

/// The cause of --event among those that end a row. \throws UsageError if it ends none.
std::size_t event_of(const FitRequest& request, const statistics::CompetingOutcome& outcome) {
  if (request.cause.empty() || request.event.empty()) {
    throw UsageError("finegray needs --cause COLUMN and --event CAUSE");
  }
  return choice("event", request.event, outcome.causes);
}

struct Model {
  statistics::CoxFit fit;
  statistics::ClusterInferences inferences;
};

Model model_of(const FitInput& from,
               const statistics::CoxData& data,
               const statistics::CoxOptions& options,
               const std::optional<statistics::ClusterInference>& inference) {
  Model model{statistics::fit_cox(data, options), {}};
  if (data.cluster) {
    model.inferences =
        statistics::cluster_inferences(data, model.fit, inference, wild_options(from.request));
  }
  return model;
}

}  // namespace

FitReport fit_fine_gray(const FitInput& from) {
  const auto* const survival = std::get_if<statistics::SurvivalOutcome>(&from.frame.outcome);
  if (survival == nullptr || survival->left_truncated()) {
    throw statistics::FormulaError("'" + from.frame.response +
                                   "': a Fine-Gray model needs Surv(time, event)");
  }
  statistics::Conditions conditions;
  const statistics::CompetingOutcome outcome = competing_outcome(from, conditions);
  const std::size_t cause = event_of(from.request, outcome);
  const statistics::CoxData data = statistics::cox_data(from.frame);
  const auto inference = inference_of(from, data.cluster.has_value());
  statistics::CoxOptions options;
  options.level = from.request.level;
  options.ties = std::array{
      statistics::Ties::efron,
      statistics::Ties::breslow}[choice("ties", from.request.ties, {"efron", "breslow"})];
  const statistics::CoxData weighted = statistics::fine_gray_data(data, outcome, cause);
  const Model model = model_of(from, weighted, options, inference);
  FitReport report = cox_report(model.fit, std::nullopt, model.inferences);
  report.model = "finegray";
  report.tables.front().title =
      "Fine-Gray model of '" + from.request.event + "': log subdistribution hazard ratios";
  report.tables.front().footnotes.emplace_back(
      "Rows that ended otherwise stay at risk, weighted by the chance that they would not have "
      "been "
      "censored since; the weights are taken as known. Rows are those of the weighted data.");
  const statistics::CoxData specific = statistics::cause_specific_data(data, outcome, cause);
  const Model beside = model_of(from, specific, options, inference);
  Table table = cox_report(beside.fit, std::nullopt, beside.inferences).tables.front();
  table.name = "cause_specific";
  table.title = "Cause-specific Cox model of '" + from.request.event +
                "', other ends censored: log hazard ratios";
  report.tables.push_back(std::move(table));
  std::optional<statistics::ClusteredFit> clustered;
  if (weighted.cluster) {
    clustered = statistics::clustered_fit(weighted, model.fit);
    add_cluster_tables(
        from, model.inferences, clustered, weighted.columns, *weighted.cluster, report);
  }
  add_contrasts(from, model.fit, clustered, model.inferences, report);
  report.conditions.insert(report.conditions.end(), conditions.begin(), conditions.end());
  return report;
}

}  // namespace tcert::cli
