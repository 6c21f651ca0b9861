#include <fmt/format.h>

#include <statistics/logistic/firth.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <statistics/logistic/logistic_profile.hpp>

#include "cli/errors.hpp"
#include "cli/fit/fit.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
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
bool takes_profiles(const FitOptions& options,
                    const statistics::LogisticInput& input,
                    double work,
                    statistics::Conditions& conditions) {
  if (options.no_profile) {
    return false;
  }
  if (options.profile || work <= statistics::kMostProfileWork) {
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

FitReport fit_penalised(const FitRequest& request) {
  const statistics::LogisticInput input = statistics::logistic_input(request.frame);
  if (input.cluster || request.options.robust) {
    throw UsageError("--firth goes without --cluster and --robust: its tests are of likelihoods");
  }
  const double work = kFirthFactor * statistics::profile_work(input);
  statistics::Conditions conditions;
  Progress progress(kProgress, input.columns.size(), request.options.quiet);
  statistics::FirthOptions options;
  options.level = request.options.level;
  options.profiles = takes_profiles(request.options, input, work, conditions);
  options.advance = [&] { progress.advance(); };
  if ((options.profiles ? work : kTestShare * work) > statistics::kMostProfileWork &&
      !request.options.quiet) {
    say(fmt::format("tcert fit: the penalised tests{} of {} coefficients on {} rows take long",
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

FitReport fit_glm(const FitRequest& request) {
  if (std::holds_alternative<statistics::SurvivalOutcome>(request.frame.outcome)) {
    throw UsageError("'" + request.frame.response +
                     "': a logistic model needs a 0/1 outcome; use tcert fit cox");
  }
  if (request.options.profile && request.options.no_profile) {
    throw UsageError("--profile and --no-profile: take one of them");
  }
  if (request.options.firth) {
    return fit_penalised(request);
  }
  statistics::LogisticInput input = statistics::logistic_input(request.frame);
  statistics::LogisticOptions options;
  options.level = request.options.level;
  const bool robust = input.cluster || request.options.robust;
  if (robust) {
    options.variance = statistics::CoefficientVariance::robust;
    if (request.options.profile) {
      throw UsageError(
          "--profile goes without --cluster and --robust: profiles take the rows to be "
          "independent");
    }
  }
  statistics::LogisticFit fit = statistics::fit_logistic(input, options);
  point_to_firth(input, robust, fit.conditions);
  std::vector<statistics::ProfileLimits> profiles;
  if (!robust && fit.log_likelihood &&
      takes_profiles(request.options, input, statistics::profile_work(input), fit.conditions)) {
    Progress progress(kProgress, input.columns.size(), request.options.quiet);
    profiles = statistics::profile_limits(input, options, [&] { progress.advance(); });
  }
  return logistic_report(fit, profiles, statistics::drop_terms(input));
}

}  // namespace tcert::cli
