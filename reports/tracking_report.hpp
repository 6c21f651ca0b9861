#pragma once
/// \file
/// Tracking buffers, and tables of tracking errors, as documents.

#include <tcert/tracking_bound.hpp>
#include <vector>

#include "analysis/study/tracking/tracking_buffers.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Table tracking_runs, and the attachments `buffers`, which --config takes, and `robot`, for
/// bundle.json. \param same_time the buffer is that of the paper's formula as printed, not that of
/// paths.
[[nodiscard]] FitReport tracking_buffers_report(const study::TrackingBuffers& buffers,
                                                const study::TrackingOptions& options,
                                                bool same_time);

/// Table tracking_error, a row a knot: speeds times speeds just left times no disturbance and the
/// model's whole one. radius_m is r(max(v, v_left)), hold_s how long r(v_left) holds under
/// the whole disturbance, whichever the row's. \pre a bound
/// at all speeds, which rise from 0.
[[nodiscard]] FitReport tracking_bound_report(const DoubleIntegrator& model,
                                              const std::vector<double>& speeds_mps);

}  // namespace tcert
