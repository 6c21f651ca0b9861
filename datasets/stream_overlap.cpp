#include "datasets/stream_overlap.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "datasets/clock_reporter.hpp"

namespace tcert {
namespace {

bool is_longer(std::int64_t span_ns, double max_gap_s) noexcept {
  return static_cast<double>(std::abs(span_ns)) > max_gap_s * 1e9;
}

void compare_begins(const Stream& pose,
                    const Stream& tactile,
                    const BundleInfo& info,
                    StreamReader& reader) {
  const std::int64_t apart = tactile.table.time_ns.front() - pose.table.time_ns.front();
  if (!is_longer(apart, info.max_gap_s)) {
    return;
  }
  const bool tactile_is_late = apart > 0;
  const Stream& later = tactile_is_late ? tactile : pose;
  std::string expectation = "streams that begin together; ticks and early window begin there";
  if (tactile_is_late) {
    expectation =
        info.start_at == StartAt::pose
            ? "streams that begin together; ticks begin with the pose and are stale until "
              "there"
            : expectation + ", unless bundle.json says 'start_at': \"pose\"";
  }
  reader.report({table::Severity::warning,
                 later.file,
                 later.table.lines.front(),
                 "time_s",
                 "its begin " + seconds_text(std::abs(apart)) + " s after the other stream's",
                 std::move(expectation),
                 1});
}

void compare_ends(const Stream& pose,
                  const Stream& tactile,
                  double max_gap_s,
                  StreamReader& reader) {
  const std::int64_t apart = pose.table.time_ns.back() - tactile.table.time_ns.back();
  if (is_longer(apart, max_gap_s)) {
    const Stream& shorter = apart < 0 ? pose : tactile;
    reader.report({table::Severity::warning,
                   shorter.file,
                   shorter.table.lines.back(),
                   "time_s",
                   "its end " + seconds_text(std::abs(apart)) + " s before the other stream's",
                   "streams that end together; the ticks end where this one does",
                   1});
  }
}

}  // namespace

void compare_streams(const Stream& pose,
                     const Stream& tactile,
                     const BundleInfo& info,
                     StreamReader& reader) {
  const auto& a = pose.table.time_ns;
  const auto& b = tactile.table.time_ns;
  if (std::max(a.front(), b.front()) > std::min(a.back(), b.back())) {
    reader.report({table::Severity::error,
                   tactile.file,
                   0,
                   "time_s",
                   "no instant in common",
                   "times that overlap those of the pose: streams share one clock",
                   1});
    return;
  }
  compare_begins(pose, tactile, info, reader);
  compare_ends(pose, tactile, info.max_gap_s, reader);
}

bool shares_clock(const Stream& control,
                  const Stream& pose,
                  double max_gap_s,
                  StreamReader& reader) {
  const std::int64_t before = pose.table.time_ns.front() - control.table.time_ns.back();
  const std::int64_t after = control.table.time_ns.front() - pose.table.time_ns.back();
  const std::int64_t apart = std::max(before, after);
  if (apart <= 0 || !is_longer(apart, max_gap_s)) {
    return true;
  }
  reader.report({table::Severity::warning,
                 control.file,
                 0,
                 "time_s",
                 "no instant in common, " + seconds_text(apart) + " s apart",
                 "times that overlap those of the pose: another clock? The commands are not used",
                 1});
  return false;
}

}  // namespace tcert
