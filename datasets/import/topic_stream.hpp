#pragma once
/// \file
/// One stream of the map and the messages of the topic that it is read from.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/decoder.hpp"
#include "datasets/import/log_map.hpp"
#include "datasets/import/message_role.hpp"
#include "datasets/import/ray_layout.hpp"

namespace tcert::recording {

/// Stamp of a message with a header, or of what lies at `prefix` in it ("transforms[2]."), in
/// nanoseconds; empty if it has none.
[[nodiscard]] std::optional<std::int64_t> header_time(const Value& message,
                                                      const std::string& prefix);

class TopicStream {
 public:
  /// `key` is that of the map, for what is said. \returns nothing, with an error in `problems`, if
  /// the bag has no such messages or they do not say what they are to the stream.
  [[nodiscard]] static std::unique_ptr<TopicStream> of(const Bag& bag,
                                                       const std::string& file,
                                                       const StreamSource& source,
                                                       const std::string& key,
                                                       table::DiagnosticGroups& problems);

  [[nodiscard]] std::size_t topic() const noexcept { return topic_; }
  [[nodiscard]] const StreamSource& source() const noexcept { return *source_; }

  /// The message, valid until the next one; nullptr, with the reason in `problem`, if it cannot be
  /// decoded.
  [[nodiscard]] const Value* decode(const RawMessage& raw, std::string& problem);

  /// The values that StreamSet::take() wants; none of a scan with other beams than `layout`. False
  /// if this message is of something else. `prefix` is where its header lies.
  [[nodiscard]] bool values(const Value& message,
                            const RayLayout* layout,
                            std::vector<double>& out,
                            std::string& prefix);

  /// Of a scan; empty if the message is none. \pre the stream is of a scan.
  [[nodiscard]] std::optional<ScanGeometry> geometry(const Value& message) const;

 private:
  [[nodiscard]] bool find_fields(const Topic& topic, bool is_pose);
  [[nodiscard]] std::string ranges_field() const;
  [[nodiscard]] double value_at(const Value& message, const std::string& prefix, std::size_t i);
  void scan_values(const Value& message, const RayLayout& layout, std::vector<double>& out);

  const StreamSource* source_ = nullptr;
  std::size_t topic_ = 0;
  StreamRole role_ = StreamRole::none;
  bool is_frame_ = false;  // one transform of many is the pose
  std::optional<Decoder> decoder_;
  std::vector<ValueSource> sources_;
  std::vector<std::vector<FieldPath>> paths_;  // of the columns of each source
  Value message_;
  std::vector<double> cells_;
  std::vector<double> beams_;
};

}  // namespace tcert::recording
