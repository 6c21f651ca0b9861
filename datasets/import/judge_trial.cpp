#include "datasets/import/judge_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;
using table::Severity;

constexpr double kLeastUsed = 0.9;
constexpr double kMostNoRanges = 0.05;
constexpr std::int64_t kTickNs = 100'000'000;
constexpr std::int64_t kLeastTicks = 10;

std::string seconds_in_words(std::int64_t time_ns) {
  std::string text;
  table::append_seconds(text, time_ns);
  return text;
}

/// Why a trial cannot be used; empty if it can.
std::string reason_against(const StreamResult& stream, const std::string& key) {
  const StreamUse& use = stream.use;
  if (use.used == 0) {
    return fmt::format(
        "no sample of {}: {} rows, {} of them empty, {} without a time or a whole "
        "pose (a quaternion has the length 1)",
        key,
        use.rows + use.empty,
        use.empty,
        use.unreadable);
  }
  if (static_cast<double>(use.used) >= kLeastUsed * static_cast<double>(use.rows)) {
    return "";
  }
  std::string why = fmt::format("{} of {} rows of {} are of use", use.used, use.rows, key);
  if (use.set_back > 0) {
    why += fmt::format("; the clock is set back by {} s at row {}, after which {} are not used",
                       seconds_in_words(use.set_back_by_ns),
                       use.first_set_back,
                       use.set_back);
  }
  if (use.same_time > 0) {
    why += fmt::format(
        "; {} share the time of another: whole seconds? is there a column of nanoseconds?",
        use.same_time);
  }
  if (use.unreadable > 0) {
    why += fmt::format("; {} have no time or no whole pose (a quaternion has the length 1)",
                       use.unreadable);
  }
  return why;
}

}  // namespace

StreamUse use_of_rays(const LogMap& map, const ImportedTrial& trial) {
  StreamUse all;
  for (std::size_t k = 1; k <= map.rays.size(); ++k) {
    all.first_ns = std::min(all.first_ns, trial.streams[k].use.first_ns);
    all.last_ns = std::max(all.last_ns, trial.streams[k].use.last_ns);
  }
  return all;
}

void judge_trial(const LogMap& map,
                 ImportedTrial& trial,
                 const fs::path& folder,
                 const std::vector<fs::path>& files,
                 table::DiagnosticGroups& problems) {
  const auto add_of =
      [&](std::size_t stream, Severity severity, std::string found, std::string expectation) {
        const std::string file = files[std::min(stream, files.size() - 1)].string();
        const std::string place =
            map.trials.column.empty() ? file : file + " (" + trial.trial_id + ")";
        problems.add({severity, place, 0, "", std::move(found), std::move(expectation), 1});
      };
  const auto add = [&](Severity severity, std::string found, std::string expectation) {
    add_of(0, severity, std::move(found), std::move(expectation));
  };
  for (std::size_t i = 0; i <= map.rays.size(); ++i) {
    const std::string reason = reason_against(trial.streams[i], key_of(map, i));
    if (!reason.empty()) {
      add_of(i, Severity::error, reason, "at least 90 % of its rows; the trial is rejected");
      trial.rejected = true;
    }
    const RangeUse& ranges = trial.streams[i].ranges;
    if (static_cast<double>(ranges.not_ranges) >
        kMostNoRanges * static_cast<double>(ranges.readings)) {
      add_of(i,
             Severity::warning,
             fmt::format("{:.0f} % of the readings of {} that are no range: 0, negative, or beyond "
                         "the limits",
                         100.0 * static_cast<double>(ranges.not_ranges) /
                             static_cast<double>(ranges.readings),
                         key_of(map, i)),
             "ranges; these are missing. If they mean that nothing was within reach, list them as "
             "'no_return' in the map, as the file has them");
    }
  }
  if (trial.rejected) {
    return;
  }
  const StreamUse& pose = trial.streams[0].use;
  const StreamUse rays = use_of_rays(map, trial);
  const std::int64_t begin_ns = std::max(pose.first_ns, rays.first_ns);
  const std::int64_t end_ns = std::min(pose.last_ns, rays.last_ns);
  // Each stream of rays has some time in common with the pose.
  const bool all_overlap = std::all_of(
      trial.streams.begin() + 1,
      trial.streams.begin() + 1 + static_cast<std::ptrdiff_t>(map.rays.size()),
      [&](const StreamResult& stream) {
        return stream.use.first_ns <= pose.last_ns && stream.use.last_ns >= pose.first_ns;
      });
  if (begin_ns > end_ns || !all_overlap) {
    add(Severity::error,
        fmt::format("pose from {} to {} s, rays from {} to {} s",
                    seconds_in_words(pose.first_ns),
                    seconds_in_words(pose.last_ns),
                    seconds_in_words(rays.first_ns),
                    seconds_in_words(rays.last_ns)),
        "streams of one clock, which overlap; the trial is rejected ('clock' and 'origin' in the "
        "map)");
    trial.rejected = true;
  } else if ((end_ns - begin_ns) / kTickNs + 1 < kLeastTicks) {
    add(Severity::error,
        fmt::format("{} s with both pose and rays", seconds_in_words(end_ns - begin_ns)),
        "at least 10 ticks, 0.9 s; the trial is rejected");
    trial.rejected = true;
  }
  if (map.control && !trial.rejected) {
    const StreamUse& control = trial.streams.back().use;
    std::error_code ignored;
    const bool none = control.used == 0;
    if (none || control.first_ns > end_ns || control.last_ns < begin_ns) {
      fs::remove(folder / "control.csv", ignored);
      add(Severity::warning,
          none ? "no command"
               : "commands from " + seconds_in_words(control.first_ns) + " to " +
                     seconds_in_words(control.last_ns) + " s",
          "commands of the clock of the pose; there are none in this trial");
    }
  }
}

}  // namespace tcert::recording
