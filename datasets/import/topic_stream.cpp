#include "datasets/import/topic_stream.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <table/nearest_name.hpp>
#include <tcert/tick.hpp>
#include <utility>

#include "datasets/import/stream_values.hpp"
#include "datasets/import/transforms.hpp"
#include "datasets/range_rule.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

// Counted with the readings that are no range, and none that a map can list.
constexpr double kNoRange = -std::numeric_limits<double>::denorm_min();

std::optional<double> positive_at(const Value& message, const char* path) {
  const auto value = number_at(message, path);
  return value && std::isfinite(*value) && *value > 0.0 ? value : std::nullopt;
}

/// A sensor_msgs/Range says itself what it can measure.
bool is_beyond_limits(const Value& message, double range_m) {
  const auto min_m = positive_at(message, "min_range");
  const auto max_m = positive_at(message, "max_range");
  return std::isfinite(range_m) &&
         (range_m < min_m.value_or(range_m) || range_m > max_m.value_or(range_m));
}

}  // namespace

std::optional<std::int64_t> header_time(const Value& message, const std::string& prefix) {
  const Value* const stamp = find(message, prefix + "header.stamp");
  if (stamp == nullptr) {
    return std::nullopt;
  }
  for (const auto& [seconds, rest] :
       {std::pair("sec", "nanosec"), std::pair("secs", "nsecs"), std::pair("sec", "nsec")}) {
    const Value* const whole = find(*stamp, seconds);
    const Value* const part = find(*stamp, rest);
    const auto whole_s = whole == nullptr ? std::nullopt : integer(*whole);
    const auto part_ns = part == nullptr ? std::nullopt : integer(*part);
    if (whole_s && part_ns && std::abs(*whole_s) < 4'000'000'000 && *part_ns >= 0 &&
        *part_ns < 1'000'000'000) {
      return *whole_s * 1'000'000'000 + *part_ns;
    }
  }
  return std::nullopt;
}

std::unique_ptr<TopicStream> TopicStream::of(const Bag& bag,
                                             const std::string& file,
                                             const StreamSource& source,
                                             const std::string& key,
                                             table::DiagnosticGroups& problems) {
  std::vector<std::string> names;
  for (const Topic& topic : bag.topics()) {
    names.push_back(topic.name);
  }
  const auto found = std::ranges::find(names, source.topic);
  const auto fail = [&](std::string value, std::string expectation) {
    problems.add({Severity::error, file, 0, key, std::move(value), std::move(expectation), 1});
    return nullptr;
  };
  if (found == names.end()) {
    const auto nearest = table::nearest_name(source.topic, names);
    return fail(source.topic,
                nearest ? "a topic of the bag; did you mean '" + *nearest + "'?"
                        : "a topic of the bag; 'tcert check " + file + "' lists them");
  }
  auto stream = std::make_unique<TopicStream>();
  stream->source_ = &source;
  stream->topic_ = static_cast<std::size_t>(found - names.begin());
  const Topic& topic = bag.topics()[stream->topic_];
  std::string problem;
  stream->decoder_ = Decoder::of(topic, problem);
  if (!stream->decoder_) {
    return fail(source.topic + " of type " + topic.type, problem);
  }
  stream->role_ = role_of(topic.type);
  if (!stream->find_fields(topic, key == "pose")) {
    return fail(source.topic + " of type " + topic.type,
                "a type that says what it is, or columns in the map: fields such as "
                "pose.position.x ('tcert check' lists them)");
  }
  if (stream->is_frame_ && source.child_frame.empty()) {
    return fail(source.topic + " of type " + topic.type,
                "'frame' and 'parent' in the map: which of the transforms is the robot's");
  }
  return stream;
}

const Value* TopicStream::decode(const RawMessage& raw, std::string& problem) {
  return (*decoder_)(raw.data, message_, problem) ? &message_ : nullptr;
}

