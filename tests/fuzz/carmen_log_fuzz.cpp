// Any bytes as a CARMEN log: the reader neither throws nor reads outside, says why it rejects, and
// what it takes is in order of time, whole and finite.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "datasets/import/carmen_log.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const CarmenClock clock : {CarmenClock::ipc, CarmenClock::logger, CarmenClock::order}) {
    for (const bool has_fov : {false, true}) {
      CarmenReading reading;
      reading.clock = clock;
      reading.rate_hz = 10.0;
      if (has_fov) {
        reading.fov_rad = 3.0;
      }
      table::DiagnosticGroups problems;
      const CarmenLog log =
          read_carmen_log(table::Bytes::copy_of(text), "fuzz.log", reading, problems);
      fuzz::require(problems.has_error() || keeps_most_scans(log), "most scans, or a reason");
      fuzz::require(problems.has_error() || log.scans() > 0, "a scan, or a reason");
      fuzz::require(log.scans() <= log.records, "no more scans than records");
      fuzz::require(log.poses.size() == log.scans(), "a pose a scan");
      fuzz::require(log.ranges_m.size() == log.scans() * log.beams.count, "a range a beam");
      for (const double range : log.ranges_m) {
        fuzz::require(!(range < 0.0), "no negative range");
      }
      for (std::size_t i = 0; i < log.scans(); ++i) {
        fuzz::require(i == 0 || log.time_ns[i] > log.time_ns[i - 1], "times rise");
        fuzz::require(std::isfinite(log.poses[i].position.x_m) &&
                          std::isfinite(log.poses[i].position.y_m) &&
                          std::isfinite(log.poses[i].yaw_rad),
                      "finite poses");
      }
    }
  }
  return 0;
}
