#pragma once
/// \file
/// An MCAP file, written plainly by the specification: for tests and benchmarks of the reader.

#include <cstdint>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::test_support {

struct McapWriterOptions {
  bool chunks = true;
  std::string compression;  ///< Of chunks: "", "zstd" or "lz4".
  std::size_t chunk_bytes = 1U << 20U;
  bool chunk_crc = true;
  bool data_crc = true;
  bool summary = true;  ///< Schemas, channels and statistics.
};

/// Writes records as they come; what is wrong with them is the caller's affair.
class McapWriter {
 public:
  explicit McapWriter(std::ostream& out, McapWriterOptions options = {});

  void schema(std::uint16_t id,
              std::string_view name,
              std::string_view encoding,
              std::string_view data);
  void channel(std::uint16_t id,
               std::uint16_t schema,
               std::string_view topic,
               std::string_view encoding);
  void message(std::uint16_t channel,
               std::uint64_t log,
               std::uint64_t publish,
               std::string_view data);

  /// Any record outside of a chunk; one that is open is closed first.
  void record(std::uint8_t opcode, std::string_view content);

  /// Writes the chunk that is open, if it holds anything.
  void end_chunk();

  /// Writes the end of the file: data end, summary, footer. `counts` go into the statistics in the
  /// place of the true ones, where they are given.
  void finish(const std::map<std::uint16_t, std::uint64_t>& counts = {});

  /// Offsets of the chunks that were written, and how many messages lie before the end of each.
  struct Chunk {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::size_t messages_to_end = 0;
  };
  [[nodiscard]] const std::vector<Chunk>& chunks() const noexcept { return chunks_; }

 private:
  void write(std::string_view bytes);
  void put(std::uint8_t opcode, std::string_view content);

  std::ostream& out_;
  McapWriterOptions options_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;
  std::string open_chunk_;
  std::string repeated_;  // schemas and channels, for the summary
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::size_t messages_ = 0;
  std::vector<Chunk> chunks_;
};

/// `value` in little endian.
template <class T>
std::string little_endian(T value) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU);
  }
  return bytes;
}

/// `text` behind its length in four bytes.
[[nodiscard]] std::string prefixed(std::string_view text);

}  // namespace tcert::test_support
