#include <optional>

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_comparison.hpp>
#include <statistics/glmm/glmm_profile.hpp>

#include "cli/errors.hpp"
#include "cli/fit/fit.hpp"
#include "cli/progress.hpp"
#include "reports/fit/glmm_report.hpp"

namespace tcert::cli {
namespace {

statistics::GlmmOptions glmm_options(const FitOptions& options,
                                     const statistics::GlmmInput& input) {
  statistics::GlmmOptions result;
  result.level = options.level;
  if (options.quadrature != 0) {
    require_range("quadrature", options.quadrature, 1, statistics::kMostQuadrature);
    if (options.quadrature > 1 && !statistics::is_single_intercept(input)) {
      throw UsageError("--quadrature above 1 is for a single random intercept, (1 | group)");
    }
    result.quadrature = options.quadrature;
  }
  return result;
}

}  // namespace

FitReport fit_mixed_model(const FitRequest& request) {
  if (request.frame.cluster || request.frame.strata || request.options.robust) {
    throw UsageError("glmm takes no cluster, strata or --robust: write (1 | group)");
  }
  const statistics::GlmmInput input = statistics::glmm_input(request.frame);
  const statistics::GlmmOptions options = glmm_options(request.options, input);
  const statistics::GlmmFit fit = statistics::fit_glmm(input, options);
  statistics::GlmmProfile profile;
  if (request.options.profile) {
    std::optional<Progress> progress;
    profile = statistics::glmm_profile(
        input,
        options,
        {[&](std::size_t ends) { progress.emplace("profile ends", ends, request.options.quiet); },
         [&] { progress->advance(); }});
  }
  std::vector<statistics::DroppedTerm> dropped;
  if (request.options.drop1) {
    dropped = statistics::drop_terms(input, options);
  }
  return glmm_report(fit, profile, dropped);
}

}  // namespace tcert::cli
