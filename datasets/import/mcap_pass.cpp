#include "datasets/import/mcap_pass.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "datasets/import/crc32.hpp"
#include "datasets/import/mcap_checksum.hpp"
#include "datasets/import/mcap_summary.hpp"

namespace tcert::recording {
namespace {

/// What a chunk record has besides its records, with room for the name of any method.
constexpr std::size_t kChunkFields = 4096;

class McapPass {
 public:
  McapPass(McapFile& file, const McapHandlers& handlers, table::DiagnosticGroups& problems)
      : file_(file),
        handlers_(handlers),
        problems_(problems),
        sum_(!file.is_summed && said_data_crc(file.window) != 0) {}

  McapPassEnd run();

 private:
  enum class Step { next, stop, end };

  void warn(std::string found, std::string expectation);
  [[nodiscard]] std::string here() const { return "byte " + std::to_string(offset_); }

  std::optional<RecordHead> next_head();
  Step take(const RecordHead& head);
  Step take_chunk(std::span<const std::byte> record);
  Step take_chunk_records(std::span<const std::byte> records);
  Step take_small(Opcode opcode, std::span<const std::byte> content);
  Step end_of_data(const RecordHead& head, std::span<const std::byte> content);
  bool is_sound(const ChunkRecord& chunk,
                std::span<const std::byte> record,
                std::span<const std::byte> records);
  void say_cut_off();

