#include "datasets/import/map_fields.hpp"

#include <array>

namespace tcert::recording {
namespace {

constexpr auto declared_fields() {
  using enum FieldNeed;
  return std::to_array<FileField>({
      {"map", "pose", "", required, "where the robot is: a stream"},
      {"map", "rays", "", required, "what it feels: a stream, or a list of streams"},
      {"map", "control", "", optional, "what it was told: a stream"},
      {"map", "clock", "", optional, R"("log", when messages were recorded, or "header"; log)"},
      {"map", "base_frame", "", optional, "the body's frame in /tf_static; base_link"},
      {"map", "trials", "", optional, "how trials are told apart, and their outcomes"},
      {"map", "format", "", optional, "\"tcert-map\""},
      {"map", "version", "", optional, "1"},

      {"stream", "from", "", optional, "a topic of a bag; either this,"},
      {"stream", "file", "", optional, "or this, a CSV file below the source, with {trial} in it"},
      {"stream", "time", "", optional, "its clock, if that is not plain; a column, or an object"},
      {"stream", "frame", "", optional, "of a topic of transforms: the child frame"},
      {"stream", "parent", "", optional, "of the same: the frame that it is in"},

      {"pose", "x_m", "m", optional, "a value; needed of CSV, plain of Odometry and the like"},
      {"pose", "y_m", "m", optional, "the same"},
      {"pose", "yaw_rad", "rad", optional, "the same, or a quaternion"},

      {"control", "speed_cmd_mps", "m/s", optional, "a value; plain of Twist"},
      {"control", "yaw_rate_cmd_rps", "rad/s", optional, "the same"},
      {"control", "loop_latency_ms", "ms", optional, "the same"},

      {"rays", "rays", "", optional, "a list of rays, each as in bundle.json and with its value"},
      {"rays", "ranges", "", optional, "of a scan: its field, or columns as field.ranges{i}"},
      {"rays", "every", "", optional, "of a scan: every so many beams one is a ray; 1"},
      {"rays", "angle_min_rad", "rad", optional, "of a scan in columns: bearing of beam 0"},
      {"rays", "angle_increment_rad", "rad", optional, "of the same: from beam to beam"},
      {"rays", "reach_m", "m", optional, "of a scan: longest clearance; else its range_max"},
      {"rays", "offset", "", optional, R"(of the scanner on the body: "tf_static", or an object)"},
      {"rays", "no_return", "", optional, R"(readings that mean nothing in reach; ["inf"])"},
      {"rays", "range_min_m", "m", optional, "shorter readings are missing"},
      {"rays", "range_max_m", "m", optional, "longer ones are missing"},

      {"mapped ray", "bend_rad", "rad", optional, "a value, of a ray of kind bend"},
      {"mapped ray", "range_m", "m", optional, "a value, of a ray of kind range"},
      {"mapped ray", "fsr_n", "N", optional, "a value: the force at its tip"},
      {"mapped ray", "bearing_deg", "deg", optional, "instead of bearing_rad"},

      {"offset", "x_m", "m", optional, "ahead of the body's centre; 0"},
      {"offset", "y_m", "m", optional, "to its left; 0"},
      {"offset", "yaw_rad", "rad", optional, "anticlockwise; 0"},

      {"value", "column", "", optional, R"(a column, "#3" for the third, or a field of a message)"},
      {"value", "quaternion", "", optional, "instead, of a yaw: the columns of x, y, z and w"},
      {"value", "unit", "", optional, "that the column has: cm, mm, deg, g, deg/s, ..."},
      {"value", "scale", "", optional, "instead of a unit: a factor"},
      {"value", "add", "", optional, "then added, in our unit"},

      {"time", "column", "", optional, "one column, or a list of seconds and nanoseconds"},
      {"time", "unit", "", optional, R"(s, ms, us, ns, or "iso" for dates)"},
      {"time", "origin", "", optional, R"("first": the stream's first time becomes 0)"},

      {"trials", "split", "", optional, R"("file", or an object with the column of the trial)"},
      {"trials", "table", "", optional, "a CSV file of outcomes, beside the map or the source"},
      {"trials", "id", "", optional, "its column of trials; trial_id"},
      {"trials", "success", "", optional, "a column, or an object with true and false: lists"},
      {"trials", "time_s", "s", optional, "a column, or an object with its unit"},
      {"trials", "distance_m", "m", optional, "the same"},
      {"trials", "algorithm", "", optional, "a column"},
      {"trials", "lighting", "", optional, "a column"},
      {"trials", "day", "", optional, "a column"},
      {"trials", "batch", "", optional, "a column"},
      {"trials", "end_reason", "", optional, "a column"},

      {"split", "column", "", required, "of the streams' file, the trial of each row"},
      {"success", "column", "", required, "of the table"},
      {"success", "true", "", optional, "a list of words; all others are failures without 'false'"},
      {"success", "false", "", optional, "a list of words"},
      {"outcome", "column", "", required, "of the table"},
      {"outcome", "unit", "", optional, "that the column has: ms, cm, ..."},
  });
}

constexpr auto kMapFields = declared_fields();

}  // namespace

std::span<const FileField> map_fields() noexcept { return kMapFields; }

}  // namespace tcert::recording
