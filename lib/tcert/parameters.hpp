#pragma once
/// \file
/// Parameters of the certificate. Every ablation and sweep is another value of these.

#include <cstdint>
#include <numbers>

namespace tcert {

/// How the free width at a tick is read from the two sides.
enum class ClearanceReading {
  width,   ///< left + right: the width across the heading.
  radial,  ///< 2 min(left, right): the disc centred on the robot.
  swept,   ///< T_t by the disc that fits into the swept area; what a tick says at once by width.
};

/// How the turn radius at a tick is read (paper 3.1, P2).
enum class CurvatureReading {
  path,             ///< From the executed path.
  contact,          ///< From three contacts of one ray, the wall's side accounted for.
  contact_literal,  ///< From three contacts as the paper prints it; for sensitivity only.
  none,             ///< Ablation A3: no curvature constraint.
};

/// What unprobed space is taken for (paper 3.3, A2).
enum class UnknownSpace {
  occupied,  ///< Pessimistic: a sound lower bound.
  free,      ///< Ablation A2: free until contradicted.
};

struct CertificateParameters {
  ClearanceReading clearance = ClearanceReading::width;
  CurvatureReading curvature = CurvatureReading::path;
  UnknownSpace unknown = UnknownSpace::occupied;

  // Clearance. A side is felt by the rays within side_angle_rad of square to the heading, and is
  // their minimum over the last side_window_m of travel; 0 stands for the body width.
  double side_angle_rad = std::numbers::pi / 6.0;
  double side_window_m = 0.0;
  double travel_deadband_m = 0.01;  ///< Travel counts once the robot is this far off; > 0.

  // Swept area (clearance = swept).
  double swept_cell_m = 0.02;
  double least_obstacle_m = 0.08;  ///< No obstacle is narrower.
  /// At depth h behind its tip every obstacle is at least 2 h tan(half of it) wide, up to
  /// least_obstacle_m; at most pi/2.
  double sharpest_corner_rad = 0.5 * std::numbers::pi;
  /// Travel after which the clearance of a place is settled; at most 1e5 travel_deadband_m.
  double swept_lag_m = 1.0;

  // Turn radius.
  double curvature_window_m = 0.25;
  double curvature_min_travel_m = 0.10;  ///< Below it the radius is 1/min_curvature_per_m.
  double min_curvature_per_m = 1e-3;     ///< epsilon of the paper; > 0.
  double contact_spacing_m = 0.15;       ///< Between the contacts of a triple.
  double contact_literal_spacing_m = 0.02;
  double contact_window_m = 1.0;   ///< Travel within which a triple lies.
  double contact_flatness = 0.02;  ///< Least height of the triangle / longest side.
  double sigma_contact_m = 0.003;  ///< Noise of a contact point; height >= 3 sigma.

  // Contact.
  double contact_on_n = 0.5;
  double contact_off_n = 0.3;
  double contact_slack_m = 0.01;  ///< Without a force sensor: contact if clearance < reach - this.

  // Corridor graph.
  double edge_length_m = 0.25;
  double merge_radius_m = 0.15;
  double merge_angle_rad = std::numbers::pi / 9.0;
  double reversal_m = 0.05;
  double max_step_m = 0.25;

  // Contact memory M_t, the risk prior; memory_weight_m = 0 is ablation A1.
  double memory_weight_m = 0.05;  ///< lambda_M.
  double memory_cell_m = 0.10;
  double memory_gain = 0.1;
  double force_cap_n = 5.0;
  double memory_sigma_m = 0.15;
  double memory_half_life_s = 20.0;

  // Capacity, taken once at construction.
  std::uint32_t max_nodes = 4096;
  std::uint32_t max_edges = 8192;
  std::uint32_t max_memory_cells = 65536;
  std::uint32_t max_swept_cells = 1U << 22U;
};

/// \throws std::invalid_argument naming the parameter, its value and the range it must lie in.
void validate(const CertificateParameters& parameters);

}  // namespace tcert
