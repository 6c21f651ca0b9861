#include "datasets/import/carmen_log.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "datasets/import/carmen_record.hpp"
#include "datasets/import/carmen_stamps.hpp"

namespace tcert {
namespace {

constexpr std::string_view kFlaser = "FLASER";
constexpr std::string_view kRobotLaser = "ROBOTLASER1";

/// Takes the lines of a log one after another.
class CarmenLines {
 public:
  CarmenLines(const std::string& file,
              const CarmenReading& reading,
              table::DiagnosticGroups& problems)
      : file_(file), reading_(reading), problems_(problems), stamps_(reading) {}

  void take(std::string_view line, std::size_t number) {
    const std::string_view kind = take_word(line);
    if (kind.empty() || kind.front() == '#') {
      return;
    }
    if (kind == "ODOM") {
      ++log_.odometry_records;
      if (const std::optional<Pose> pose = read_odom(line)) {
        track_.odometry.push_back(*pose);
      }
      return;
    }
    if (log_.kind.empty() && (kind == kFlaser || kind == kRobotLaser)) {
      log_.kind = kind;
    }
    if (kind != log_.kind) {
      ++log_.other_records;
      return;
    }
    ++log_.records;
    if (std::optional<CarmenFault> fault = take_scan(line, number)) {
      problems_.add({table::Severity::warning,
                     file_,
                     number,
                     std::move(fault->field),
                     std::move(fault->value),
                     fault->expectation + "; the record is not used",
                     1});
    }
  }

  CarmenLog finish() {
    say_what_is_lost();
    find_poses();
    return std::move(log_);
  }

 private:
  std::optional<CarmenFault> take_scan(std::string_view line, std::size_t number) {
    const bool is_flaser = log_.kind == kFlaser;
    std::optional<CarmenFault> fault =
        is_flaser ? read_flaser(line, scan_) : read_robot_laser(line, scan_);
    std::int64_t time_ns = 0;
    if (fault) {
      stamps_.skip();
      return fault;
    }
    if (log_.beams.count == 0) {
      set_beams(is_flaser, number);
    } else if (scan_.beams.count != log_.beams.count) {
      fault = CarmenFault{"number of beams",
                          std::to_string(scan_.beams.count),
                          "as many beams as the first scan has"};
    } else if (!is_flaser && !(scan_.beams == log_.beams)) {
      fault = CarmenFault{"start_angle", "other angles", "the angles and reach of the first scan"};
    }
    if (fault) {
      stamps_.skip();
      return fault;
    }
    fault = stamps_.take(scan_, time_ns);
    if (!fault) {
      append(time_ns);
    }
    return fault;
  }

  void set_beams(bool is_flaser, std::size_t number) {
    log_.beams = scan_.beams;
    if (!is_flaser) {
      if (reading_.fov_rad) {
        fail(number, "field_of_view", "--fov", "no --fov: ROBOTLASER1 records state their angles");
      }
      return;
    }
    if (const auto known = flaser_beams(scan_.beams.count, reading_.fov_rad)) {
      log_.beams = *known;
      return;
    }
    fail(number,
         "number of beams",
         std::to_string(scan_.beams.count),
         "180 or 181 beams (from -90 degrees, 1 degree apart) or 360 or 361 (half a degree apart): "
         "where others point the log does not say; --fov DEG spreads them from -DEG/2 to +DEG/2");
  }

  void append(std::int64_t time_ns) {
    log_.time_ns.push_back(time_ns);
    log_.ranges_m.insert(log_.ranges_m.end(), scan_.ranges_m.begin(), scan_.ranges_m.end());
    track_.laser.push_back(scan_.laser);
    track_.robot.push_back(scan_.robot);
    track_.odometry_before.push_back(track_.odometry.size());
  }

  void say_what_is_lost() {
    if (log_.records == 0) {
      fail(0, "", "no scan", "at least one FLASER or ROBOTLASER1 record");
      return;
    }
    if (keeps_most_scans(log_)) {
      return;
    }
    if (2 * stamps_.lost() > log_.records - log_.scans()) {
      fail(0, stamps_.field(), stamps_.summary(), stamps_.way_out());
      return;
    }
    fail(
        0,
        "",
        std::to_string(log_.scans()) + " scans that can be used of " + std::to_string(log_.records),
        "nine of ten at least; the warnings say what is wrong with the others");
  }

  void find_poses() {
    const bool is_flaser = log_.kind == kFlaser;
    log_.mount = laser_mount(track_, is_flaser);
    log_.poses = track_.laser;
    if (log_.mount && (log_.mount->position != Point{} || log_.mount->yaw_rad != 0.0)) {
      const Pose robot = seen_from(*log_.mount, {});
      for (Pose& pose : log_.poses) {
        pose = compose(pose, robot);
      }
    }
    log_.origin = origin_of(log_.poses, track_);
  }

  void fail(std::size_t line, std::string field, std::string value, std::string expectation) {
    problems_.add({table::Severity::error,
                   file_,
                   line,
                   std::move(field),
                   std::move(value),
                   std::move(expectation),
                   1});
  }

  const std::string& file_;
  const CarmenReading& reading_;
  table::DiagnosticGroups& problems_;
  CarmenStamps stamps_;
  CarmenLog log_;
  CarmenTrack track_;
  CarmenScan scan_;
};

}  // namespace

bool keeps_most_scans(const CarmenLog& log) noexcept { return 10 * log.scans() >= 9 * log.records; }

CarmenLog read_carmen_log(const table::Bytes& bytes,
                          const std::string& file,
                          const CarmenReading& reading,
                          table::DiagnosticGroups& problems) {
  CarmenLines lines(file, reading, problems);
  std::string_view rest = bytes.view();
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    lines.take(rest.substr(0, length), number);
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return lines.finish();
}

}  // namespace tcert
