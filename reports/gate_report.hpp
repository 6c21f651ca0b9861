#pragma once
/// \file
/// The micro-study as a document.

#include "analysis/study/gate/gate_study.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Tables gate (the 50 % point and its sets), gate_slope, gate_calibration, gate_model (with the
/// certificate before the gate), gate_passes.
[[nodiscard]] FitReport gate_report(const study::GateStudy& study);

}  // namespace tcert
