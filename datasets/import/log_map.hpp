#pragma once
/// \file
/// The map: which topics or columns of a foreign log are the streams of a bundle. 'tcert help map'
/// lists its keys; map_fields.hpp declares them.

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <table/time_unit.hpp>
#include <vector>

namespace tcert::recording {

/// Where a value comes from: a column by name or position ("#3"), or a field of a message.
struct ValueSource {
  std::vector<std::string> columns;  ///< One; of a quaternion x, y, z and w; none: not given.
  double scale = 1.0;
  double add = 0.0;

  [[nodiscard]] bool is_given() const noexcept { return !columns.empty(); }
  [[nodiscard]] bool is_quaternion() const noexcept { return columns.size() == 4; }
};

struct TimeSource {
  std::vector<std::string> columns;     ///< One; seconds and nanoseconds; none: it is found out.
  std::optional<table::TimeUnit> unit;  ///< Empty: by its name and its values.
  bool dates = false;                   ///< Texts such as 2021-01-20T10:11:32.3Z.
  bool from_first = false;              ///< The first time of the stream becomes 0.
};

/// Where a scanner sits on the body.
struct ScanOffset {
  bool by_transforms = false;  ///< From /tf_static, from `base` to the scan's frame.
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// A scan: an array of ranges, every `every`-th of which becomes a ray.
struct ScanSource {
  std::string ranges;  ///< A field, or columns such as "field.ranges{i}" with i from 0.
  std::size_t every = 1;
  std::optional<double> angle_min_rad;  ///< Empty: of the message.
  std::optional<double> angle_increment_rad;
  std::optional<double> reach_m;
  ScanOffset offset;
};

/// Which readings of a range say that nothing was in reach. All other readings that are no range
/// (not finite, below range_min_m or at most 0, above range_max_m) are missing.
struct NoReturn {
  std::vector<double> values;  ///< As the file has them, beside inf, which always is one.
  std::optional<double> range_min_m;
  std::optional<double> range_max_m;
};

// NOLINTNEXTLINE(bugprone-exception-escape): json moves without a throw.
struct MappedRay {
  nlohmann::json ray;  ///< As bundle.json has it.
  ValueSource value;   ///< Its bend or its range.
  ValueSource force;
  NoReturn no_return;  ///< Of the ray, beside those of its stream.
};

/// A topic, or a file of columns.
struct StreamSource {
  std::string topic;  ///< Either this,
  std::string file;   ///< or this, which may hold {trial}; both empty: the source is the file.
  TimeSource time;
  std::vector<ValueSource> values;  ///< Of pose and control, in the order of their columns.
  std::string child_frame;          ///< Of a topic of transforms: the robot's frame,
  std::string parent_frame;         ///< and the frame in which it is tracked.
  std::vector<MappedRay> rays;      ///< Of a stream of rays: these,
  std::optional<ScanSource> scan;   ///< or a scan.
  NoReturn no_return;
};

/// One cell of trials.csv.
struct OutcomeSource {
  std::string name;    ///< Ours: "success"
  std::string column;  ///< Theirs.
  double scale = 1.0;
  std::vector<std::string> success_words;  ///< Of success alone; empty: the usual words.
  std::vector<std::string> failure_words;
};

struct TrialsSource {
  std::string table;   ///< A file; empty: none, and outcomes are not known.
  std::string id;      ///< Its column of trials.
  std::string column;  ///< Of the streams' file: the trial that a row belongs to.
  std::vector<OutcomeSource> outcomes;
};

struct LogMap {
  bool header_clock = false;  ///< Stamps of the messages, not when they were recorded.
  StreamSource pose;
  std::vector<StreamSource> rays;
  std::optional<StreamSource> control;
  TrialsSource trials;
  std::string base_frame = "base_link";
  nlohmann::json bundle = nlohmann::json::object();  ///< Keys of bundle.json, as they stand.
  nlohmann::json document;                           ///< The whole map.
};

/// Columns of the bundle's streams, in the order of StreamSource::values.
[[nodiscard]] const std::vector<std::string>& pose_columns();
[[nodiscard]] const std::vector<std::string>& control_columns();

/// Reads a map. All problems at once, with the path of their key; unknown keys with the nearest
/// known one. Empty iff there is an error. Keys of bundle.json (robot, course, ...) are not looked
/// into: they are when the bundle is made.
[[nodiscard]] std::optional<LogMap> parse_log_map(std::string_view text,
                                                  const std::string& file,
                                                  table::DiagnosticGroups& problems);

}  // namespace tcert::recording
