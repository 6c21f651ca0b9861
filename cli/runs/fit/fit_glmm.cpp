#include <optional>

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_comparison.hpp>
#include <statistics/glmm/glmm_profile.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/contrasts.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/glmm_report.hpp"

namespace tcert::cli {
namespace {

statistics::GlmmOptions glmm_options(const FitRequest& request,
                                     const statistics::GlmmInput& input) {
  statistics::GlmmOptions result;
  result.level = request.level;
  if (request.quadrature) {
    if (*request.quadrature > 1 && !statistics::is_single_intercept(input)) {
      throw UsageError("--quadrature above 1 is for a single random intercept, (1 | group)");
    }
    result.quadrature = static_cast<int>(*request.quadrature);
  }
  return result;
}

}  // namespace

FitReport fit_mixed_model(const FitInput& from) {
  if (from.frame.cluster || from.frame.strata || from.request.robust) {
    throw UsageError("glmm takes no cluster, strata or --robust: write (1 | group)");
  }
  const statistics::GlmmInput input = statistics::glmm_input(from.frame);
  const statistics::GlmmOptions options = glmm_options(from.request, input);
  const statistics::GlmmFit fit = statistics::fit_glmm(input, options);
  statistics::GlmmProfile profile;
  if (from.request.profile) {
    std::optional<Stage> stage;
    profile = statistics::glmm_profile(
        input,
        options,
        {[&](std::size_t ends) { stage.emplace(from.progress, "profile ends", ends); },
         [&] { stage->advance(); }});
  }
  std::vector<statistics::DroppedTerm> dropped;
  if (from.request.drop1) {
    dropped = statistics::drop_terms(input, options);
  }
  FitReport report = glmm_report(fit, profile, dropped);
  add_contrasts(from, fit, report);
  return report;
}

}  // namespace tcert::cli
