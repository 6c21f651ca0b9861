#include <fmt/format.h>

#include <statistics/logistic/firth.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>

#include "cli/runs/fit/cluster_options.hpp"
#include "cli/runs/fit/contrasts.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "cli/runs/fit/predictions.hpp"
#include "reports/fit/firth_report.hpp"
#include "reports/fit/logistic_report.hpp"

namespace tcert::cli {
namespace {

constexpr const char* kProgress = "coefficients tested";

/// What a penalised fit costs beside a plain one: three starts, and third derivatives.
constexpr double kFirthFactor = 100.0;
/// Of a penalised profile a test is about a twelfth.
constexpr double kTestShare = 1.0 / 12.0;

/// Whether profiles are wanted and, unless asked for, cheap; if they are not, that is said.
bool takes_profiles(const FitRequest& request,
                    const statistics::LogisticInput& input,
                    double work,
                    statistics::Conditions& conditions) {
  if (request.no_profile) {
    return false;
  }
  if (request.profile || work <= statistics::kMostProfileWork) {
    return true;
  }
  conditions.push_back({statistics::ConditionKind::no_profile,
                        statistics::ConditionSeverity::note,
                        "",
                        fmt::format("{} coefficients on {} rows; Wald intervals stand alone",
                                    input.columns.size(),
                                    input.design.rows())});
  return false;
}

FitReport fit_penalised(const FitInput& from) {
  const statistics::LogisticInput input = statistics::logistic_input(from.frame);
  if (input.cluster || from.request.robust) {
    throw UsageError("--firth goes without --cluster and --robust: its tests are of likelihoods");
  }
  if (!from.request.contrasts.empty() || !from.request.predict.empty()) {
    throw UsageError("--firth goes without --contrasts and --predict");
  }
  const double work = kFirthFactor * statistics::profile_work(input);
  statistics::Conditions conditions;
  Stage stage(from.progress, kProgress, input.columns.size());
  statistics::FirthOptions options;
  options.level = from.request.level;
  options.profiles = takes_profiles(from.request, input, work, conditions);
  options.advance = [&] { stage.advance(); };
  if ((options.profiles ? work : kTestShare * work) > statistics::kMostProfileWork) {
    from.progress.sum_up(
        fmt::format("tcert fit: the penalised tests{} of {} coefficients on {} rows take long",
                    options.profiles ? " and profiles" : "",
                    input.columns.size(),
                    input.design.rows()));
  }
  statistics::FirthFit fit = statistics::fit_firth(input, options);
  fit.conditions.insert(fit.conditions.end(), conditions.begin(), conditions.end());
  return firth_report(fit);
}

/// What this command has for separated data.
void point_to_firth(const statistics::LogisticInput& input,
                    bool robust,
                    statistics::Conditions& conditions) {
  for (statistics::Condition& condition : conditions) {
    const bool separated = condition.kind == statistics::ConditionKind::complete_separation ||
                           condition.kind == statistics::ConditionKind::quasi_separation ||
                           condition.kind == statistics::ConditionKind::near_separation;
    if (separated) {
      condition.advice = std::string(condition.kind == statistics::ConditionKind::near_separation
                                         ? "it says nothing"
                                         : "no finite estimate") +
                         "; merge levels, leave the term out or fit with --firth";
      condition.advice += input.cluster ? ", which goes without clusters"
                          : robust      ? ", which goes without --robust"
                                        : "";
    }
  }
}

}  // namespace

FitReport fit_glm(const FitInput& from) {
  if (std::holds_alternative<statistics::SurvivalOutcome>(from.frame.outcome)) {
    throw UsageError("'" + from.frame.response +
                     "': a logistic model needs a 0/1 outcome; use tcert fit cox");
  }
  if (from.request.profile && from.request.no_profile) {
    throw UsageError("--profile and --no-profile: take one of them");
  }
  if (from.request.firth) {
    return fit_penalised(from);
  }
  statistics::LogisticInput input = statistics::logistic_input(from.frame);
  statistics::LogisticOptions options;
  options.level = from.request.level;
  const bool robust = input.cluster || from.request.robust;
  if (robust) {
    options.variance = statistics::CoefficientVariance::robust;
    if (from.request.profile) {
      throw UsageError(
          "--profile goes without --cluster and --robust: profiles take the rows to be "
          "independent");
    }
  }
  const auto inference = inference_of(from, input.cluster.has_value());
  statistics::LogisticFit fit = statistics::fit_logistic(input, options);
  point_to_firth(input, robust, fit.conditions);
  std::vector<statistics::ProfileLimits> profiles;
  if (!robust && fit.log_likelihood &&
      takes_profiles(from.request, input, statistics::profile_work(input), fit.conditions)) {
    Stage stage(from.progress, kProgress, input.columns.size());
    profiles = statistics::profile_limits(input, options, [&] { stage.advance(); });
  }
  statistics::ClusterInferences inferences;
  if (input.cluster) {
    inferences = statistics::cluster_inferences(input, fit, inference, wild_options(from.request));
  }
  FitReport report = logistic_report(fit, profiles, statistics::drop_terms(input), inferences);
  std::optional<statistics::ClusteredFit> clustered;
  if (input.cluster) {
    clustered = statistics::clustered_fit(input, fit);
    add_cluster_tables(from, inferences, clustered, input.columns, *input.cluster, report);
  }
  add_contrasts(from, fit, clustered, inferences, report);
  add_predictions(from, fit, inferences, report);
  return report;
}

}  // namespace tcert::cli
