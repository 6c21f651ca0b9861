#include "support/mcap_writer.hpp"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <utility>

namespace tcert::test_support {
namespace {

constexpr std::string_view kMagic = "\x89MCAP0\r\n";

std::uint32_t crc_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string record_of(std::uint8_t opcode, std::string_view content) {
  return little_endian(opcode) + little_endian(std::uint64_t{content.size()}) +
         std::string(content);
}

std::string packed(std::string_view records, const std::string& compression) {
  if (compression == "zstd") {
    std::string out(ZSTD_compressBound(records.size()), '\0');
    out.resize(ZSTD_compress(out.data(), out.size(), records.data(), records.size(), 1));
    return out;
  }
  if (compression == "lz4") {
    std::string out(LZ4F_compressFrameBound(records.size(), nullptr), '\0');
    out.resize(LZ4F_compressFrame(out.data(), out.size(), records.data(), records.size(), nullptr));
    return out;
  }
  return std::string(records);
}

}  // namespace

std::string prefixed(std::string_view text) {
  return little_endian(static_cast<std::uint32_t>(text.size())) + std::string(text);
}

McapWriter::McapWriter(std::ostream& out, McapWriterOptions options)
    : out_(out), options_(std::move(options)) {
  write(kMagic);
  record(0x01, prefixed("ros2") + prefixed("test"));
}

void McapWriter::write(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  offset_ += bytes.size();
  crc_ = options_.data_crc ? crc_of(bytes, crc_) : 0;
}

void McapWriter::put(std::uint8_t opcode, std::string_view content) {
  if (!options_.chunks) {
    write(record_of(opcode, content));
    return;
  }
  open_chunk_ += record_of(opcode, content);
  if (open_chunk_.size() >= options_.chunk_bytes) {
    end_chunk();
  }
}

void McapWriter::record(std::uint8_t opcode, std::string_view content) {
  end_chunk();
  write(record_of(opcode, content));
}

void McapWriter::schema(std::uint16_t id,
                        std::string_view name,
                        std::string_view encoding,
                        std::string_view data) {
  const std::string content =
      little_endian(id) + prefixed(name) + prefixed(encoding) + prefixed(data);
  repeated_ += record_of(0x03, content);
  put(0x03, content);
}

void McapWriter::channel(std::uint16_t id,
                         std::uint16_t schema,
                         std::string_view topic,
                         std::string_view encoding) {
  const std::string content = little_endian(id) + little_endian(schema) + prefixed(topic) +
                              prefixed(encoding) + prefixed("");
  repeated_ += record_of(0x04, content);
  counts_[id] += 0;
  put(0x04, content);
}

void McapWriter::message(std::uint16_t channel,
                         std::uint64_t log,
                         std::uint64_t publish,
                         std::string_view data) {
  ++counts_[channel];
  ++messages_;
  put(0x05,
      little_endian(channel) + little_endian(std::uint32_t{0}) + little_endian(log) +
          little_endian(publish) + std::string(data));
}

void McapWriter::end_chunk() {
  if (open_chunk_.empty()) {
    return;
  }
  const std::string records = packed(open_chunk_, options_.compression);
  const std::uint32_t crc = options_.chunk_crc ? crc_of(open_chunk_) : 0;
  const std::string content = little_endian(std::uint64_t{0}) + little_endian(std::uint64_t{0}) +
                              little_endian(std::uint64_t{open_chunk_.size()}) +
                              little_endian(crc) + prefixed(options_.compression) +
                              little_endian(std::uint64_t{records.size()}) + records;
  const std::uint64_t begin = offset_;
  write(record_of(0x06, content));
  chunks_.push_back({begin, offset_, messages_});
  open_chunk_.clear();
}

void McapWriter::finish(const std::map<std::uint16_t, std::uint64_t>& counts) {
  end_chunk();
  write(record_of(0x0F, little_endian(crc_)));
  const std::uint64_t summary_start = options_.summary ? offset_ : 0;
  crc_ = 0;
  if (options_.summary) {
    std::string of_channels;
    std::uint64_t sum = 0;
    for (const auto& [channel, count] : counts.empty() ? counts_ : counts) {
      of_channels += little_endian(channel) + little_endian(count);
      sum += count;
    }
    write(repeated_);
    write(record_of(0x0B,
                    little_endian(sum) + little_endian(std::uint16_t{1}) +
                        little_endian(static_cast<std::uint32_t>(counts_.size())) +
                        little_endian(std::uint32_t{0}) + little_endian(std::uint32_t{0}) +
                        little_endian(static_cast<std::uint32_t>(chunks_.size())) +
                        little_endian(std::uint64_t{0}) + little_endian(std::uint64_t{0}) +
                        prefixed(of_channels)));
  }
  write(little_endian(std::uint8_t{0x02}) + little_endian(std::uint64_t{20}) +
        little_endian(summary_start) + little_endian(std::uint64_t{0}));
  write(little_endian(summary_start == 0 ? 0U : crc_));
  write(kMagic);
}

}  // namespace tcert::test_support
