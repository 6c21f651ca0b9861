#include "datasets/import/mcap_topics.hpp"

#include <algorithm>

#include "datasets/import/definition_text.hpp"
#include "datasets/import/message_type.hpp"

namespace tcert::recording {

bool McapTopics::has_room_for(std::size_t bytes) noexcept {
  bytes_ += std::min(bytes, kMostTopicBytes);
  return bytes_ <= kMostTopicBytes;
}

void McapTopics::add(const SchemaRecord& schema) {
  // One byte more than a definition may have, so that its reader says why it is refused.
  const std::string_view data = schema.data.substr(0, kLongestDefinition + 1);
  if (schema.id == 0 || schemas_.contains(schema.id) ||
      !has_room_for(schema.name.size() + schema.encoding.size() + data.size())) {
    return;
  }
  schemas_[schema.id] = {std::string(schema.name), std::string(schema.encoding), std::string(data)};
}

void McapTopics::add(const ChannelRecord& channel) {
  if (topic_of(channel.id)) {
    return;
  }
  const auto found = schemas_.find(channel.schema_id);
  const Schema schema = found == schemas_.end() ? Schema{} : found->second;
  Topic topic;
  topic.name = channel.topic.substr(0, kMostTopicBytes);
  topic.type = canonical_type(schema.name);
  topic.encoding = channel.message_encoding.substr(0, kMostTopicBytes);
  topic.definition = schema.data;
  topic.definition_encoding = schema.encoding;
  const auto [place, is_new] =
      index_.try_emplace({topic.name, topic.type, topic.encoding}, topics_.size());
  if (is_new) {
    if (!has_room_for(2 * (topic.name.size() + topic.type.size() + topic.encoding.size()) +
                      topic.definition.size())) {
      index_.erase(place);
      return;
    }
    topics_.push_back(std::move(topic));
  }
  if (channel.id >= topic_of_channel_.size()) {
    topic_of_channel_.resize(std::size_t{channel.id} + 1);
  }
  topic_of_channel_[channel.id] = place->second;
}

void McapTopics::set_counts(const std::vector<std::size_t>& messages) {
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    topics_[i].messages = i < messages.size() ? messages[i] : 0;
  }
}

}  // namespace tcert::recording
