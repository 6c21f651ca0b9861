#include "datasets/import/mcap_record.hpp"

namespace tcert::recording {

bool RecordFields::take_bytes(std::uint64_t length, std::span<const std::byte>& out) noexcept {
  if (length > bytes_.size()) {
    return fail();
  }
  out = bytes_.first(static_cast<std::size_t>(length));
  bytes_ = bytes_.subspan(out.size());
  return true;
}

bool RecordFields::take_text(std::string_view& out) noexcept {
  std::uint32_t length = 0;
  std::span<const std::byte> bytes;
  if (!take(length) || !take_bytes(length, bytes)) {
    return false;
  }
  out = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  return true;
}

std::optional<RecordHead> record_head(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  std::uint8_t opcode = 0;
  RecordHead head;
  if (!fields.take(opcode) || !fields.take(head.length)) {
    return std::nullopt;
  }
  head.opcode = static_cast<Opcode>(opcode);
  return head;
}

std::optional<SchemaRecord> schema_record(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  SchemaRecord record;
  const bool whole = fields.take(record.id) && fields.take_text(record.name) &&
                     fields.take_text(record.encoding) && fields.take_text(record.data);
  return whole ? std::optional(record) : std::nullopt;
}

std::optional<ChannelRecord> channel_record(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  ChannelRecord record;
  const bool whole = fields.take(record.id) && fields.take(record.schema_id) &&
                     fields.take_text(record.topic) && fields.take_text(record.message_encoding);
  return whole ? std::optional(record) : std::nullopt;
}

std::optional<MessageRecord> message_record(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  MessageRecord record;
  std::uint32_t sequence = 0;
  if (!fields.take(record.channel_id) || !fields.take(sequence) || !fields.take(record.log_time) ||
      !fields.take(record.publish_time)) {
    return std::nullopt;
  }
  record.data = fields.rest();
  return record;
}

std::optional<ChunkRecord> chunk_record(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  ChunkRecord record;
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  std::uint64_t length = 0;
  const bool whole = fields.take(start) && fields.take(end) &&
                     fields.take(record.uncompressed_size) &&
                     fields.take(record.uncompressed_crc) && fields.take_text(record.compression) &&
                     fields.take(length) && fields.take_bytes(length, record.records);
  return whole ? std::optional(record) : std::nullopt;
}

std::optional<FooterRecord> footer_record(std::span<const std::byte> bytes) noexcept {
  RecordFields fields(bytes);
  FooterRecord record;
  const bool whole = fields.take(record.summary_start) &&
                     fields.take(record.summary_offset_start) && fields.take(record.summary_crc);
  return whole ? std::optional(record) : std::nullopt;
}

}  // namespace tcert::recording
