#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <table/random.hpp>

#include "datasets/corpus/design.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/trial_course.hpp"
#include "datasets/driven/driven_draws.hpp"
#include "datasets/driven/driven_world.hpp"

namespace tcert {
namespace {

constexpr double kBlockedWidth = 0.05;    // of a gate that lets no body through
constexpr double kLeastGateWidth = 0.05;  // where the declared distribution asks for less
constexpr double kLeastJaw = 0.05;        // of a gate's two jaws, where it asks for a lane's width
constexpr double kAlongLane = 0.2;        // from way-point to way-point
constexpr std::uint32_t kMostRedraws = 10'000;

/// Gives the gates their widths. Each lane draws as often whether it is blocked or not.
void draw_widths(std::vector<Gate>& gates,
                 const FigureEight& course,
                 double mean_margin,
                 const DriveParameters& parameters,
                 table::RandomStream& random) {
  const double shared = std::sqrt(parameters.gate_correlation) * random.normal();
  const double own = std::sqrt(1.0 - parameters.gate_correlation);
  for (Gate& gate : gates) {
    const double margin = mean_margin + parameters.gate_sd_m * (shared + own * random.normal());
    gate.width_m = std::clamp(corpus_robot().body_width_m + margin,
                              kLeastGateWidth,
                              course.lane_width_m - 2.0 * kLeastJaw);
  }
  for (std::size_t first = 0, next = 0; first < gates.size(); first = next) {
    while (next < gates.size() && gates[next].lane == gates[first].lane) {
      ++next;
    }
    const bool blocked = random.uniform() < parameters.blocked_share;
    const std::size_t which = first + random.below(static_cast<std::uint32_t>(next - first));
    if (blocked) {
      gates[which].width_m = kBlockedWidth;
    }
  }
}

/// Of the least gate of the better lane of the worse lobe.
double widest_way_margin(const std::vector<Gate>& gates) {
  double worse = std::numeric_limits<double>::infinity();
  for (const bool at_goal : {false, true}) {
    double better = -std::numeric_limits<double>::infinity();
    for (const bool upper : {false, true}) {
      double least = std::numeric_limits<double>::infinity();
      for (const Gate& gate : gates) {
        if (gate.lane == Lane{at_goal, upper}) {
          least = std::min(least, gate.width_m - corpus_robot().body_width_m);
        }
      }
      better = std::max(better, least);
    }
    worse = std::min(worse, better);
  }
  return worse;
}

/// Centre line of a lane: from S to the crossing, or from there to G.
std::vector<Point> lane_points(const FigureEight& course, Lane lane) {
  const double length = lane_length(course);
  const auto steps = static_cast<int>(std::ceil(length / kAlongLane));
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(lane_pose(course, lane, length * i / steps).position);
  }
  if (lane.at_goal) {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

}  // namespace

DrivenWorld draw_gated_world(const DriveParameters& parameters,
                             std::uint64_t seed,
                             std::uint64_t index) {
  table::RandomStream course_random(seed, draws::kGatedCourse, index);
  table::RandomStream margin_random(seed, draws::kGatedMargins, index);
  DrivenWorld driven;
  driven.day = index / kTrialsPerDay;
  const DayEffect day = day_effect(seed, driven.day);
  driven.calibration_bias_m = day.calibration_m;
  const double shift = parameters.day_sd_m * day.level;
  const FigureEight course = draw_lanes(shift, course_random);
  std::vector<Gate> gates;
  for (const bool at_goal : {false, true}) {
    const bool upper_first = course_random.below(2) == 0;
    driven.lobes.emplace_back();
    for (const bool upper : {upper_first, !upper_first}) {
      const Lane lane{at_goal, upper};
      driven.lobes.back().push_back(lane_points(course, lane));
      const std::vector<Gate> placed = place_gates(course, lane, course_random);
      gates.insert(gates.end(), placed.begin(), placed.end());
    }
    if (!at_goal) {
      driven.start = lane_pose(course, {false, upper_first}, 0.0);
    }
  }
  while (true) {
    draw_widths(gates, course, parameters.gate_margin_m + shift, parameters, margin_random);
    driven.margin_m = widest_way_margin(gates);
    if (parameters.choice == WorldChoice::any || *driven.margin_m > 0.0) {
      break;
    }
    if (++driven.redraws == kMostRedraws) {
      throw std::invalid_argument(
          "no passable world in " + std::to_string(kMostRedraws) +
          " draws: raise drive_gate_margin_m, lower drive_blocked_share, or set "
          "drive_worlds=any");
    }
  }
  for (const Gate& gate : gates) {
    driven.gate_margins_m.push_back(gate.width_m - corpus_robot().body_width_m);
  }
  driven.relief = draw_relief(parameters, driven.lobes, seed, index);
  driven.world = build_world(course, gates);
  driven.world.name = fmt::format("w{:07}", index);
  driven.world.seed = seed;
  return driven;
}

}  // namespace tcert
