#pragma once
/// \file
/// Bytes of a message to the value that they say.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "datasets/import/bag.hpp"
#include "datasets/import/message_type.hpp"
#include "datasets/import/value.hpp"

namespace tcert::recording {

/// CDR with its 4 header bytes: plain CDR of XCDR1 (alignment to at most 8 bytes) and of XCDR2 (to
/// at most 4), in either byte order. A sequence is checked against the bytes that are left before
/// it takes memory. What `out` held is used again, so that a topic's messages hardly allocate.
/// \returns false, with the reason in `problem` and `out` unspecified, if the bytes do not fit.
[[nodiscard]] bool decode(const MessageType& type,
                          std::span<const std::byte> cdr,
                          Value& out,
                          std::string& problem);

/// ROS 1: little endian, nothing aligned, no header.
[[nodiscard]] bool decode_ros1(const MessageType& type,
                               std::span<const std::byte> bytes,
                               Value& out,
                               std::string& problem);

/// A JSON document of any shape within table::json_shape_problem(). An array of numbers alone is
/// packed: Signed if all are integers within int64, else Doubles, with NaN for null.
[[nodiscard]] bool decode_json(std::span<const std::byte> text, Value& out, std::string& problem);

/// Decodes the messages of one topic, whatever their encoding.
class Decoder {
 public:
  /// For "cdr", "ros1" and "json". Nothing, with the reason and the way out in `problem`, for other
  /// encodings and for types that are not known.
  [[nodiscard]] static std::optional<Decoder> of(const Topic& topic, std::string& problem);

  /// As decode().
  [[nodiscard]] bool operator()(std::span<const std::byte> data,
                                Value& out,
                                std::string& problem) const;

  /// The type; nullptr for JSON, whose messages tell what they hold.
  [[nodiscard]] const MessageType* type() const noexcept;

 private:
  enum class Encoding { cdr, ros1, json };
  Decoder(Encoding encoding, MessageType type);

  Encoding encoding_;
  MessageType type_;
};

}  // namespace tcert::recording
