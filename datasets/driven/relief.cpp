#include "datasets/driven/relief.hpp"

#include <algorithm>
#include <cmath>
#include <table/random.hpp>
#include <tcert/elementary.hpp>

#include "datasets/driven/driven_draws.hpp"

namespace tcert {
namespace {

constexpr double kPatchRadius = 0.4;  // m: as wide as a lane
constexpr double kSteepest = 3.0;

bool holds(const ReliefPatch& patch, Point p) noexcept {
  return distance(patch.area.centre, p) <= patch.area.radius_m;
}

Point gradient_at(std::span<const ReliefPatch> relief, Point p) noexcept {
  Point gradient;
  for (const ReliefPatch& patch : relief) {
    if (holds(patch, p)) {
      gradient = gradient + patch.slope * patch.up;
    }
  }
  return gradient;
}

double square_share(double value, double limit) noexcept {
  const double share = std::clamp(value / limit, 0.0, 1.0);
  return share * share;
}

}  // namespace

Footing footing_at(std::span<const ReliefPatch> relief, const Pose& pose) noexcept {
  const Point gradient = gradient_at(relief, pose.position);
  const Point heading = direction(pose.yaw_rad);
  const double along = dot(gradient, heading);
  Footing footing;
  footing.pitch_rad = elementary::atan2(along, 1.0);
  footing.roll_rad = elementary::atan2(cross(heading, gradient), std::sqrt(1.0 + along * along));
  footing.step_m = 0.0;
  for (const ReliefPatch& patch : relief) {
    if (holds(patch, pose.position)) {
      footing.step_m = std::max(footing.step_m, patch.step_m);
    }
  }
  return footing;
}

double tread_loss(std::span<const ReliefPatch> relief,
                  Point at,
                  Point along,
                  const DriveParameters& parameters) noexcept {
  double left = 1.0 - square_share(dot(gradient_at(relief, at), along), parameters.slope_limit);
  for (const ReliefPatch& patch : relief) {
    if (holds(patch, at) && dot(patch.area.centre - at, along) > 0.0) {
      left *= 1.0 - square_share(patch.step_m, parameters.step_limit_m);
    }
  }
  return 1.0 - left;
}

std::vector<ReliefPatch> draw_relief(const DriveParameters& parameters,
                                     const std::vector<std::vector<std::vector<Point>>>& lobes,
                                     std::uint64_t seed,
                                     std::uint64_t index) {
  std::vector<ReliefPatch> relief;
  if (parameters.ramp_share == 0.0 && parameters.step_share == 0.0) {
    return relief;
  }
  table::RandomStream random(seed, draws::kGatedRelief, index);
  const double shared = std::sqrt(parameters.gate_correlation) * random.normal();
  const double own = std::sqrt(1.0 - parameters.gate_correlation);
  for (const auto& lanes : lobes) {
    for (const std::vector<Point>& lane : lanes) {
      for (const bool is_ramp : {true, false}) {
        const bool is_there =
            random.uniform() < (is_ramp ? parameters.ramp_share : parameters.step_share);
        const auto place = static_cast<std::size_t>(random.uniform(0.3, 0.7) *
                                                    static_cast<double>(lane.size() - 1));
        const double level = shared + own * random.normal();
        const bool is_down = random.below(2) == 1;
        if (!is_there) {
          continue;
        }
        const Point way = lane[place + 1] - lane[place];
        ReliefPatch patch;
        patch.area = {lane[place], kPatchRadius};
        patch.up = (is_down ? -1.0 : 1.0) / norm(way) * way;
        if (is_ramp) {
          patch.slope =
              std::clamp(parameters.ramp_slope + parameters.ramp_sd * level, 0.0, kSteepest);
        } else {
          patch.step_m = std::max(parameters.step_height_m + parameters.step_sd_m * level, 0.0);
        }
        relief.push_back(patch);
      }
    }
  }
  return relief;
}

}  // namespace tcert
