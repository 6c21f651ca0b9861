#include "datasets/import/transforms.hpp"

#include <cmath>
#include <tcert/geometry.hpp>

#include "datasets/import/message_role.hpp"
#include "datasets/import/stream_values.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kMostJoints = 64;
constexpr double kTiltTolerance = 0.02;  // of x and y of a quaternion: about 2 degrees

std::string frame_at(const Value& message, const std::string& path) {
  const Value* const found = find(message, path);
  const std::string* const name = found == nullptr ? nullptr : text(*found);
  if (name == nullptr) {
    return "";
  }
  return name->starts_with('/') ? name->substr(1) : *name;
}

std::string without_slash(const std::string& frame) {
  return frame.starts_with('/') ? frame.substr(1) : frame;
}

}  // namespace

std::optional<std::size_t> index_of_transform(const Value& message,
                                              const std::string& parent,
                                              const std::string& child) {
  const Value* const list = find(message, "transforms");
  const std::size_t count = list == nullptr ? 0 : size(*list);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string at = "transforms[" + std::to_string(i) + "].";
    const bool is_child =
        child.empty() || frame_at(message, at + "child_frame_id") == without_slash(child);
    const bool is_parent =
        parent.empty() || frame_at(message, at + "header.frame_id") == without_slash(parent);
    if (is_child && is_parent) {
      return i;
    }
  }
  return std::nullopt;
}

StaticTransforms::StaticTransforms(const Bag& bag) {
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const Topic& topic = bag.topics()[i];
    std::string problem;
    if (topic.name == "/tf_static" || topic.name == "tf_static") {
      decoder_ = Decoder::of(topic, problem);
      topic_ = decoder_ ? std::optional(i) : std::nullopt;
    }
  }
}

void StaticTransforms::take(const RawMessage& raw) {
  Value message;
  std::string problem;
  if (!decoder_ || !(*decoder_)(raw.data, message, problem)) {
    return;
  }
  const Value* const list = recording::find(message, "transforms");
  const std::size_t count = list == nullptr ? 0 : size(*list);
  for (std::size_t i = 0; i < count && joints_.size() < 4096; ++i) {
    const std::string at = "transforms[" + std::to_string(i) + "].";
    const auto number = [&](const char* field) {
      return number_at(message, at + "transform." + field).value_or(std::nan(""));
    };
    Joint joint;
    joint.parent = frame_at(message, at + "header.frame_id");
    joint.place.x_m = number("translation.x");
    joint.place.y_m = number("translation.y");
    const double qx = number("rotation.x");
    const double qy = number("rotation.y");
    joint.place.yaw_rad = yaw_of(qx, qy, number("rotation.z"), number("rotation.w"));
    joint.is_flat = std::abs(qx) < kTiltTolerance && std::abs(qy) < kTiltTolerance &&
                    std::isfinite(joint.place.x_m) && std::isfinite(joint.place.y_m) &&
                    std::isfinite(joint.place.yaw_rad);
    joints_[frame_at(message, at + "child_frame_id")] = joint;
  }
}

std::optional<ScanOffset> StaticTransforms::find(const std::string& base,
                                                 const std::string& frame) const {
  ScanOffset place;
  std::string at = without_slash(frame);
  for (std::size_t steps = 0; at != without_slash(base); ++steps) {
    const auto joint = joints_.find(at);
    if (joint == joints_.end() || !joint->second.is_flat || steps > kMostJoints) {
      return std::nullopt;
    }
    const ScanOffset& step = joint->second.place;
    const double c = std::cos(step.yaw_rad);
    const double s = std::sin(step.yaw_rad);
    place = {false,
             step.x_m + c * place.x_m - s * place.y_m,
             step.y_m + s * place.x_m + c * place.y_m,
             wrapped_angle(place.yaw_rad + step.yaw_rad)};
    at = joint->second.parent;
  }
  return place;
}

}  // namespace tcert::recording
