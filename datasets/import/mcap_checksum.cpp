#include "datasets/import/mcap_checksum.hpp"

#include <algorithm>
#include <string_view>

#include "datasets/import/crc32.hpp"
#include "datasets/import/mcap_record.hpp"
#include "datasets/import/mcap_summary.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kPieceSummed = std::size_t{1} << 20U;

}  // namespace

void DataChecksum::add(std::span<const std::byte> bytes) noexcept {
  if (wanted_) {
    value_ = crc32(bytes, value_);
  }
}

void DataChecksum::add(std::span<const std::byte> record,
                       std::span<const std::byte> part,
                       std::uint32_t part_crc) noexcept {
  if (wanted_) {
    const auto before = static_cast<std::size_t>(part.data() - record.data());
    add(record.first(before));
    value_ = crc32_of_both(value_, part_crc, part.size());
    add(record.subspan(before + part.size()));
  }
}

void DataChecksum::add(FileWindow& window, std::uint64_t offset, std::uint64_t length) {
  while (wanted_ && length > 0) {
    const auto piece =
        window.at(offset, static_cast<std::size_t>(std::min<std::uint64_t>(kPieceSummed, length)));
    if (piece.empty()) {
      return;
    }
    add(piece);
    offset += piece.size();
    length -= piece.size();
  }
}

std::uint32_t said_data_crc(FileWindow& window) {
  constexpr std::size_t kContent = 4;
  constexpr std::size_t kLength = kRecordHeadBytes + kContent;
  const auto footer = mcap_footer(window);
  if (!footer || footer->data_end < kMcapMagic.size() + kLength) {
    return 0;
  }
  const auto bytes = window.at(footer->data_end - kLength, kLength);
  const auto head = record_head(bytes);
  std::uint32_t crc = 0;
  const bool is_end = head && head->opcode == Opcode::data_end && head->length == kContent &&
                      RecordFields(bytes.subspan(kRecordHeadBytes)).take(crc);
  return is_end ? crc : 0;
}

std::string crc_text(std::uint32_t crc) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "0x";
  for (unsigned shift = 32; shift > 0; shift -= 4) {
    text += kDigits[(crc >> (shift - 4)) & 0xFU];
  }
  return text;
}

}  // namespace tcert::recording
