#include "datasets/import/message_role.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace tcert::recording {
namespace {

struct KnownType {
  std::string_view name;
  StreamRole role;
  std::string_view path;  ///< To the pose or the twist within the message, with its dot.
};

constexpr std::array kKnownTypes{
    KnownType{"nav_msgs/msg/Odometry", StreamRole::pose, "pose.pose."},
    KnownType{"geometry_msgs/msg/Pose", StreamRole::pose, ""},
    KnownType{"geometry_msgs/msg/PoseStamped", StreamRole::pose, "pose."},
    KnownType{"geometry_msgs/msg/PoseWithCovariance", StreamRole::pose, "pose."},
    KnownType{"geometry_msgs/msg/PoseWithCovarianceStamped", StreamRole::pose, "pose.pose."},
    KnownType{"geometry_msgs/msg/TransformStamped", StreamRole::pose, "transform."},
    KnownType{"geometry_msgs/msg/Twist", StreamRole::control, ""},
    KnownType{"geometry_msgs/msg/TwistStamped", StreamRole::control, "twist."},
    KnownType{"sensor_msgs/msg/LaserScan", StreamRole::scan, ""},
    KnownType{"sensor_msgs/msg/Range", StreamRole::range, ""},
    KnownType{"tf2_msgs/msg/TFMessage", StreamRole::transforms, ""},
    KnownType{"tf/msg/tfMessage", StreamRole::transforms, ""}};

const KnownType* known(std::string_view type) noexcept {
  const auto* const found = std::ranges::find(kKnownTypes, type, &KnownType::name);
  return found == kKnownTypes.end() ? nullptr : found;
}

}  // namespace

StreamRole role_of(std::string_view type) noexcept {
  const KnownType* const found = known(type);
  return found == nullptr ? StreamRole::none : found->role;
}

std::vector<ValueSource> fields_of(std::string_view type) {
  const KnownType* const found = known(type);
  if (found == nullptr) {
    return {};
  }
  const auto at = [found](const char* field) { return std::string(found->path) + field; };
  if (found->role == StreamRole::control) {
    return {{{at("linear.x")}, 1.0, 0.0}, {{at("angular.z")}, 1.0, 0.0}, {}};
  }
  if (found->role != StreamRole::pose) {
    return {};
  }
  const bool is_transform = found->path == "transform.";
  const std::string position = is_transform ? "translation." : "position.";
  const std::string turn = is_transform ? "rotation." : "orientation.";
  ValueSource yaw;
  for (const char* const axis : {"x", "y", "z", "w"}) {
    yaw.columns.push_back(at((turn + axis).c_str()));
  }
  return {
      {{at((position + "x").c_str())}, 1.0, 0.0}, {{at((position + "y").c_str())}, 1.0, 0.0}, yaw};
}

}  // namespace tcert::recording
