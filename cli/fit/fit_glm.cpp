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
                    const LogisticInput& input,
                    double work,
                    Conditions& conditions) {
  if (options.no_profile) {
    return false;
  }
  if (options.profile || work <= kMostProfileWork) {
    return true;
  }
  conditions.push_back({ConditionKind::no_profile,
                        ConditionSeverity::note,
                        "",
                        fmt::format("{} coefficients on {} rows; Wald intervals stand alone",
                                    input.columns.size(),
                                    input.design.rows())});
  return false;
}

FitReport fit_penalised(const FitRequest& request) {
  const LogisticInput input = logistic_input(request.frame);
  if (input.cluster || request.options.robust) {
    throw UsageError("--firth goes without --cluster and --robust: its tests are of likelihoods");
  }
  const double work = kFirthFactor * profile_work(input);
  Conditions conditions;
  Progress progress(kProgress, input.columns.size(), request.options.quiet);
  FirthOptions options;
  options.level = request.options.level;
  options.profiles = takes_profiles(request.options, input, work, conditions);
  options.advance = [&] { progress.advance(); };
  if ((options.profiles ? work : kTestShare * work) > kMostProfileWork && !request.options.quiet) {
    say(fmt::format("tcert fit: the penalised tests{} of {} coefficients on {} rows take long",
                    options.profiles ? " and profiles" : "",
                    input.columns.size(),
                    input.design.rows()));
  }
  FirthFit fit = fit_firth(input, options);
  fit.conditions.insert(fit.conditions.end(), conditions.begin(), conditions.end());
  return firth_report(fit);
}

/// What this command has for separated data.
void point_to_firth(const LogisticInput& input, bool robust, Conditions& conditions) {
  for (Condition& condition : conditions) {
    const bool separated = condition.kind == ConditionKind::complete_separation ||
                           condition.kind == ConditionKind::quasi_separation ||
                           condition.kind == ConditionKind::near_separation;
    if (separated) {
      condition.advice =
          std::string(condition.kind == ConditionKind::near_separation ? "it says nothing"
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
  if (std::holds_alternative<SurvivalOutcome>(request.frame.outcome)) {
    throw UsageError("'" + request.frame.response +
                     "': a logistic model needs a 0/1 outcome; use tcert fit cox");
  }
  if (request.options.profile && request.options.no_profile) {
    throw UsageError("--profile and --no-profile: take one of them");
  }
  if (request.options.firth) {
    return fit_penalised(request);
  }
  LogisticInput input = logistic_input(request.frame);
  LogisticOptions options;
  options.level = request.options.level;
  const bool robust = input.cluster || request.options.robust;
  if (robust) {
    options.variance = CoefficientVariance::robust;
    if (request.options.profile) {
      throw UsageError(
          "--profile goes without --cluster and --robust: profiles take the rows to be "
          "independent");
    }
  }
  LogisticFit fit = fit_logistic(input, options);
  point_to_firth(input, robust, fit.conditions);
  std::vector<ProfileLimits> profiles;
  if (!robust && fit.log_likelihood &&
      takes_profiles(request.options, input, profile_work(input), fit.conditions)) {
    Progress progress(kProgress, input.columns.size(), request.options.quiet);
    profiles = profile_limits(input, options, [&] { progress.advance(); });
  }
  return logistic_report(fit, profiles, drop_terms(input));
}

}  // namespace tcert::cli
