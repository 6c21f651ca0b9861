#pragma once
/// \file
/// The bundle.json of a CARMEN log.

#include <optional>
#include <string>
#include <tcert/region.hpp>

#include "datasets/bundle.hpp"
#include "datasets/import/carmen_log.hpp"

namespace tcert {

struct CarmenImportOptions {
  std::string trial_id = "carmen";  ///< Name of a folder: no / and \.
  double body_width_m = 0.45;
  double start_radius_m = 0.5;  ///< S is the disc of this radius at the first pose.
  std::optional<Disc> goal;     ///< G; without one there is only the on-policy corridor value.
  double reach_m = 8.0;         ///< Readings of this and more are clamped to it.
  CarmenReading reading;
};

/// What was imported.
struct CarmenSummary {
  std::size_t scans = 0;
  std::size_t beams = 0;
  std::size_t odometry_records = 0;  ///< Not used.
  std::size_t clamped_readings = 0;
  std::size_t missing_readings = 0;
  double reach_m = 0.0;  ///< That readings were clamped to: the option, or what the laser measures.
  double duration_s = 0.0;
  double distance_m = 0.0;     ///< Length of the polyline through the poses.
  double median_step_m = 0.0;  ///< Of all steps between consecutive scans, standing ones included.
  double longest_step_m = 0.0;
  double longest_silence_s = 0.0;
};

/// Everything but the counts of readings. \pre the log has a scan.
[[nodiscard]] CarmenSummary summarise(const CarmenLog& log, const CarmenImportOptions& options);

/// The bundle.json of an imported log: a range ray b000, b001, ... per beam, where the laser is, no
/// limit on the turn radius, and parameters for scans that were kept only every half metre or so:
///
/// - `edge_length_m` 1.0, `max_step_m` 1.5: with 0.67 m between scans (median of all steps of the
///   Intel Research Lab log; 90 % below 1.02, all below 1.16) an edge holds two or three scans, and
///   no pair of consecutive scans is a break.
/// - `merge_radius_m` 0.75: laps drive the same corridor up to this far apart.
/// - `reversal_m` 0.3: a robot that turns between two scans seems to back up by less than that.
/// - `side_window_m` 0.7: the last scan counts besides this one, so that what lies between two
/// scans
///   is judged by both.
/// - `side_angle_rad` 0.8: beams up to 46 degrees off square see a door post 0.33 m beside the path
///   from half a step before it, so that no post falls between two scans.
/// - `travel_deadband_m` 0.02: the default of 0.01 is within the noise of scan matching.
/// - `curvature` none: a differential drive turns on the spot.
/// - `memory_weight_m` 0: a beam's return is not a contact, so there is no contact memory.
///
/// `max_gap_s` is 60: the logger kept a scan only once the robot had moved, so a silence is a stop,
/// and a break of the path shows as a step in space instead. The provenance says what the poses
/// are, where the beams point if the log did not say it, and what the times are made from.
/// \pre the log has a scan.
[[nodiscard]] BundleInfo carmen_bundle_info(const CarmenLog& log,
                                            const std::string& source,
                                            const CarmenImportOptions& options);

}  // namespace tcert
