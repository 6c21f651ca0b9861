#pragma once
/// \file
/// The streams that a driven robot logs while it drives, and what it senses besides.

#include <cstdint>
#include <optional>
#include <table/random.hpp>
#include <tcert/senses.hpp>
#include <vector>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/driven/body.hpp"
#include "datasets/driven/driven_design.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// One step of the body, as sensors see it: on the straight between its two poses.
struct SensedStep {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  Pose from;
  Pose to;
  double speed_mps = 0.0;
  double slip = kMissing;  ///< See Body::slip().
};

/// The corpus' tentacles at 83 Hz and its odometry at 20 Hz, on its jittered clocks with their lost
/// samples and silences, and a bumper ring; where there are ramps or steps, with each pose what is
/// underfoot. Their draws depend on the design's noise seed and index
/// alone, and on `mirrored`, which swaps left and right in each.
class DrivenSensors {
 public:
  DrivenSensors(const DrivenDesign& design, const WallIndex& walls);

  /// Appends the samples of the step, from_ns < time <= to_ns, to the streams of `log`.
  void sample(const SensedStep& step, TrialLog& log);

  /// Keeps the hardest contact until it is read.
  void feel(const Hold& hold, const Pose& pose) noexcept;
  /// The hardest contact since the last call, as the bumper measures it.
  [[nodiscard]] std::optional<policies::Bump> read_bump() noexcept;

  [[nodiscard]] double measured_speed_mps(double speed_mps) noexcept;

 private:
  /// Of the frontal tentacle, as its joint says; NaN without a joint.
  void log_footing(const Pose& pose, double slip, PoseStream& log);
  [[nodiscard]] double front_bearing_rad(std::int64_t time_ns) const noexcept;

  DriveParameters parameters_;
  const WallIndex& walls_;
  double side_;
  std::vector<std::int64_t> tactile_times_;
  std::vector<std::int64_t> pose_times_;
  std::size_t next_tactile_ = 0;
  std::size_t next_pose_ = 0;
  TentacleSensors tentacles_;
  table::RandomStream pose_random_;
  table::RandomStream bump_random_;
  table::RandomStream speed_random_;
  table::RandomStream footing_random_;
  std::vector<ReliefPatch> relief_;
  std::optional<policies::Bump> bump_;
};

}  // namespace tcert