  McapFile& file_;
  const McapHandlers& handlers_;
  table::DiagnosticGroups& problems_;
  DataChecksum sum_;
  std::uint64_t offset_ = kMcapMagic.size();  // of the record that is being read
  McapPassEnd end_;
  bool lost_ = false;
};

/// Says a problem of the record at offset_, unless an earlier pass did.
void McapPass::warn(std::string found, std::string expectation) {
  lost_ = true;
  if (offset_ >= file_.told_to) {
    problems_.add(
        {table::Severity::warning, file_.name, 0, "", std::move(found), std::move(expectation), 1});
  }
}

McapPassEnd McapPass::run() {
  sum_.add(file_.window, 0, kMcapMagic.size());
  Step step = Step::next;
  while (step == Step::next) {
    const auto head = next_head();
    if (!head) {
      say_cut_off();
      break;
    }
    step = take(*head);
    if (step == Step::next) {
      offset_ += kRecordHeadBytes + head->length;
    }
  }
  end_.stopped = step == Step::stop;
  file_.told_to = std::max(file_.told_to, end_.stopped ? offset_ + 1 : file_.window.size() + 1);
  end_.complete = step == Step::end && !lost_;
  return end_;
}

/// Of the record at offset_, if it is whole.
std::optional<RecordHead> McapPass::next_head() {
  const auto head = record_head(file_.window.at(offset_, kRecordHeadBytes));
  const bool fits = head && head->length <= file_.window.size() - offset_ - kRecordHeadBytes;
  return fits ? head : std::nullopt;
}

void McapPass::say_cut_off() {
  warn("the end of the file in a record that begins at " + here(),
       "a recording that was closed; the " + std::to_string(end_.messages) +
           " messages before that record are read");
}

McapPass::Step McapPass::take(const RecordHead& head) {
  const bool is_known = head.opcode == Opcode::chunk || head.opcode == Opcode::message ||
                        head.opcode == Opcode::schema || head.opcode == Opcode::channel ||
                        head.opcode == Opcode::data_end || head.opcode == Opcode::footer;
  if (!is_known || head.length > kLargestChunk + kChunkFields) {
    if (is_known) {
      warn("a record of " + std::to_string(head.length) + " bytes at " + here(),
           "records of at most 1 GiB; this one is left out");
    }
    sum_.add(file_.window, offset_, kRecordHeadBytes + head.length);
    return Step::next;
  }
  const std::size_t length = kRecordHeadBytes + static_cast<std::size_t>(head.length);
  const auto record = file_.window.at(offset_, length);
  if (record.size() < length) {
    say_cut_off();
    return Step::end;
  }
  const auto content = record.subspan(kRecordHeadBytes);
  if (head.opcode == Opcode::data_end || head.opcode == Opcode::footer) {
    return end_of_data(head, content);
  }
  if (head.opcode == Opcode::chunk) {
    return take_chunk(record);
  }
  sum_.add(record);
  return take_small(head.opcode, content);
}

McapPass::Step McapPass::take_chunk(std::span<const std::byte> record) {
  const auto chunk = chunk_record(record.subspan(kRecordHeadBytes));
  std::string problem = "its fields are longer than it";
  const auto records = chunk ? file_.expander.expand(*chunk, problem) : std::nullopt;
  if (!records) {
    sum_.add(record);
    warn("a chunk at " + here() + ": " + problem,
         "chunks that can be expanded; the messages of such a chunk are left out");
    return Step::next;
  }
  return is_sound(*chunk, record, *records) ? take_chunk_records(*records) : Step::next;
}

/// Compares the chunk's checksum the first time that it is met, and adds the chunk to that of the
/// section: where its records are not packed, without going through them twice.
bool McapPass::is_sound(const ChunkRecord& chunk,
                        std::span<const std::byte> record,
                        std::span<const std::byte> records) {
  const bool is_plain = records.data() == chunk.records.data();
  const bool is_compared =
      chunk.uncompressed_crc != 0 && (offset_ >= file_.told_to || file_.has_damaged_chunks);
  const std::uint32_t crc = is_compared || (sum_.wanted() && is_plain) ? crc32(records) : 0;
  if (is_plain) {
    sum_.add(record, records, crc);
  } else {
    sum_.add(record);
  }
  if (!is_compared || crc == chunk.uncompressed_crc) {
    return true;
  }
  file_.has_damaged_chunks = true;
  warn("a chunk at " + here() + " with CRC " + crc_text(crc) + ", not " +
           crc_text(chunk.uncompressed_crc),
       "chunks with the CRC that they say; the messages of such a chunk are left out");
  return false;
}

McapPass::Step McapPass::take_chunk_records(std::span<const std::byte> records) {
  while (!records.empty()) {
    const auto head = record_head(records);
    if (!head || head->length > records.size() - kRecordHeadBytes) {
      warn("a record that is longer than its chunk, at " + here(),
           "chunks of whole records; the rest of such a chunk is left out");
      return Step::next;
    }
    const auto length = static_cast<std::size_t>(head->length);
    const Step step = take_small(head->opcode, records.subspan(kRecordHeadBytes, length));
    if (step != Step::next) {
      return step;
    }
    records = records.subspan(kRecordHeadBytes + length);
  }
  return Step::next;
}

McapPass::Step McapPass::take_small(Opcode opcode, std::span<const std::byte> content) {
  bool is_whole = true;
  if (opcode == Opcode::message) {
    const auto message = message_record(content);
    is_whole = message.has_value();
    end_.messages += is_whole ? 1 : 0;
    if (is_whole && handlers_.message && !handlers_.message(*message)) {
      return Step::stop;
    }
  } else if (opcode == Opcode::schema) {
    const auto schema = schema_record(content);
    is_whole = schema.has_value();
    if (is_whole && handlers_.schema) {
      handlers_.schema(*schema);
    }
  } else if (opcode == Opcode::channel) {
    const auto channel = channel_record(content);
    is_whole = channel.has_value();
    if (is_whole && handlers_.channel) {
      handlers_.channel(*channel);
    }
  }
  if (!is_whole) {
    warn("a record whose fields are longer than it, at " + here(),
         "whole records; such a record is left out");
  }
  return Step::next;
}

McapPass::Step McapPass::end_of_data(const RecordHead& head, std::span<const std::byte> content) {
  std::uint32_t said = 0;
  const bool says = head.opcode == Opcode::data_end && RecordFields(content).take(said);
  if (says && sum_.wanted() && said != 0 && said != sum_.value()) {
    warn("a data section with CRC " + crc_text(sum_.value()) + ", not " + crc_text(said) + " as " +
             here() + " says",
         "a data section with the CRC that it says; what is damaged is not known");
  }
  file_.is_summed = true;
  if (!mcap_footer(file_.window)) {
    offset_ += kRecordHeadBytes + head.length;
    warn(
        "no footer behind the data section, which ends at " + here(),
        "a recording that was closed; its " + std::to_string(end_.messages) + " messages are read");
  }
  return Step::end;
}

}  // namespace

McapPassEnd pass_through(McapFile& file,
                         const McapHandlers& handlers,
                         table::DiagnosticGroups& problems) {
  return McapPass(file, handlers, problems).run();
}

}  // namespace tcert::recording
