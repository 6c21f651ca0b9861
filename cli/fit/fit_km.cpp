#include <array>

#include "analysis/model/variable.hpp"
#include "analysis/survival/cumulative_incidence.hpp"
#include "analysis/survival/log_rank.hpp"
#include "analysis/survival/survival_curve.hpp"
#include "cli/errors.hpp"
#include "cli/fit/fit.hpp"
#include "reports/fit/survival_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kScales{IntervalScale::log,
                             IntervalScale::log_log,
                             IntervalScale::plain,
                             IntervalScale::logit,
                             IntervalScale::arcsin};

/// Rows that end with an event take the cause that their column names, the others are censored.
CompetingOutcome competing_outcome(const FitRequest& request, const SurvivalOutcome& survival) {
  const Factor cause = on_rows(
      evaluate_factor({Expression::Kind::column, 0.0, request.options.cause, {}}, request.table),
      request.frame.rows);
  CompetingOutcome outcome;
  outcome.start = survival.start;
  outcome.stop = survival.stop;
  outcome.causes = cause.levels;
  for (std::size_t row = 0; row < survival.rows(); ++row) {
    const bool censored = survival.event[row] == 0 || cause.codes[row] == Factor::kMissing;
    outcome.cause.push_back(censored ? 0 : cause.codes[row] + 1);
  }
  return outcome;
}

}  // namespace

FitReport fit_km(const FitRequest& request) {
  const auto* const survival = std::get_if<SurvivalOutcome>(&request.frame.outcome);
  if (survival == nullptr) {
    throw FormulaError("'" + request.frame.response +
                       "': a survival curve needs Surv(time, event)");
  }
  const ModelFrame& frame = request.frame;
  const Factor* const groups = &*frame.groups;
  const Factor* const cluster = frame.cluster ? &*frame.cluster : nullptr;
  std::span<const double> weights;
  if (frame.weights) {
    weights = {frame.weights->data(), static_cast<std::size_t>(frame.weights->size())};
  }
  SurvivalReportOptions shown;
  shown.scale = kScales[choice(
      "interval", request.options.interval, {"log", "log-log", "plain", "logit", "arcsin"})];
  shown.level = request.options.level;
  shown.times = request.options.times;

  CurveOptions curve_options;
  curve_options.weights = weights;
  curve_options.groups = groups;
  curve_options.cluster = cluster;
  std::optional<LogRankTest> test;
  if (!frame.terms.empty() && !frame.weights) {
    test = log_rank_test(
        *survival, *groups, frame.strata ? &*frame.strata : nullptr, request.options.rho);
  }
  FitReport report = survival_report(survival_curves(*survival, curve_options), test, shown);
  if (!request.options.cause.empty()) {
    IncidenceOptions incidence;
    incidence.weights = weights;
    incidence.groups = groups;
    incidence.cluster = cluster;
    add_incidence(
        cumulative_incidence(competing_outcome(request, *survival), incidence), shown, report);
  }
  return report;
}

}  // namespace tcert::cli
