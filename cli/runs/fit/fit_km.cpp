#include <array>

#include <statistics/survival/cumulative_incidence.hpp>
#include <statistics/survival/gray_test.hpp>
#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/restricted_means.hpp>
#include <statistics/survival/survival_curve.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/cluster_options.hpp"
#include "cli/runs/fit/competing_causes.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/survival_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kScales{statistics::IntervalScale::log,
                             statistics::IntervalScale::log_log,
                             statistics::IntervalScale::plain,
                             statistics::IntervalScale::logit,
                             statistics::IntervalScale::arcsin};

/// \throws UsageError unless it is a time above 0, and for case weights or late entry.
std::optional<double> rmst_limit(const FitRequest& request) {
  if (request.rmst.empty()) {
    return std::nullopt;
  }
  const std::vector<double> numbers = numbers_of("rmst", request.rmst);
  if (numbers.size() != 1 || !(numbers[0] > 0.0)) {
    throw UsageError("--rmst: found '" + request.rmst + "', expected one time above 0");
  }
  if (!request.weights.empty()) {
    throw UsageError("--rmst goes without --weights");
  }
  return numbers[0];
}

/// One for each cause, of groups that rows enter from the beginning.
void add_gray_tests(const FitInput& from,
                    const statistics::CompetingOutcome& outcome,
                    FitReport& report) {
  const statistics::ModelFrame& frame = from.frame;
  if (frame.terms.empty() || frame.weights || !outcome.start.empty()) {
    return;
  }
  std::vector<statistics::GrayTest> tests;
  for (std::size_t cause = 0; cause < outcome.causes.size(); ++cause) {
    tests.push_back(statistics::gray_test(
        outcome, cause, *frame.groups, frame.strata ? &*frame.strata : nullptr, from.request.rho));
  }
  report.tables.push_back(gray_table(tests, from.request.rho));
}

}  // namespace

FitReport fit_km(const FitInput& from) {
  const auto* const survival = std::get_if<statistics::SurvivalOutcome>(&from.frame.outcome);
  if (survival == nullptr) {
    throw statistics::FormulaError("'" + from.frame.response +
                                   "': a survival curve needs Surv(time, event)");
  }
  statistics::Conditions conditions;
  std::optional<statistics::CompetingOutcome> competing;
  if (!from.request.cause.empty()) {
    competing = competing_outcome(from, conditions);
  }
  const statistics::ModelFrame& frame = from.frame;
  const bool by_strata = frame.terms.empty() && frame.strata;
  const table::Factor* const groups = by_strata ? &*frame.strata : &*frame.groups;
  const table::Factor* const cluster = frame.cluster ? &*frame.cluster : nullptr;
  std::span<const double> weights;
  if (frame.weights) {
    weights = {frame.weights->data(), static_cast<std::size_t>(frame.weights->size())};
  }
  SurvivalReportOptions shown;
  shown.scale = kScales[choice(
      "interval", from.request.interval, {"log", "log-log", "plain", "logit", "arcsin"})];
  shown.level = from.request.level;
  shown.times = numbers_of("times", from.request.times);

  statistics::CurveOptions curve_options;
  curve_options.weights = weights;
  curve_options.groups = groups;
  curve_options.cluster = cluster;
  std::optional<statistics::LogRankTest> test;
  if (!frame.terms.empty() && frame.weights) {
    conditions.push_back(
        {statistics::ConditionKind::no_weighted_test, statistics::ConditionSeverity::note, "", ""});
  } else if (!frame.terms.empty()) {
    test = statistics::log_rank_test(
        *survival, *groups, frame.strata ? &*frame.strata : nullptr, from.request.rho);
  }
  FitReport report =
      survival_report(statistics::survival_curves(*survival, curve_options), test, shown);
  report.conditions.insert(report.conditions.end(), conditions.begin(), conditions.end());
  if (const auto limit = rmst_limit(from.request)) {
    add_too_many_clusters(frame.cluster, report.conditions);
    report.tables.push_back(restricted_mean_table(
        statistics::restricted_means(*survival, groups, cluster, *limit, shown.level),
        *limit,
        cluster != nullptr));
  }
  if (competing) {
    add_gray_tests(from, *competing, report);
    statistics::IncidenceOptions incidence;
    incidence.weights = weights;
    incidence.groups = groups;
    incidence.cluster = cluster;
    add_incidence(
        statistics::cumulative_incidence(std::move(*competing), incidence), shown, report);
  }
  return report;
}

}  // namespace tcert::cli
