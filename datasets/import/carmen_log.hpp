#pragma once
/// \file
/// Logs of the Carnegie Mellon robot navigation toolkit (CARMEN): laser scans with the poses at
/// which they were taken.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/diagnostic.hpp>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/import/carmen_beams.hpp"
#include "datasets/import/carmen_poses.hpp"

namespace tcert {

/// Where the time of a scan is taken from.
enum class CarmenClock {
  ipc,     ///< Its ipc_timestamp.
  logger,  ///< Its logger_timestamp.
  order,   ///< Its place among the records, at an even rate.
};

struct CarmenReading {
  std::optional<double> fov_rad;  ///< Of FLASER records; see flaser_beams().
  CarmenClock clock = CarmenClock::ipc;
  double rate_hz = 0.0;  ///< Of CarmenClock::order.
};

/// The scans of a log, in order of time: all FLASER records, or all ROBOTLASER1 records, by the
/// first that there is.
struct CarmenLog {
  std::string kind;  ///< "FLASER" or "ROBOTLASER1".
  CarmenBeams beams;
  std::vector<std::int64_t> time_ns;
  std::vector<Pose> poses;    ///< Of the robot; of the laser where its place is not known.
  std::optional<Pose> mount;  ///< Of the laser on the robot, if the records agree on it.
  CarmenPoses origin = CarmenPoses::unknown;
  std::vector<double> ranges_m;  ///< Row-major, scans x beams; NaN missing, infinite no return.
  std::size_t records = 0;       ///< Of that kind, used or not.
  std::size_t odometry_records = 0;
  std::size_t other_records = 0;  ///< Neither of that kind nor ODOM nor comments.

  [[nodiscard]] std::size_t scans() const noexcept { return time_ns.size(); }
};

/// True if nine of ten records or more are used.
[[nodiscard]] bool keeps_most_scans(const CarmenLog& log) noexcept;

/// Reads a log. A record that cannot be read, has other beams than the first, or is not later than
/// the one before it is not used: a warning with its line. Errors, of which the log is of no use:
/// no scan at all; fewer than nine of ten records used, with the way out where it is the stamps
/// that carry no order; a number of beams whose directions are not known; `fov_rad` for records
/// that state their angles. \pre rate_hz > 0 for CarmenClock::order. O(size).
[[nodiscard]] CarmenLog read_carmen_log(const table::Bytes& bytes,
                                        const std::string& file,
                                        const CarmenReading& reading,
                                        table::DiagnosticGroups& problems);

}  // namespace tcert
