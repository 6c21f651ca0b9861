#pragma once
/// \file
/// The topics of an MCAP file, put together from its schemas and channels.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/mcap_record.hpp"

namespace tcert::recording {

/// Channels of the same name, type and encoding are one topic. Of two records with the same id the
/// first holds. Names and definitions beyond kMostTopicBytes in all are left out.
class McapTopics {
 public:
  static constexpr std::size_t kMostTopicBytes = std::size_t{64} << 20U;

  void add(const SchemaRecord& schema);
  void add(const ChannelRecord& channel);

  /// Index of the topic of a channel; nothing for a channel without a record.
  [[nodiscard]] std::optional<std::size_t> topic_of(std::uint16_t channel) const noexcept {
    return channel < topic_of_channel_.size() ? topic_of_channel_[channel] : std::nullopt;
  }

  [[nodiscard]] bool has_schema(std::uint16_t id) const { return schemas_.contains(id); }

  [[nodiscard]] const std::vector<Topic>& topics() const noexcept { return topics_; }

  /// Sets Topic::messages.
  void set_counts(const std::vector<std::size_t>& messages);

 private:
  struct Schema {
    std::string name;
    std::string encoding;
    std::string data;
  };
  bool has_room_for(std::size_t bytes) noexcept;

  std::vector<std::optional<std::size_t>> topic_of_channel_;  // by channel id
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::array<std::string, 3>, std::size_t> index_;  // by name, type, encoding
  std::vector<Topic> topics_;
  std::size_t bytes_ = 0;
};

}  // namespace tcert::recording
