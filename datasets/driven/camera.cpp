#include "datasets/driven/camera.hpp"

#include <array>
#include <cmath>
#include <tcert/mirror_exact.hpp>
#include <utility>

namespace tcert {

Camera::Camera(const DriveParameters& parameters,
               WallIndex walls,
               Lighting lighting,
               bool mirrored,
               table::RandomStream random)
    : parameters_(parameters),
      walls_(std::move(walls)),
      seen_(std::array{parameters.seen_dark,
                       parameters.seen_indoor,
                       parameters.seen_outdoor}[static_cast<std::size_t>(lighting)]),
      heading_sd_rad_(
          std::array{parameters.camera_heading_sd_dark_rad,
                     parameters.camera_heading_sd_indoor_rad,
                     parameters.camera_heading_sd_outdoor_rad}[static_cast<std::size_t>(lighting)]),
      mirrored_(mirrored),
      random_(random) {
  sightings_.reserve(parameters.camera_rays);
}

std::span<const policies::Sighting> Camera::look(std::int64_t now_ns, const Pose& pose) {
  if (now_ns < next_frame_ns_) {
    return sightings_;
  }
  next_frame_ns_ = now_ns + std::llround(1e9 / parameters_.camera_hz);
  sightings_.clear();
  const double side = mirrored_ ? -1.0 : 1.0;
  const double off = side * heading_sd_rad_ * random_.normal();
  const auto last = static_cast<double>(parameters_.camera_rays - 1);
  for (std::uint32_t i = 0; i < parameters_.camera_rays; ++i) {
    const double share = side * (last - 2.0 * static_cast<double>(i)) / last;  // left edge: 1
    const double bearing = share * parameters_.camera_half_angle_rad;
    const bool is_seen = random_.uniform() < seen_;
    const double range = walls_.cast(pose.position,
                                     pose.position,
                                     policies::unit(pose.yaw_rad + bearing),
                                     parameters_.camera_range_m);
    if (is_seen && range < parameters_.camera_range_m) {
      sightings_.push_back({bearing + off, range});
    }
  }
  return sightings_;
}

}  // namespace tcert
