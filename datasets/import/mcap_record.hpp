#pragma once
/// \file
/// Records of an MCAP file (mcap.dev/spec): an opcode, a length, fields in little endian.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tcert::recording {

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  statistics = 0x0B,
  data_end = 0x0F,
};

inline constexpr std::size_t kRecordHeadBytes = 9;
inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

/// Takes fields off the front of a record; after one that does not fit every take is false.
class RecordFields {
 public:
  explicit RecordFields(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  /// An unsigned integer.
  template <class T>
  [[nodiscard]] bool take(T& value) noexcept {
    if (bytes_.size() < sizeof(T)) {
      return fail();
    }
    value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      value = static_cast<T>(value | static_cast<T>(std::to_integer<T>(bytes_[i]) << (8U * i)));
    }
    bytes_ = bytes_.subspan(sizeof(T));
    return true;
  }

  [[nodiscard]] bool take_bytes(std::uint64_t length, std::span<const std::byte>& out) noexcept;

  /// Text (or a map, or bytes) behind its length in four bytes.
  [[nodiscard]] bool take_text(std::string_view& out) noexcept;

  [[nodiscard]] std::span<const std::byte> rest() const noexcept { return bytes_; }

 private:
  bool fail() noexcept {
    bytes_ = {};
    return false;
  }
  std::span<const std::byte> bytes_;
};

struct RecordHead {
  Opcode opcode{};
  std::uint64_t length = 0;  ///< Of the content behind the head.
};

struct SchemaRecord {
  std::uint16_t id = 0;
  std::string_view name;
  std::string_view encoding;
  std::string_view data;
};

struct ChannelRecord {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string_view topic;
  std::string_view message_encoding;
};

struct MessageRecord {
  std::uint16_t channel_id = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::span<const std::byte> data;
};

struct ChunkRecord {
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: none.
  std::string_view compression;
  std::span<const std::byte> records;
};

struct FooterRecord {
  std::uint64_t summary_start = 0;
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};

/// Each is nothing if `bytes` are too few.
[[nodiscard]] std::optional<RecordHead> record_head(std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<SchemaRecord> schema_record(std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<ChannelRecord> channel_record(
    std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<MessageRecord> message_record(
    std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<ChunkRecord> chunk_record(std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<FooterRecord> footer_record(std::span<const std::byte> bytes) noexcept;

}  // namespace tcert::recording