bool TopicStream::values(const Value& message,
                         const RayLayout* layout,
                         std::vector<double>& out,
                         std::string& prefix) {
  out.clear();
  prefix = role_ == StreamRole::transforms ? "transforms[0]." : "";
  if (is_frame_) {
    const auto index = index_of_transform(message, source_->parent_frame, source_->child_frame);
    if (!index) {
      return false;
    }
    prefix = "transforms[" + std::to_string(*index) + "].";
  }
  if (layout != nullptr && layout->geometry) {
    scan_values(message, *layout, out);
    return true;
  }
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    out.push_back(value_at(message, is_frame_ ? prefix : std::string(), i));
  }
  if (role_ == StreamRole::range && layout != nullptr) {
    for (std::size_t ray = 0; ray < source_->rays.size(); ++ray) {
      double& range_m = out[2 * ray];
      if (!source_->rays[ray].value.is_given() && is_beyond_limits(message, range_m) &&
          !is_no_return(layout->columns[ray].no_return.values, range_m)) {
        range_m = kNoRange;
      }
    }
  }
  return true;
}

std::optional<ScanGeometry> TopicStream::geometry(const Value& message) const {
  const auto angle_min = number_at(message, "angle_min");
  const auto increment = number_at(message, "angle_increment");
  const Value* const ranges = find(message, ranges_field());
  ScanGeometry scan;
  scan.beams = ranges == nullptr ? 0 : size(*ranges);
  const auto& asked = *source_->scan;
  if (scan.beams == 0 || (!angle_min && !asked.angle_min_rad) ||
      (!increment && !asked.angle_increment_rad)) {
    return std::nullopt;
  }
  scan.angle_min_rad = asked.angle_min_rad.value_or(angle_min.value_or(0.0));
  scan.angle_increment_rad = asked.angle_increment_rad.value_or(increment.value_or(0.0));
  scan.range_min_m = positive_at(message, "range_min");
  scan.range_max_m = positive_at(message, "range_max");
  scan.offset = asked.offset;
  return scan;
}

bool TopicStream::find_fields(const Topic& topic, bool is_pose) {
  if (source_->scan) {
    return role_ == StreamRole::scan || !source_->scan->ranges.empty();
  }
  sources_ = source_->values;
  // A pose that is the place of a frame, wherever in a message it stands.
  is_frame_ = is_pose && role_ == StreamRole::transforms &&
              std::ranges::none_of(sources_, &ValueSource::is_given);
  if (is_frame_) {
    sources_ = fields_of("geometry_msgs/msg/TransformStamped");
    return true;
  }
  // An Odometry is no command, a Twist no pose.
  const bool fits = role_ == (is_pose ? StreamRole::pose : StreamRole::control);
  const std::vector<ValueSource> plain = fits ? fields_of(topic.type) : std::vector<ValueSource>{};
  bool any = false;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (!sources_[i].is_given() && i < plain.size()) {
      sources_[i] = plain[i];
    }
    any = any || sources_[i].is_given();
  }
  bool all_rays = true;
  for (const MappedRay& ray : source_->rays) {
    sources_.push_back(ray.value);
    if (role_ == StreamRole::range && !ray.value.is_given()) {
      sources_.back() = {{"range"}, 1.0, 0.0};
    }
    sources_.push_back(ray.force);
    all_rays = all_rays && sources_[sources_.size() - 2].is_given();
  }
  any = all_rays && (any || !source_->rays.empty());
  for (const ValueSource& source : sources_) {
    paths_.emplace_back();
    for (const std::string& column : source.columns) {
      const auto path = field_path(column);
      if (!path) {
        return false;
      }
      paths_.back().push_back(*path);
    }
  }
  return any;
}

std::string TopicStream::ranges_field() const {
  return source_->scan->ranges.empty() ? "ranges" : source_->scan->ranges;
}

double TopicStream::value_at(const Value& message, const std::string& prefix, std::size_t i) {
  cells_.clear();
  for (std::size_t k = 0; k < sources_[i].columns.size(); ++k) {
    const auto cell = prefix.empty() ? number_at(message, paths_[i][k])
                                     : number_at(message, prefix + sources_[i].columns[k]);
    cells_.push_back(cell.value_or(kMissing));
  }
  return cells_.empty() ? kMissing : value_of(sources_[i], cells_);
}

void TopicStream::scan_values(const Value& message,
                              const RayLayout& layout,
                              std::vector<double>& out) {
  const auto found = geometry(message);
  if (!found || !found->has_beams_of(*layout.geometry)) {
    return;
  }
  beams_.clear();
  const Value* const ranges = find(message, ranges_field());
  if (!append_numbers(*ranges, beams_)) {
    return;
  }
  for (std::size_t i = 0; i < beams_.size(); i += source_->scan->every) {
    out.push_back(beams_[i]);
    out.push_back(kMissing);
  }
}

}  // namespace tcert::recording
