#include "datasets/import/mcap_summary.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "datasets/import/crc32.hpp"
#include "datasets/import/mcap_checksum.hpp"
#include "datasets/import/mcap_record.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kFooterContent = 20;
constexpr std::size_t kFooterChecked = 16;  // the part of it that its own checksum covers
constexpr std::size_t kLargestSummaryRecord = std::size_t{64} << 20U;

/// The Statistics record, as far as it is used.
struct Statistics {
  std::uint64_t messages = 0;
  std::uint32_t chunks = 0;
  std::map<std::uint16_t, std::uint64_t> of_channel;
};

std::optional<Statistics> statistics_record(std::span<const std::byte> bytes) {
  RecordFields fields(bytes);
  Statistics record;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  std::string_view counts;
  if (!fields.take(record.messages) || !fields.take(schemas) || !fields.take(channels) ||
      !fields.take(attachments) || !fields.take(metadata) || !fields.take(record.chunks) ||
      !fields.take(start) || !fields.take(end) || !fields.take_text(counts)) {
    return std::nullopt;
  }
  RecordFields pairs(std::as_bytes(std::span(counts)));
  while (!pairs.rest().empty()) {
    std::uint16_t channel = 0;
    std::uint64_t count = 0;
    if (!pairs.take(channel) || !pairs.take(count)) {
      return std::nullopt;
    }
    record.of_channel[channel] += count;
  }
  return record;
}

/// Reads the records of the section one by one.
class SummaryReader {
 public:
  SummaryReader(FileWindow& window, const McapFooter& footer) : window_(window), footer_(footer) {}

  /// False, with the reason, if the section does not hold together.
  bool read(std::string& problem);

  [[nodiscard]] bool has_statistics() const noexcept { return statistics_.has_value(); }
  std::optional<McapSummary> summary(std::string& problem);

 private:
  bool take(Opcode opcode, std::span<const std::byte> content);

  FileWindow& window_;
  const McapFooter& footer_;
  McapTopics topics_;
  std::optional<Statistics> statistics_;
};

bool SummaryReader::take(Opcode opcode, std::span<const std::byte> content) {
  if (opcode == Opcode::schema) {
    const auto schema = schema_record(content);
    if (schema) {
      topics_.add(*schema);
    }
    return schema.has_value();
  }
  if (opcode == Opcode::channel) {
    const auto channel = channel_record(content);
    if (channel) {
      topics_.add(*channel);
    }
    return channel.has_value() &&
           (channel->schema_id == 0 || topics_.has_schema(channel->schema_id));
  }
  if (opcode == Opcode::statistics) {
    statistics_ = statistics_record(content);
    return statistics_.has_value();
  }
  return true;
}

bool SummaryReader::read(std::string& problem) {
  DataChecksum sum(footer_.summary_crc != 0);
  sum.add(window_, footer_.summary_start, footer_.checked_end - footer_.summary_start);
  if (sum.value() != footer_.summary_crc) {
    problem = "its CRC is " + crc_text(sum.value()) + ", not " + crc_text(footer_.summary_crc);
    return false;
  }
  for (std::uint64_t at = footer_.summary_start; at < footer_.summary_end;) {
    const auto head = record_head(window_.at(at, kRecordHeadBytes));
    const std::uint64_t room = footer_.summary_end - at;
    if (!head || room < kRecordHeadBytes || head->length > room - kRecordHeadBytes ||
        head->length > kLargestSummaryRecord) {
      problem = "its record at byte " + std::to_string(at) + " is not whole";
      return false;
    }
    const std::size_t length = kRecordHeadBytes + static_cast<std::size_t>(head->length);
    const auto record = window_.at(at, length);
    if (record.size() < length || !take(head->opcode, record.subspan(kRecordHeadBytes))) {
      problem = "its record at byte " + std::to_string(at) + " is damaged";
      return false;
    }
    at += length;
  }
  return true;
}

std::optional<McapSummary> SummaryReader::summary(std::string& problem) {
  std::vector<std::size_t> messages(topics_.topics().size());
  std::uint64_t sum = 0;
  for (const auto& [channel, count] : statistics_->of_channel) {
    const auto topic = topics_.topic_of(channel);
    if (!topic) {
      problem =
          "it counts messages of channel " + std::to_string(channel) + ", but does not list it";
      return std::nullopt;
    }
    messages[*topic] += count;
    sum += count;
  }
  if (sum != statistics_->messages) {
    problem = "it counts " + std::to_string(statistics_->messages) + " messages, and " +
              std::to_string(sum) + " by channel";
    return std::nullopt;
  }
  topics_.set_counts(messages);
  return McapSummary{std::move(topics_)};
}

}  // namespace

std::optional<McapFooter> mcap_footer(FileWindow& window) {
  constexpr std::size_t kTail = kRecordHeadBytes + kFooterContent + kMcapMagic.size();
  if (window.size() < kMcapMagic.size() + kTail) {
    return std::nullopt;
  }
  const std::uint64_t start = window.size() - kTail;
  const auto bytes = window.at(start, kTail);
  const auto head = record_head(bytes);
  if (bytes.size() < kTail || !head || head->opcode != Opcode::footer ||
      head->length != kFooterContent ||
      !std::ranges::equal(bytes.last(kMcapMagic.size()), std::as_bytes(std::span(kMcapMagic)))) {
    return std::nullopt;
  }
  const auto record = footer_record(bytes.subspan(kRecordHeadBytes));
  McapFooter footer;
  footer.summary_start = record->summary_start;
  footer.summary_end = record->summary_offset_start == 0 ? start : record->summary_offset_start;
  footer.data_end = record->summary_start == 0 ? footer.summary_end : record->summary_start;
  footer.checked_end = start + kRecordHeadBytes + kFooterChecked;
  footer.summary_crc = record->summary_crc;
  const bool in_order = footer.data_end >= kMcapMagic.size() &&
                        footer.data_end <= footer.summary_end && footer.summary_end <= start;
  return in_order ? std::optional(footer) : std::nullopt;
}

std::optional<McapSummary> mcap_summary(FileWindow& window, std::string& problem) {
  const auto footer = mcap_footer(window);
  if (!footer || footer->summary_start == 0) {
    return std::nullopt;
  }
  SummaryReader reader(window, *footer);
  if (!reader.read(problem) || !reader.has_statistics()) {
    return std::nullopt;
  }
  return reader.summary(problem);
}

}  // namespace tcert::recording
