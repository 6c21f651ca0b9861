#pragma once
/// \file
/// The calibration of rays as a document.

#include <tcert/robot.hpp>
#include <vector>

#include "analysis/study/rays/ray_calibration.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// What the calibration is for.
struct CalibratedRays {
  std::vector<Ray> rays;     ///< With their new calibrations, in the order of bundle.json.
  bool of_a_bundle = false;  ///< They have mounts and reaches; else names and calibrations alone.
};

/// Tables ray_knots (the calibration), ray_curves (how each was fitted), ray_days (what each day was used
/// for, and its score), and the attachment `rays`: the list of bundle.json, or what each of its
/// elements needs.
[[nodiscard]] FitReport ray_calibration_report(const study::RayCalibration& calibration,
                                               const study::RayCalibrationOptions& options,
                                               const CalibratedRays& rays);

}  // namespace tcert
