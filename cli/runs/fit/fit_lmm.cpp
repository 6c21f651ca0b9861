#include <statistics/lmm/lmm.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/contrasts.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/lmm_report.hpp"

namespace tcert::cli {

FitReport fit_linear_mixed_model(const FitInput& from) {
  if (from.frame.cluster || from.frame.strata) {
    throw UsageError("lmm takes no cluster and no strata: write (1 | group)");
  }
  statistics::LmmOptions options;
  options.level = from.request.level;
  options.restricted = !from.request.ml;
  const statistics::LmmFit fit = statistics::fit_lmm(statistics::lmm_input(from.frame), options);
  FitReport report = lmm_report(fit, from.frame.response, ratio_of_response(from.formula));
  add_contrasts(from, fit, report);
  return report;
}

}  // namespace tcert::cli
