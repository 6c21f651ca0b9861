#include <array>

#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/survival/time_conditions.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/bootstrap_of_rows.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/concordance_report.hpp"

namespace tcert::cli {
namespace {

/// Times as they are, or plain numbers as times of events, which then are rounded as times.
statistics::SurvivalOutcome outcome_of(statistics::ModelFrame& frame, bool round) {
  if (const auto* const survival = std::get_if<statistics::SurvivalOutcome>(&frame.outcome)) {
    return *survival;
  }
  if (const auto* const numbers = std::get_if<statistics::NumberOutcome>(&frame.outcome)) {
    statistics::SurvivalOutcome outcome = statistics::uncensored(numbers->values);
    if (round) {
      statistics::add_rounding_conditions(
          statistics::round_times(outcome), frame.response, frame.conditions);
    }
    return outcome;
  }
  throw statistics::FormulaError("'" + frame.response +
                                 "': C needs Surv() or a number as the outcome");
}

}  // namespace

FitReport fit_concordance(const FitInput& from) {
  statistics::ModelFrame& frame = from.frame;
  const FrameColumns columns = predictor_columns(frame);
  const statistics::LargerMeans larger = from.request.reverse
                                             ? statistics::LargerMeans::shorter_time
                                             : statistics::LargerMeans::longer_time;
  std::vector<statistics::Predictor> predictors;
  for (std::size_t k = 0; k < columns.names.size(); ++k) {
    predictors.push_back({columns.names[k], columns.values[k], larger});
  }
  constexpr std::array kPairWeights{statistics::PairWeight::equal,
                                    statistics::PairWeight::survival,
                                    statistics::PairWeight::survival_by_censoring,
                                    statistics::PairWeight::inverse_censoring_squared,
                                    statistics::PairWeight::inverse_at_risk};
  statistics::ConcordanceOptions options;
  options.level = from.request.level;
  options.pair_weight =
      kPairWeights[choice("pair-weight", from.request.pair_weight, {"n", "S", "S/G", "n/G2", "I"})];
  options.strata = frame.strata ? &*frame.strata : nullptr;
  options.cluster = frame.cluster ? &*frame.cluster : nullptr;
  if (frame.weights) {
    options.weights = {frame.weights->data(), static_cast<std::size_t>(frame.weights->size())};
  }
  const statistics::SurvivalOutcome outcome = outcome_of(frame, !from.request.no_time_rounding);
  if (outcome.left_truncated() &&
      (options.pair_weight == statistics::PairWeight::survival_by_censoring ||
       options.pair_weight == statistics::PairWeight::inverse_censoring_squared)) {
    throw UsageError(
        "--pair-weight: S/G and n/G2 need Surv(time, event); with (start, stop] rows "
        "take n, S or I");
  }
  FitReport report =
      concordance_report(statistics::concordance(outcome, predictors, options), options.level);
  if (from.request.replicates > 0 && !statistics::has_error(report.conditions)) {
    require_plain_bootstrap(from, options.pair_weight == statistics::PairWeight::equal);
    add_bootstrap(from,
                  columns.names,
                  statistics::concordance_statistic(outcome, predictors, {}, options.strata),
                  report);
  }
  return report;
}

}  // namespace tcert::cli
