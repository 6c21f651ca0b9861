#pragma once
/// \file
/// Logs of the Carnegie Mellon robot navigation toolkit (CARMEN): laser scans with corrected poses.

#include <cstddef>
#include <cstdint>
#include <string>
#include <table/bytes.hpp>
#include <table/diagnostic.hpp>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert {

/// The FLASER records of a log, in order of time.
///
/// `FLASER n r_1..r_n x y theta odom_x odom_y odom_theta ipc_timestamp host logger_timestamp`:
/// n beams spread over 180 degrees from right to left, beam i (from 0) at -90 + (i + 0.5) 180/n
/// degrees from the heading, and the pose that scan matching gave. http://carmen.sourceforge.net.
struct CarmenLog {
  std::size_t beams = 0;
  std::vector<std::int64_t> time_ns;  ///< ipc_timestamp.
  std::vector<Pose> poses;            ///< Corrected, not the odometry.
  std::vector<double> ranges_m;       ///< Row-major, scans x beams.
  std::size_t odometry_records = 0;
  std::size_t other_records = 0;  ///< Neither FLASER nor ODOM nor comments.

  [[nodiscard]] std::size_t scans() const noexcept { return time_ns.size(); }
};

/// Reads a log. A FLASER record that cannot be read, has another number of beams than the first, or
/// is not later than the one before it is not used: a warning with its line. No scan at all is an
/// error. ODOM records are counted only: they are in the frame of the raw odometry, which drifts
/// away from that of the corrected poses.
[[nodiscard]] CarmenLog read_carmen_log(const table::Bytes& bytes,
                                        const std::string& file,
                                        table::DiagnosticGroups& problems);

/// Bearing of a beam. \pre beam < beams.
[[nodiscard]] double carmen_bearing_rad(std::size_t beam, std::size_t beams) noexcept;

}  // namespace tcert
