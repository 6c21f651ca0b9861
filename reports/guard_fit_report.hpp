#pragma once
/// \file
/// What `calibrate guards` prints.

#include "analysis/study/assurance/guard_fit.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Tables: the front, the folds, the risk by epsilon; every choice as detail; the best one as a
/// config file, which names the tracking-error table that it was chosen with.
[[nodiscard]] FitReport guard_fit_report(const study::GuardFit& fit,
                                         const study::GuardFitOptions& options,
                                         const std::string& tracking_error);

}  // namespace tcert
