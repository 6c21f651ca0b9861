#include "datasets/bundle_fields.hpp"

#include <array>

namespace tcert {
namespace {

constexpr std::string_view kClock = "clock of the log, the same for all streams of a trial; rising";

/// Of each stream.
constexpr FileField arrival_of(std::string_view file) {
  return {file,
          kArrivalColumn,
          "s",
          FieldNeed::optional,
          "when the sample was there to be seen, on the clock of time_s; empty: at once",
          false,
          false,
          true};
}

constexpr auto declared_fields() {
  using enum FieldNeed;
  return std::to_array<FileField>({
      {"trials.csv", "trial_id", "", required, "name of the trial, and of its folder in logs/"},
      {"trials.csv", "success", "", may_be_empty, "1 or 0, or a word for it: yes, fail, ..."},
      {"trials.csv", "time_s", "s", may_be_empty, "how long it took; a failure is censored there"},
      {"trials.csv", "algorithm", "", optional, "what controlled the robot; strata of H1"},
      {"trials.csv", "lighting", "", optional, "one of bundle.json's tiers; groups of H2"},
      {"trials.csv", "day", "", optional, "cluster: trials of a day are not independent"},
      {"trials.csv", "batch", "", optional, "as it is"},
      {"trials.csv", "distance_m", "m", optional, "driven"},
      {"trials.csv", "end_reason", "", optional, "goal, collision, wedged, timeout or aborted"},

      {"pose.csv", "time_s", "s", required, kClock},
      {"pose.csv",
       "x_m",
       "m",
       required,
       "of the body's centre, in a frame that stays for the trial"},
      {"pose.csv", "y_m", "m", required, "the same"},
      {"pose.csv", "yaw_rad", "rad", required, "heading, anticlockwise from the x axis"},
      {"pose.csv",
       "pitch_rad",
       "rad",
       optional,
       "of the body, as the ground lies; bounds the margin"},
      {"pose.csv", "roll_rad", "rad", optional, "the same"},
      {"pose.csv", "step_m", "m", optional, "height of a step underfoot; the same"},
      {"pose.csv", "slip", "", optional, "share of the commanded way that was not moved; the same"},
      arrival_of("pose.csv"),

      {"tactile.csv", "time_s", "s", required, kClock},
      {"tactile.csv", kBendColumn, "rad", may_be_empty, "of each ray of kind bend: its bend"},
      {"tactile.csv",
       kRangeColumn,
       "m",
       may_be_empty,
       "of each ray of kind range: free way ahead; inf is none within reach",
       false,
       true},
      {"tactile.csv", kForceColumn, "N", optional, "force at the ray's tip"},
      {"tactile.csv",
       kBearingColumn,
       "rad",
       optional,
       "of a ray that a joint moves: where it pointed, anticlockwise from ahead"},
      arrival_of("tactile.csv"),

      {"control.csv", "time_s", "s", required, kClock},
      {"control.csv", "speed_cmd_mps", "m/s", may_be_empty, "commanded"},
      {"control.csv", "yaw_rate_cmd_rps", "rad/s", optional, "commanded, anticlockwise"},
      {"control.csv", "loop_latency_ms", "ms", optional, "of the control loop"},
      arrival_of("control.csv"),

      {"ticks.csv", "speed_cmd_mps", "m/s", optional, "commanded"},
      {"ticks.csv", "yaw_rate_cmd_rps", "rad/s", optional, "commanded, anticlockwise"},
      {"ticks.csv", "stale", "", optional, "1: no evidence at this tick; empty is 0", true},
      {"ticks.csv", "segment_start", "", optional, "1: the path is broken before it", true},

      {"bundle.json", "format", "", required, "\"tcert-bundle\""},
      {"bundle.json", "version", "", required, "1"},
      {"bundle.json", "synthetic", "", optional, "true of data made by a program"},
      {"bundle.json", "seed", "", optional, "of that program"},
      {"bundle.json", "provenance", "", optional, "where this comes from, in words"},
      {"bundle.json", "robot", "", required, "an object, below; {} is the defaults"},
      {"bundle.json", "rays", "", required, "a list of at least one ray, below"},
      {"bundle.json", "course", "", optional, "S and G, below"},
      {"bundle.json", "lighting", "", optional, "the tiers that trials.csv may name"},
      {"bundle.json", "trial_limit_s", "s", optional, "when trials are stopped"},
      {"bundle.json", "max_gap_s", "s", optional, "a longer step of a clock breaks the path; 1"},
      {"bundle.json",
       "start_at",
       "",
       optional,
       R"("both": first tick when both streams have)"
       R"( begun; or "pose")"},
      {"bundle.json", "columns", "", optional, "of a file, foreign names of columns and ours"},
      {"bundle.json", "parameters", "", optional, "by their keys; --config and flags go first"},

      {"robot", "body_width_m", "m", optional, "as the parameter, whose default holds"},
      {"robot", "min_turn_radius_m", "m", optional, "the same"},
      {"robot", "tracking_buffer_m", "m", optional, "the same"},
      {"robot", "curvature_buffer_per_m", "1/m", optional, "the same"},

      {"ray", "name", "", required, "letters, digits and _ . -; part of column names"},
      {"ray", "kind", "", required, R"("bend" or "range")"},
      {"ray", "mount_x_m", "m", optional, "in the frame of the body, ahead of its centre; 0"},
      {"ray", "mount_y_m", "m", optional, "in the frame of the body, to its left; 0"},
      {"ray", "bearing_rad", "rad", required, "anticlockwise from ahead; 1.5708 is left"},
      {"ray", "reach_m", "m", required, "longest clearance that it can state"},
      {"ray", "calibration", "", optional, "required of kind bend, none of kind range"},
      {"ray", "no_return", "", optional, "of kind range: values for nothing within reach; inf is"},
      {"ray", "range_min_m", "m", optional, "of kind range: readings below it are missing; 0"},
      {"ray", "range_max_m", "m", optional, "of kind range: readings above it are missing"},
      {"calibration", "bend_rad", "rad", required, "a rising list"},
      {"calibration", "clearance_m", "m", required, "a list as long, rising or falling"},

      {"course", "start", "", optional, "S, a region in the frame of the poses"},
      {"course", "goal", "", optional, "G, the same, apart from S; without it there is no T_t"},
      {"region", "disc", "", optional, "either this, an object,"},
      {"region", "polygon", "", optional, "or this, a list of three points [x, y] or more"},
      {"disc", "x_m", "m", required, "of its centre"},
      {"disc", "y_m", "m", required, "the same"},
      {"disc", "radius_m", "m", required, "above 0"},
  });
}

constexpr auto kBundleFields = declared_fields();

}  // namespace

std::span<const FileField> bundle_fields() noexcept { return kBundleFields; }

}  // namespace tcert
