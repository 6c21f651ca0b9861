#pragma once
/// \file
/// The robot of the corpus and what its tentacles read off the walls.

#include <array>
#include <cstddef>
#include <optional>
#include <table/random.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

#include "datasets/corpus/wall_index.hpp"

namespace tcert {

inline constexpr std::size_t kTentacles = 3;  ///< Left, right, front.
inline constexpr std::size_t kFront = 2;
inline constexpr double kSensingRange = 0.70;  ///< From the body's centre to the tip of any, m.

/// Body 0.45 m wide, least turn radius 0.35 m; lateral tentacles 0.16 m ahead of the centre and
/// 0.12 m to the side, square to the heading, reach 0.45 m: they feel a wall up to 0.57 m from the
/// centre line, so the middle of a 1.2 m lane feels free and every gate is felt on both sides. One
/// frontal tentacle.
[[nodiscard]] const Robot& corpus_robot();

/// To a multiple of 1 / scale, as loggers write it; never -0.
[[nodiscard]] double rounded_to(double value, double scale) noexcept;

/// Distance from each tentacle's mount to the first wall, at most its reach; of the frontal one
/// along `front_rad`, if a joint moves it.
[[nodiscard]] std::array<double, kTentacles> cast_tentacles(const WallIndex& walls,
                                                            const Pose& pose,
                                                            double front_rad = kMissing) noexcept;

/// The tentacles of one trial: their noise, their day's calibration bias, and the state of each
/// force sensor.
class TentacleSensors {
 public:
  /// Noise is drawn per tentacle: 5 to 8 mm of clearance, one standard deviation. Most of it is
  /// the wall's texture, waves of 6 to 20 cm of travel; 1.5 mm of it is white. `mirrored` gives the
  /// left tentacle the draws of the right one, and the right one those of the left. `noise_scale`
  /// is that of noise, glitches' share and bias.
  TentacleSensors(double calibration_bias_m,
                  table::RandomStream random,
                  bool mirrored = false,
                  double noise_scale = 1.0);

  /// Readings at the next sample, at a true speed of `speed_mps`. A tentacle touches when its wall
  /// comes 4 mm into reach, which is what it takes to load the force sensor, and lets go when the
  /// wall leaves its reach: a straight tip has nothing to press on. A sample without a wall in
  /// reach never touches. One sample in 200 is a glitch, a bend drawn from its whole range. A tip
  /// rubs harder the faster it is drawn along: 9 N per m/s above 0.04 m/s, at least 0.58 N; a free
  /// one reads its noise, 0.03 N. `front_rad` is the bearing of a frontal tentacle that a joint
  /// moves, and goes into its reading; NaN of one that is fixed.
  [[nodiscard]] std::array<RayReading, kTentacles> read(const WallIndex& walls,
                                                        const Pose& pose,
                                                        double speed_mps,
                                                        double front_rad = kMissing) noexcept;

 private:
  static constexpr std::size_t kWaves = 4;
  struct Wave {
    double per_metre = 0.0;
    double phase = 0.0;
  };

  /// Of unit variance over the phases.
  [[nodiscard]] double texture(std::size_t tentacle) const noexcept;

  double calibration_bias_m_ = 0.0;
  double noise_scale_ = 1.0;
  table::RandomStream random_;
  std::array<std::size_t, kTentacles> order_;  ///< In which the tentacles draw.
  std::array<double, kTentacles> noise_m_{};
  std::array<std::array<Wave, kWaves>, kTentacles> texture_{};
  double travelled_m_ = 0.0;
  std::optional<Point> last_;
  std::array<bool, kTentacles> touching_{};
};

}  // namespace tcert
