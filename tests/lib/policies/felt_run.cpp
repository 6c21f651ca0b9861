#include "lib/policies/felt_run.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tcert::policies {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 0.02;

// Index of a ray in the mirrored robot: 0 and 1, 2 and 3, 6 and 7 change places.
constexpr std::array<std::size_t, 8> kImage{1, 0, 3, 2, 4, 5, 7, 6};

Ray tentacle(const char* name, Point mount, double bearing_rad) {
  return {name, mount, bearing_rad, 0.45, RayKind::bend, {{0.0, 0.6, 1.2}, {0.45, 0.22, 0.0}}};
}

Ray beam(const char* name, Point mount, double bearing_rad) {
  return {name, mount, bearing_rad, 0.6, RayKind::range, {}};
}

}  // namespace

PolicySetup two_lobes() {
  PolicySetup setup;
  setup.robot.min_turn_radius_m = 0.35;
  setup.robot.rays = {tentacle("left", {0.16, 0.12}, 0.5 * kPi),
                      tentacle("right", {0.16, -0.12}, -0.5 * kPi),
                      tentacle("left_ahead", {0.2, 0.1}, 0.25 * kPi),
                      tentacle("right_ahead", {0.2, -0.1}, -0.25 * kPi),
                      tentacle("front", {0.22, 0.0}, 0.0),
                      tentacle("back", {-0.22, 0.0}, kPi),
                      beam("left_beam", {0.0, 0.1}, 1.3),
                      beam("right_beam", {0.0, -0.1}, -1.3)};
  setup.line.low = {-2.0, -1.5};
  setup.line.high = {2.5, 2.0};
  setup.line.lobes = {
      {{{{-1.5, 0.0}, {-1.0, 0.7}, {0.0, 0.1}}, {{-1.5, 0.0}, {-0.9, -0.8}, {0.0, 0.1}}}},
      {{{{0.0, 0.1}, {1.0, -0.6}, {2.0, 0.3}}, {{0.0, 0.1}, {1.1, 0.9}, {2.0, 0.3}}}}};
  return setup;
}

PolicySetup mirrored(const PolicySetup& setup) {
  PolicySetup image = setup;
  image.line.low.y_m = -setup.line.high.y_m;
  image.line.high.y_m = -setup.line.low.y_m;
  for (Lobe& lobe : image.line.lobes) {
    for (LaneLine& lane : lobe.lanes) {
      for (Point& p : lane) {
        p.y_m = -p.y_m;
      }
    }
  }
  return image;
}

FeltRun::FeltRun(std::uint32_t seed, std::size_t rays, bool wild)
    : engine_(seed), wild_(wild), readings_(rays), mirrored_readings_(rays) {
  pose_ = {{-1.5, 0.01}, 0.2};
  sightings_.reserve(16);
  mirrored_sightings_.reserve(16);
}

double FeltRun::uniform(double low, double high) {
  return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
}

double FeltRun::spoilt(double value) {
  if (!wild_ || !happens(0.02)) {
    return value;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 6> kSpoilt{
      std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e300, -1e300, 1e12};
  return kSpoilt[engine_() % kSpoilt.size()];
}

void FeltRun::move(const Command& last) {
  held_ = held_ > 0 ? held_ - 1 : happens(0.002) ? 400 : 0;
  const double share = held_ > 0 && last.speed_mps > 0.0 ? 0.0 : 1.0;
  pose_.yaw_rad += kStep * last.yaw_rate_rps + uniform(-1e-3, 1e-3);
  const double way_m = share * kStep * last.speed_mps;
  pose_.position.x_m += way_m * std::cos(pose_.yaw_rad) + uniform(-1e-4, 1e-4);
  pose_.position.y_m += way_m * std::sin(pose_.yaw_rad) + uniform(-1e-4, 1e-4);
  if (std::abs(pose_.position.x_m) > 1.9 || std::abs(pose_.position.y_m) > 1.4) {
    pose_ = {{uniform(-1.5, 1.5), uniform(-1.0, 1.0)}, uniform(-kPi, kPi)};  // carried back
  }
  senses_.travel_m += std::abs(way_m);
  senses_.speed_mps = last.speed_mps;
}

void FeltRun::feel() {
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const bool beam = i >= 6;
    const bool touches = happens(0.15);
    const double bend = touches ? 0.1 * std::floor(uniform(0.0, 12.0)) : 0.0;
    const double value = beam ? (touches ? 0.1 * std::floor(uniform(0.0, 6.0)) : 0.6) : bend;
    const double force_n = touches ? 0.25 * std::floor(uniform(0.0, 12.0)) : 0.02;
    readings_[i].value = spoilt(happens(0.02) ? kMissing : value);
    readings_[i].fsr_n = spoilt(beam || happens(0.02) ? kMissing
                                : happens(0.0005)     ? 60.0
                                                      : force_n);
  }
  senses_.bump.reset();
  if (held_ > 0 ? happens(0.5) : happens(0.01)) {
    senses_.bump = Bump{spoilt(uniform(-kPi, kPi)), spoilt(uniform(0.0, 80.0))};
  }
}

void FeltRun::see() {
  sightings_.clear();
  const auto seen = engine_() % 14;
  for (std::uint32_t i = 0; i < seen; ++i) {
    sightings_.push_back(
        {spoilt(uniform(-0.6, 0.6)), spoilt(0.25 * std::floor(uniform(0.0, 10.0)))});
  }
  senses_.camera = sightings_;
}

const Senses& FeltRun::next(const Command& last) {
  move(last);
  feel();
  see();
  senses_.tick.time_ns += 20'000'000;
  senses_.tick.pose = {{spoilt(pose_.position.x_m), spoilt(pose_.position.y_m)},
                       spoilt(pose_.yaw_rad)};
  senses_.tick.rays = readings_;
  senses_.tick.stale = happens(0.005);
  senses_.goal = {spoilt(2.2), spoilt(0.3)};
  senses_.commanded_mps = spoilt(happens(0.1) ? kMissing : last.speed_mps);
  return senses_;
}

// Sightings come from the other side of the fan first.
const Senses& FeltRun::mirrored_senses() {
  mirrored_ = senses_;
  mirrored_.tick.pose.position.y_m = -senses_.tick.pose.position.y_m;
  mirrored_.tick.pose.yaw_rad = -senses_.tick.pose.yaw_rad;
  mirrored_.goal.y_m = -senses_.goal.y_m;
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    mirrored_readings_[kImage[i]] = readings_[i];
  }
  mirrored_.tick.rays = mirrored_readings_;
  if (mirrored_.bump) {
    mirrored_.bump->bearing_rad = -mirrored_.bump->bearing_rad;
  }
  mirrored_sightings_.assign(sightings_.rbegin(), sightings_.rend());
  for (Sighting& sighting : mirrored_sightings_) {
    sighting.bearing_rad = -sighting.bearing_rad;
  }
  mirrored_.camera = mirrored_sightings_;
  return mirrored_;
}

}  // namespace tcert::policies
