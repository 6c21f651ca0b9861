#include "analysis/logistic/firth.hpp"
#include "analysis/logistic/logistic.hpp"
#include "analysis/logistic/logistic_drop.hpp"
#include "analysis/logistic/logistic_profile.hpp"
#include "cli/errors.hpp"
#include "cli/fit/fit.hpp"
#include "reports/fit/firth_report.hpp"
#include "reports/fit/logistic_report.hpp"

namespace tcert::cli {
namespace {

FitReport fit_penalised(const FitRequest& request) {
  const LogisticInput input = logistic_input(request.frame);
  if (input.cluster || request.options.robust) {
    throw UsageError("--firth goes without --cluster and --robust: its tests are of likelihoods");
  }
  FirthOptions options;
  options.level = request.options.level;
  options.profiles = !request.options.no_profile;
  return firth_report(fit_firth(input, options));
}

}  // namespace

FitReport fit_glm(const FitRequest& request) {
  if (std::holds_alternative<SurvivalOutcome>(request.frame.outcome)) {
    throw UsageError("'" + request.frame.response +
                     "': a logistic model needs a 0/1 outcome; use tcert fit cox");
  }
  if (request.options.firth) {
    return fit_penalised(request);
  }
  LogisticInput input = logistic_input(request.frame);
  LogisticOptions options;
  options.level = request.options.level;
  if (input.cluster || request.options.robust) {
    options.variance = CoefficientVariance::robust;
  }
  const LogisticFit fit = fit_logistic(input, options);
  std::vector<std::optional<Interval>> profiles;
  if (!request.options.no_profile && options.variance == CoefficientVariance::model) {
    profiles = profile_intervals(input, options);
  }
  return logistic_report(fit, profiles, drop_terms(input));
}

}  // namespace tcert::cli
