#include <gtest/gtest.h>
#include <zstd.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "bag_messages.hpp"
#include "support/mcap_writer.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::recording {
namespace {

using test_support::little_endian;
using test_support::McapWriter;
using test_support::McapWriterOptions;
using test_support::prefixed;
using test_support::TemporaryFolder;

constexpr std::size_t kMessages = 300;

std::string data_of(std::size_t i) {
  return "message " + std::to_string(i) + std::string(i % 50, '.');
}

void write_topics(McapWriter& writer) {
  writer.schema(1, "std_msgs/String", "ros2msg", "string data");
  writer.channel(1, 1, "/a", "cdr");
  writer.channel(2, 1, "/b", "cdr");
}

void write_messages(McapWriter& writer, std::size_t count = kMessages) {
  for (std::size_t i = 0; i < count; ++i) {
    writer.message(i % 3 == 0 ? 2 : 1, 1000 + i, i, data_of(i));
  }
}

struct Written {
  std::string bytes;
  std::vector<McapWriter::Chunk> chunks;
};

Written written(const McapWriterOptions& options) {
  std::ostringstream out;
  McapWriter writer(out, options);
  write_topics(writer);
  write_messages(writer);
  writer.finish();
  return {out.str(), writer.chunks()};
}

ReadBag read_bytes(const TemporaryFolder& folder, const std::string& bytes) {
  return read_bag(folder.write("bag", bytes));
}

void expect_first_messages(const ReadBag& read, std::size_t count) {
  ASSERT_EQ(read.messages.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(
        read.messages[i],
        (ReadMessage{i % 3 == 0 ? "/b" : "/a", static_cast<std::int64_t>(1000 + i), data_of(i)}));
  }
}

TEST(Mcap, IsReadWhateverItsChunksAndSummary) {
  const TemporaryFolder folder;
  for (const char* compression : {"", "zstd", "lz4"}) {
    for (const bool chunks : {true, false}) {
      for (const bool summary : {true, false}) {
        for (const bool sums : {true, false}) {
          SCOPED_TRACE(std::string(compression) + (chunks ? " chunks" : "") +
                       (summary ? " summary" : "") + (sums ? " sums" : ""));
          const ReadBag read =
              read_bytes(folder, written({chunks, compression, 1000, sums, sums, summary}).bytes);
          EXPECT_TRUE(read.said.empty()) << read.said.front();
          expect_first_messages(read, kMessages);
          ASSERT_EQ(read.topics.size(), 2U);
          EXPECT_EQ(read.topics[0].name, "/a");
          EXPECT_EQ(read.topics[0].type, "std_msgs/msg/String");
          EXPECT_EQ(read.topics[0].definition, "string data");
          EXPECT_EQ(read.topics[0].messages, 200U);
          EXPECT_EQ(read.topics[1].messages, 100U);
        }
      }
    }
  }
}

TEST(Mcap, ShowsTheWantedTopicsUntilTheVisitorHasEnough) {
  const TemporaryFolder folder;
  table::DiagnosticGroups problems;
  const auto bag = open_mcap(folder.write("bag", written({true, "zstd", 1000}).bytes), problems);
  ASSERT_NE(bag, nullptr);
  const std::size_t wanted[]{1};
  std::size_t shown = 0;
  bag->for_each(
      wanted,
      [&](const RawMessage& message) {
        EXPECT_EQ(message.topic, 1U);
        EXPECT_EQ(message.publish_ns, message.log_ns - 1000);
        return ++shown < 7;
      },
      problems);
  EXPECT_EQ(shown, 7U);
  EXPECT_TRUE(lines_of(problems).empty()) << "a pass that was ended is no damage";
  EXPECT_EQ(messages_of(*bag, problems).size(), kMessages);
}

TEST(Mcap, ChannelsOfOneTopicAreOne) {
  const TemporaryFolder folder;
  std::ostringstream out;
  McapWriter writer(out);
  write_topics(writer);
  writer.channel(9, 1, "/a", "cdr");
  writer.channel(10, 1, "/a", "json");
  for (const int channel : {1, 9, 10}) {
    writer.message(static_cast<std::uint16_t>(channel), 1, 1, "x");
  }
  writer.finish();
  const ReadBag read = read_bytes(folder, out.str());
  ASSERT_EQ(read.topics.size(), 3U);
  EXPECT_EQ(read.topics[0].messages, 2U);
  EXPECT_EQ(read.topics[2].encoding, "json");
  EXPECT_TRUE(read.said.empty());
}

TEST(Mcap, RecordsThatItDoesNotKnowAreSkipped) {
  const TemporaryFolder folder;
  for (const bool summary : {true, false}) {
    std::ostringstream out;
    McapWriter writer(out, {true, "", 1000, true, true, summary});
    write_topics(writer);
    writer.record(0x09, std::string(3'000'000, 'a'));  // an attachment
    writer.record(0x0C, prefixed("m") + prefixed(""));
    writer.record(0x91, "private");
    writer.record(0x10, "of a later version");
    write_messages(writer);
    writer.record(0x07, "an index");
    writer.finish();
    const ReadBag read = read_bytes(folder, out.str());
    EXPECT_TRUE(read.said.empty()) << read.said.front();
    expect_first_messages(read, kMessages);
  }
}

/// Of every length: a cut within the data section loses what lies behind the last whole chunk.
void expect_prefix_at(const TemporaryFolder& folder,
                      const Written& whole,
                      std::size_t length,
                      std::uint64_t data_end) {
  SCOPED_TRACE(length);
  const ReadBag read = read_bytes(folder, whole.bytes.substr(0, length));
  std::size_t expected = 0;
  for (const McapWriter::Chunk& chunk : whole.chunks) {
    expected = chunk.end <= length ? chunk.messages_to_end : expected;
  }
  EXPECT_EQ(read.is_open, expected > 0 || length >= data_end);
  expect_first_messages(read, expected);
  if (read.is_open && length < data_end) {
    EXPECT_EQ(read.says("the end of the file in a record that begins at byte"), 1U);
    EXPECT_EQ(
        read.says("the " + std::to_string(expected) + " messages before that record are read"), 1U);
  } else if (read.is_open && length < whole.bytes.size()) {
    EXPECT_EQ(read.says("no footer behind the data section"), 1U);
  } else if (!read.is_open) {
    EXPECT_EQ(read.says("error"), 1U);
  }
  EXPECT_TRUE(read.said_again.empty());
}

TEST(Mcap, ThatIsCutOffIsReadToItsLastWholeChunk) {
  const TemporaryFolder folder;
  for (const char* compression : {"", "zstd", "lz4"}) {
    const Written whole = written({true, compression, 1500});
    ASSERT_GT(whole.chunks.size(), 4U);
    const std::uint64_t data_end = whole.chunks.back().end + 9 + 4;
    for (std::size_t length = 0; length < whole.bytes.size(); length += length < 4096 ? 7 : 101) {
      expect_prefix_at(folder, whole, length, data_end);
    }
  }
}

TEST(Mcap, WithoutChunksIsReadToItsLastWholeMessage) {
  const TemporaryFolder folder;
  const Written whole = written({false, "", 0, true, true, false});
  std::size_t last = 0;
  for (std::size_t length = 0; length < whole.bytes.size(); length += 13) {
    const ReadBag read = read_bytes(folder, whole.bytes.substr(0, length));
    expect_first_messages(read, read.messages.size());
    EXPECT_GE(read.messages.size(), last);
    last = read.messages.size();
  }
  EXPECT_EQ(last, kMessages);
}

TEST(Mcap, AChunkWithAnotherChecksumIsLeftOutAndSaid) {
  const TemporaryFolder folder;
  for (const bool summary : {true, false}) {
    Written whole = written({true, "", 1500, true, false, summary});
    const McapWriter::Chunk& chunk = whole.chunks[2];
    whole.bytes[chunk.end - 3] ^= 1;
    const ReadBag read = read_bytes(folder, whole.bytes);
    const std::size_t lost = chunk.messages_to_end - whole.chunks[1].messages_to_end;
    EXPECT_EQ(read.messages.size(), kMessages - lost);
    EXPECT_EQ(read.says("a chunk at byte " + std::to_string(chunk.begin) + " with CRC 0x"), 1U);
    EXPECT_TRUE(read.said_again.empty()) << read.said_again.front();
  }
}

TEST(Mcap, ADataSectionWithAnotherChecksumIsSaid) {
  const TemporaryFolder folder;
  for (const char* compression : {"", "zstd"}) {
    for (const bool summary : {true, false}) {
      Written whole = written({true, compression, 1500, false, true, summary});
      whole.bytes[whole.chunks[1].begin + 9] ^= 1;  // the start time, which nothing else checks
      const ReadBag read = read_bytes(folder, whole.bytes);
      expect_first_messages(read, kMessages);
      EXPECT_EQ(read.says("a data section with CRC 0x"), 1U);
      EXPECT_TRUE(read.said_again.empty());
    }
  }
}

TEST(Mcap, AChunkThatCannotBeExpandedIsLeftOut) {
  const TemporaryFolder folder;
  for (const char* compression : {"zstd", "lz4"}) {
    Written whole = written({true, compression, 1500, true, false});
    const McapWriter::Chunk& chunk = whole.chunks[1];
    for (std::uint64_t at = (chunk.begin + chunk.end) / 2; at < chunk.end; ++at) {
      whole.bytes[at] = '\xEE';
    }
    const ReadBag read = read_bytes(folder, whole.bytes);
    EXPECT_EQ(read.messages.size(),
              kMessages - (chunk.messages_to_end - whole.chunks[0].messages_to_end));
    EXPECT_EQ(read.says("a chunk at byte " + std::to_string(chunk.begin)), 1U);
  }
}

TEST(Mcap, BytesBehindThePackedRecordsOfAChunkArePadding) {
  const TemporaryFolder folder;
  for (const char* compression : {"zstd", "lz4"}) {
    const Written whole = written({true, compression, 1500, true, false, false});
    std::string bytes = whole.bytes.substr(0, whole.chunks[0].begin);
    for (const McapWriter::Chunk& chunk : whole.chunks) {
      std::string record = whole.bytes.substr(chunk.begin, chunk.end - chunk.begin);
      const std::size_t fields = 9 + 8 + 8 + 8 + 4 + 4 + std::string(compression).size();
      record.replace(1, 8, little_endian(std::uint64_t{record.size() - 9 + 5}));
      record.replace(fields, 8, little_endian(std::uint64_t{record.size() - fields - 8 + 3}));
      bytes += record + "\1\2\3" + "xy";  // behind the frame, and behind the records
    }
    bytes += whole.bytes.substr(whole.chunks.back().end);
    const ReadBag read = read_bytes(folder, bytes);
    expect_first_messages(read, kMessages);
    EXPECT_TRUE(read.said.empty()) << read.said.front();
  }
}

std::string chunk_content(std::uint64_t size,
                          std::string_view compression,
                          std::string_view records) {
  return little_endian(std::uint64_t{0}) + little_endian(std::uint64_t{0}) + little_endian(size) +
         little_endian(0U) + prefixed(compression) + little_endian(std::uint64_t{records.size()}) +
         std::string(records);
}

TEST(Mcap, ChunksThatWouldFillTheMemoryAreRefused) {
  const TemporaryFolder folder;
  for (const std::uint64_t size :
       {std::uint64_t{5} << 30U, std::uint64_t{900} << 20U, ~std::uint64_t{0}}) {
    std::ostringstream out;
    McapWriter writer(out);
    write_topics(writer);
    writer.record(0x06, chunk_content(size, "zstd", "\x28\xB5\x2F\xFD"));
    writer.record(0x06, chunk_content(size, "lz4", "abc"));
    writer.record(0x06, chunk_content(3, "bz2", "abc"));
    writer.record(0x06, chunk_content(size, "", "abc"));
    writer.record(0x06, "too short");
    write_messages(writer);
    writer.finish();
    const ReadBag read = read_bytes(folder, out.str());
    expect_first_messages(read, kMessages);
    EXPECT_EQ(read.says("chunks that can be expanded"), 1U);
    EXPECT_EQ(read.says("(and 4 more)"), 1U);
  }
}

TEST(Mcap, ManyChunksThatEachExpandPlausiblyDoNotFillHours) {
  const TemporaryFolder folder;
  const std::string zeros(std::size_t{60} << 20U, '\0');
  std::string packed(ZSTD_compressBound(zeros.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 1));
  std::ostringstream out;
  McapWriter writer(out, {true, "", 1000, true, true, false});
  write_topics(writer);
  write_messages(writer);
  for (int i = 0; i < 1000; ++i) {
    writer.record(0x06, chunk_content(zeros.size(), "zstd", packed));
  }
  writer.finish();
  const ReadBag read = read_bytes(folder, out.str());
  expect_first_messages(read, kMessages);
  EXPECT_EQ(read.says("expand to more than 200 times their length"), 1U);
}

TEST(Mcap, ASummaryThatDoesNotHoldTogetherIsNotUsed) {
  const TemporaryFolder folder;
  const Written good = written({});
  const std::size_t summary = good.chunks.back().end + 9 + 4;
  std::string bytes = good.bytes;
  bytes[summary + 20] ^= 1;
  ReadBag read = read_bytes(folder, bytes);
  EXPECT_EQ(read.says("a summary section that cannot be used: its CRC is"), 1U);
  expect_first_messages(read, kMessages);
  EXPECT_EQ(read.topics[0].messages, 200U);

  std::ostringstream out;
  McapWriter writer(out);
  write_topics(writer);
  write_messages(writer);
  writer.finish({{1, 200}, {77, 100}});
  read = read_bytes(folder, out.str());
  EXPECT_EQ(read.says("it counts messages of channel 77, but does not list it"), 1U);
  expect_first_messages(read, kMessages);
}

TEST(Mcap, CountsThatDoNotAgreeAreSaidAndCorrected) {
  const TemporaryFolder folder;
  std::ostringstream out;
  McapWriter writer(out);
  write_topics(writer);
  write_messages(writer);
  writer.finish({{1, 100'000'000'000}, {2, 100}});
  const ReadBag read = read_bytes(folder, out.str());
  EXPECT_EQ(read.says("100000000000 messages of /a in the summary section, but 200 in the file"),
            1U);
  EXPECT_EQ(read.topics[0].messages, 200U);
  EXPECT_TRUE(read.said_again.empty());
}

TEST(Mcap, MessagesWithoutAChannelAndBeyondTimeAreLeftOut) {
  const TemporaryFolder folder;
  for (const bool summary : {true, false}) {
    std::ostringstream out;
    McapWriter writer(out, {true, "", 1000, true, true, summary});
    write_topics(writer);
    write_messages(writer, 3);
    writer.message(5, 1, 1, "no channel");
    writer.message(1, ~std::uint64_t{0}, 1, "in the year 2554");
    writer.finish({{1, 3}, {2, 1}});
    const ReadBag read = read_bytes(folder, out.str());
    expect_first_messages(read, 3);
    EXPECT_EQ(read.says(summary ? "lists every channel" : "a channel record for every message"),
              1U);
    EXPECT_EQ(read.says("the year 2262"), 1U);
  }
}

TEST(Mcap, AFileThatIsNoneSaysSo) {
  const TemporaryFolder folder;
  table::DiagnosticGroups problems;
  EXPECT_EQ(open_mcap(folder.write("a", "time_s,x_m\n"), problems), nullptr);
  EXPECT_EQ(open_mcap(folder.path() / "missing", problems), nullptr);
  EXPECT_EQ(open_mcap(folder.path(), problems), nullptr);
  EXPECT_EQ(lines_of(problems).size(), 3U);
  EXPECT_EQ(bag_kind(folder.write("b", "\x89MCAP0\r\n")), BagKind::mcap);
  EXPECT_EQ(bag_kind(folder.path() / "a"), BagKind::none);
  EXPECT_EQ(open_bag(folder.path() / "a", problems), nullptr);
}

TEST(Mcap, AnEmptyOneThatWasClosedIsABagWithoutMessages) {
  const TemporaryFolder folder;
  for (const bool summary : {true, false}) {
    std::ostringstream out;
    McapWriter writer(out, {true, "", 1000, true, true, summary});
    writer.finish();
    const ReadBag read = read_bytes(folder, out.str());
    EXPECT_TRUE(read.is_open);
    EXPECT_TRUE(read.messages.empty());
    EXPECT_TRUE(read.said.empty()) << read.said.front();
  }
}

std::filesystem::path nav2() {
  return test_support::shared_data() / "logs/evo/nav2_turtlebot.mcap";
}

TEST(McapOfNav2, HasTheCountsAndClocksThatAreKnownOfIt) {
  if (!std::filesystem::exists(nav2())) {
    GTEST_SKIP() << nav2() << " is not there";
  }
  const ReadBag read = read_bag(nav2());
  EXPECT_TRUE(read.said.empty());
  std::map<std::string, std::size_t> counts;
  for (const ReadMessage& message : read.messages) {
    ++counts[message.topic];
    ASSERT_NEAR(static_cast<double>(message.log_ns) * 1e-9, 1778234353.0, 600.0);
  }
  EXPECT_EQ(counts["/odom"], 2639U);
  EXPECT_EQ(counts["/amcl_pose"], 135U);
  for (const Topic& topic : read.topics) {
    EXPECT_EQ(topic.messages, counts[topic.name]) << topic.name;
  }
}

TEST(McapOfNav2, CutOffAnywhereIsAPrefix) {
  if (!std::filesystem::exists(nav2())) {
    GTEST_SKIP() << nav2() << " is not there";
  }
  const TemporaryFolder folder;
  const std::string bytes = test_support::read_text(nav2());
  const ReadBag whole = read_bag(nav2());
  std::size_t last = 0;
  for (std::size_t length = 0; length < bytes.size(); length += length < 4096 ? 16 : 1000) {
    SCOPED_TRACE(length);
    const ReadBag read = read_bytes(folder, bytes.substr(0, length));
    ASSERT_LE(read.messages.size(), whole.messages.size());
    ASSERT_TRUE(std::equal(read.messages.begin(), read.messages.end(), whole.messages.begin()));
    ASSERT_GE(read.messages.size(), last);
    ASSERT_FALSE(read.said.empty());
    last = read.messages.size();
  }
  EXPECT_GT(last, 8000U);
}

}  // namespace
}  // namespace tcert::recording
