#include <algorithm>
#include <span>
#include <utility>

#include "datasets/import/draft_parts.hpp"

namespace tcert::recording {
namespace {

const TopicSurvey* first_topic(std::span<const TopicSurvey> topics,
                               StreamRole role,
                               std::string_view part) {
  const auto found = std::ranges::find_if(topics, [&](const TopicSurvey& topic) {
    return topic.role == role && topic.messages > 0 && topic.problem.empty() &&
           is_called(topic.name + ' ' + topic.type, part);
  });
  return found == topics.end() ? nullptr : &*found;
}

}  // namespace

DraftedMap draft_map(std::span<const TopicSurvey> topics) {
  OrderedJson map = frame_of_map();
  std::vector<std::string> remarks;
  map["clock"] = "log";
  const TopicSurvey* pose = first_topic(topics, StreamRole::pose, "odometry");
  pose = pose != nullptr ? pose : first_topic(topics, StreamRole::pose, "");
  map["pose"] = {{"from", pose == nullptr ? OrderedJson(nullptr) : OrderedJson(pose->name)}};
  if (pose == nullptr) {
    const TopicSurvey* const frames = first_topic(topics, StreamRole::transforms, "/tf ");
    if (frames != nullptr) {
      map["pose"] = {{"from", frames->name}, {"parent", "odom"}, {"frame", "base_link"}};
      remarks.emplace_back("no topic is a pose, so it is taken from transforms: check the frames");
    } else {
      remarks.emplace_back("no topic is a pose: name one under 'pose', with x_m, y_m and yaw_rad");
    }
  }
  OrderedJson scans = OrderedJson::array();
  for (const TopicSurvey& topic : topics) {
    if (topic.role == StreamRole::scan && topic.messages > 0) {
      scans.push_back(
          {{"from", topic.name}, {"every", 4}, {"no_return", {"inf"}}, {"offset", "tf_static"}});
    }
  }
  if (scans.empty()) {
    for (const TopicSurvey& topic : topics) {
      if (topic.role == StreamRole::range && topic.messages > 0) {
        scans.push_back(
            {{"from", topic.name},
             {"rays",
              OrderedJson::array({frame_of_ray(ray_name(topic.name, scans.size()), "range")})}});
      }
    }
  }
  map["rays"] = scans.size() == 1 ? scans.front() : scans;
  if (scans.empty()) {
    remarks.emplace_back(
        "no topic is a scan or a range: list rays under 'rays', each with the field of a message "
        "('tcert help map')");
  }
  const TopicSurvey* control = first_topic(topics, StreamRole::control, "cmd");
  if (control != nullptr) {
    map["control"] = {{"from", control->name}};
  }
  return finished(map, std::move(remarks));
}

}  // namespace tcert::recording
