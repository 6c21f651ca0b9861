#include <gtest/gtest.h>
#include <sqlite3.h>
#include <zstd.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "bag_messages.hpp"
#include "datasets/import/bag_metadata.hpp"
#include "datasets/import/decoder.hpp"
#include "support/cdr_bytes.hpp"
#include "support/mcap_writer.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;
using test_support::TemporaryFolder;

/// A database as a recorder writes it.
class Recorder {
 public:
  explicit Recorder(const fs::path& path) {
    EXPECT_EQ(sqlite3_open(path.c_str(), &handle_), SQLITE_OK);
    run("PRAGMA page_size = 1024");
  }
  ~Recorder() { sqlite3_close(handle_); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void run(const std::string& sql) {
    char* problem = nullptr;
    EXPECT_EQ(sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << problem;
    sqlite3_free(problem);
  }

  void make_tables() {
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
        " serialization_format TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
        " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
        "INSERT INTO topics VALUES (1, '/f', 'std_msgs/msg/Float64', 'cdr'),"
        " (2, '/g', 'std_msgs/msg/Float64', 'cdr')");
  }

  void add(int topic, std::int64_t time, const std::string& data) {
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(
        handle_, "INSERT INTO messages VALUES (NULL, ?, ?, ?)", -1, &insert, nullptr);
    sqlite3_bind_int(insert, 1, topic);
    sqlite3_bind_int64(insert, 2, time);
    sqlite3_bind_blob(insert, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE);
    sqlite3_finalize(insert);
  }

  /// `count` messages, by turns of both topics, in one transaction.
  void add_many(std::size_t count, std::size_t bytes = 0) {
    run("BEGIN");
    for (std::size_t i = 0; i < count; ++i) {
      add(i % 2 == 0 ? 1 : 2,
          static_cast<std::int64_t>(1000 + i),
          data_of(i) + std::string(bytes, 'x'));
    }
    run("COMMIT");
  }

  static std::string data_of(std::size_t i) {
    return test_support::CdrBytes().put(static_cast<double>(i)).bytes();
  }

 private:
  sqlite3* handle_ = nullptr;
};

fs::path database(const TemporaryFolder& folder, const std::string& name, std::size_t count = 10) {
  Recorder recorder(folder.path() / name);
  recorder.make_tables();
  recorder.add_many(count);
  return folder.path() / name;
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(Rosbag2, ADatabaseIsReadInTheOrderOfItsRows) {
  const TemporaryFolder folder;
  const ReadBag read = read_bag(database(folder, "a b?c#%41.db3"));
  EXPECT_TRUE(read.said.empty()) << read.said.front();
  ASSERT_EQ(read.messages.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(
        read.messages[i],
        (ReadMessage{
            i % 2 == 0 ? "/f" : "/g", static_cast<std::int64_t>(1000 + i), Recorder::data_of(i)}));
  }
  ASSERT_EQ(read.topics.size(), 2U);
  EXPECT_EQ(read.topics[1].messages, 5U);
  EXPECT_EQ(read.topics[1].type, "std_msgs/msg/Float64");
  EXPECT_EQ(names_in(folder.path()).size(), 1U) << "nothing is written beside it";
}

TEST(Rosbag2, DefinitionsInTheDatabaseGoBeforeTheBuiltInOnes) {
  const TemporaryFolder folder;
  {
    Recorder recorder(folder.path() / "a");
    recorder.make_tables();
    recorder.run(
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,"
        " encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL);"
        "INSERT INTO message_definitions VALUES (1, 'std_msgs/msg/Float64', 'ros2msg', 'float32 "
        "value')");
    recorder.add(1, 5, test_support::CdrBytes().put(2.5F).bytes());
  }
  table::DiagnosticGroups problems;
  const auto bag = open_bag(folder.path() / "a", problems);
  ASSERT_NE(bag, nullptr);
  EXPECT_EQ(bag->topics()[0].definition, "float32 value");
  std::string problem;
  const auto decoder = Decoder::of(bag->topics()[0], problem);
  ASSERT_TRUE(decoder) << problem;
  const std::size_t wanted[]{0};
  Value value;
  bag->for_each(
      wanted,
      [&](const RawMessage& message) { return (*decoder)(message.data, value, problem); },
      problems);
  EXPECT_EQ(number_at(value, "value"), 2.5);
}

/// What a recorder that was killed leaves: the last messages stand in the log alone.
void leave_log(const TemporaryFolder& folder) {
  const TemporaryFolder live;
  Recorder recorder(live.path() / "a.db3");
  recorder.run("PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0");
  recorder.make_tables();
  recorder.add_many(6);
  recorder.run("PRAGMA wal_checkpoint(TRUNCATE)");
  recorder.add_many(4);
  for (const char* name : {"a.db3", "a.db3-wal"}) {
    fs::copy_file(live.path() / name, folder.path() / name);
  }
}

TEST(Rosbag2, AWriteAheadLogBesideItCountsAndStays) {
  const TemporaryFolder folder;
  leave_log(folder);
  const std::string before = test_support::read_text(folder.path() / "a.db3");
  const std::string log = test_support::read_text(folder.path() / "a.db3-wal");
  ASSERT_FALSE(log.empty());
  const auto names = names_in(folder.path());
  fs::create_symlink(folder.path() / "a.db3", folder.path() / "link");
  for (const char* name : {"a.db3", "link"}) {
    table::DiagnosticGroups problems;
    auto bag = open_bag(folder.path() / name, problems);
    ASSERT_NE(bag, nullptr);
    EXPECT_EQ(messages_of(*bag, problems).size(), 10U);
    fs::remove(folder.path() / "link");
    EXPECT_EQ(names_in(folder.path()), names) << "no index beside it while it is read";
    bag.reset();
    EXPECT_EQ(names_in(folder.path()), names) << "nor afterwards";
    EXPECT_EQ(test_support::read_text(folder.path() / "a.db3"), before);
    EXPECT_EQ(test_support::read_text(folder.path() / "a.db3-wal"), log);
    EXPECT_TRUE(lines_of(problems).empty());
    fs::create_symlink(folder.path() / "a.db3", folder.path() / "link");
  }
}

TEST(Rosbag2, ALogThatIsLostLeavesWhatTheDatabaseHolds) {
  const TemporaryFolder folder;
  leave_log(folder);
  fs::remove(folder.path() / "a.db3-wal");
  EXPECT_EQ(read_bag(folder.path() / "a.db3").messages.size(), 6U);
  EXPECT_EQ(names_in(folder.path()).size(), 1U);
}

TEST(Rosbag2, AJournalOfAWriteThatWasNotFinishedIsRefusedWithTheWayOut) {
  const TemporaryFolder folder;
  const fs::path path = database(folder, "a.db3");
  folder.write("a.db3-journal", "\xD9\xD5\x05\xF9 and so on");
  const ReadBag read = read_bag(path);
  EXPECT_FALSE(read.is_open);
  EXPECT_EQ(read.says("a.db3-journal"), 1U);
  EXPECT_EQ(read.says("roll it back"), 1U);
}

TEST(Rosbag2, MessagesThatWerePackedOneByOneAreExpanded) {
  const TemporaryFolder folder;
  {
    Recorder recorder(folder.path() / "a.db3");
    recorder.make_tables();
    const std::string data = Recorder::data_of(7);
    std::string packed(ZSTD_compressBound(data.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), data.data(), data.size(), 1));
    recorder.add(1, 5, packed);
    recorder.add(1, 6, "\x28\xB5\x2F\xFD damaged");
  }
  const ReadBag read = read_bag(folder.path() / "a.db3");
  ASSERT_EQ(read.messages.size(), 1U);
  EXPECT_EQ(read.messages[0].data, Recorder::data_of(7));
  EXPECT_EQ(read.says("zstd data can be expanded"), 1U);
}

TEST(Rosbag2, RowsThatAreNoMessagesAreLeftOutAndCounted) {
  const TemporaryFolder folder;
  const fs::path path = database(folder, "a.db3", 4);
  {
    Recorder recorder(path);
    recorder.run(
        "INSERT INTO messages VALUES (NULL, 1, 'noon', x'00'), (NULL, 1, 5, 'text'), (NULL, 9, 5, "
        "x'00')");
  }
  const ReadBag read = read_bag(path);
  EXPECT_EQ(read.messages.size(), 4U);
  EXPECT_EQ(read.says("a whole number for their time"), 1U);
  EXPECT_EQ(read.says("messages of topics in the table"), 1U);
  EXPECT_TRUE(read.said_again.empty());
}

TEST(Rosbag2, TablesThatAreNoneOfARecorderAreRefused) {
  const TemporaryFolder folder;
  const char* schemas[]{"CREATE TABLE other(a)",
                        "CREATE TABLE topics(id, name, type, serialization_format); CREATE TABLE "
                        "messages(id, topic_id)",
                        "CREATE TABLE topics(id, name, type, serialization_format); CREATE VIEW "
                        "messages AS WITH RECURSIVE "
                        "m(topic_id, timestamp, data) AS (SELECT 1, 1, x'00' UNION ALL SELECT 1, "
                        "timestamp + 1, data FROM m) "
                        "SELECT * FROM m",
                        "CREATE TABLE topics(id, name, type, serialization_format); CREATE TABLE "
                        "messages(topic_id, timestamp, "
                        "data GENERATED ALWAYS AS (zeroblob(1000000000)))"};
  int number = 0;
  for (const char* schema : schemas) {
    const fs::path path = folder.path() / std::to_string(number++);
    Recorder(path).run(schema);
    const ReadBag read = read_bag(path);
    EXPECT_FALSE(read.is_open) << schema;
    EXPECT_EQ(read.says("an undamaged database of rosbag2"), 1U) << schema;
  }
}

TEST(Rosbag2, ADamagedDatabaseIsReadAsFarAsItGoesAndSaysSo) {
  const TemporaryFolder folder;
  {
    Recorder recorder(folder.path() / "whole");
    recorder.make_tables();
    recorder.add_many(400, 30);
  }
  const std::string whole = test_support::read_text(folder.path() / "whole");
  ASSERT_GT(whole.size(), 20'000U);
  const std::size_t all = read_bag(folder.path() / "whole").messages.size();
  ASSERT_EQ(all, 400U);
  std::size_t damaged = 0;
  for (std::size_t page = 0; page * 1024 < whole.size(); ++page) {
    for (const char fill : {'\0', '\xFF', '\x05'}) {
      std::string bytes = whole;
      bytes.replace(page * 1024 + (page == 0 ? 100 : 0), 300, std::string(300, fill));
      const ReadBag read = read_bag(folder.write("damaged", bytes));
      EXPECT_LE(read.messages.size(), all);
      EXPECT_TRUE(read.messages.size() == all || !read.said.empty()) << page;
      damaged += read.said.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(damaged, 20U);
  for (std::size_t length = 0; length < whole.size(); length += 1000) {
    const ReadBag read = read_bag(folder.write("cut", whole.substr(0, length)));
    EXPECT_FALSE(read.said.empty()) << length;
  }
}

TEST(Rosbag2, DamageThatSqliteTakesForAShortageOfMemoryIsDamage) {
  const TemporaryFolder folder;
  const fs::path path = database(folder, "a.db3");
  std::string bytes = test_support::read_text(path);
  // The root of the schema as an interior page whose only child is far away: "out of memory".
  bytes.replace(100, 12, std::string("\x05\0\0\0\0\x01\xFB\0\0\0\0\x07", 12));
  const ReadBag read = read_bag(folder.write("b.db3", bytes));
  EXPECT_FALSE(read.is_open);
  EXPECT_FALSE(read.said.empty());
}

/// The values of all messages, which data_of() made.
std::vector<double> values_of(const ReadBag& read) {
  std::vector<double> values;
  for (const ReadMessage& message : read.messages) {
    Value value;
    std::string problem;
    const auto type = message_type("std_msgs/msg/Float64", "", problem);
    EXPECT_TRUE(decode(*type, std::as_bytes(std::span(message.data)), value, problem)) << problem;
    values.push_back(number_at(value, "data").value_or(-1.0));
  }
  return values;
}

TEST(Rosbag2Folder, IsItsFilesInTheOrderOfItsMetadata) {
  const TemporaryFolder folder;
  database(folder, "bag_10.db3", 3);
  database(folder, "bag_0.db3", 2);
  std::ostringstream mcap;
  test_support::McapWriter writer(mcap);
  writer.schema(1, "std_msgs/msg/Float64", "ros2msg", "float64 data");
  writer.channel(1, 1, "/g", "cdr");
  writer.message(1, 1, 1, Recorder::data_of(99));
  writer.finish();
  folder.write("bag_3.mcap", mcap.str());
  folder.write("notes.txt", "x");

  ReadBag read = read_bag(folder.path());
  EXPECT_EQ(read.said.size(), 1U);
  EXPECT_EQ(read.says("3 files without metadata.yaml"), 1U);
  EXPECT_EQ(values_of(read), (std::vector<double>{0, 1, 99, 0, 1, 2})) << "0 before 3 before 10";
  ASSERT_EQ(read.topics.size(), 2U);
  EXPECT_EQ(read.topics[0].messages, 3U);
  EXPECT_EQ(read.topics[1].messages, 3U);
  EXPECT_EQ(read.topics[1].definition, "float64 data") << "from the file that has one";

  folder.write("metadata.yaml",
               "rosbag2_bagfile_information:\n  relative_file_paths:\n    - bag_10.db3\n"
               "    - \"old_name/bag_0.db3\"\n  duration:\n    nanoseconds: 1\n");
  read = read_bag(folder.path());
  EXPECT_EQ(values_of(read), (std::vector<double>{0, 1, 2, 0, 1}));
  EXPECT_TRUE(read.said.empty());
}

TEST(Rosbag2Folder, AFileLessIsAWarningAndNoneAnError) {
  const TemporaryFolder folder;
  const std::string list = "relative_file_paths: ['a.db3', b.db3, ../../etc/passwd, c.db3.zstd]\n";
  folder.write("metadata.yaml", list);
  folder.write("c.db3.zstd", "packed");
  ReadBag read = read_bag(folder.path());
  EXPECT_FALSE(read.is_open);
  EXPECT_GE(read.says("error"), 4U);
  EXPECT_EQ(read.says("'unzstd c.db3.zstd'"), 1U);
  database(folder, "b.db3", 2);
  read = read_bag(folder.path());
  EXPECT_EQ(read.messages.size(), 2U);
  EXPECT_EQ(read.says("error"), 0U);
  EXPECT_EQ(read.says("the messages of this file are left out"), 3U);
  fs::remove(folder.path() / "c.db3.zstd");
  database(folder, "c.db3", 2);
  read = read_bag(folder.path());
  EXPECT_EQ(read.messages.size(), 4U) << "what was expanded stands for the packed file";
}

TEST(Rosbag2Folder, StopsInTheMiddleOfItsFiles) {
  const TemporaryFolder folder;
  database(folder, "a_0.db3", 4);
  database(folder, "a_1.db3", 4);
  table::DiagnosticGroups problems;
  const auto bag = open_bag(folder.path(), problems);
  ASSERT_NE(bag, nullptr);
  const std::size_t wanted[]{0, 1};
  std::size_t shown = 0;
  bag->for_each(
      wanted, [&](const RawMessage&) { return ++shown < 3; }, problems);
  EXPECT_EQ(shown, 3U);
}

TEST(Rosbag2Folder, OfSeveralRecordingsIsNoneWithoutItsMetadata) {
  const TemporaryFolder folder;
  database(folder, "monday.db3", 4);
  EXPECT_EQ(bag_kind(folder.path()), BagKind::folder);
  database(folder, "tuesday_0.db3", 4);
  EXPECT_EQ(bag_kind(folder.path()), BagKind::none);
  EXPECT_EQ(read_bag(folder.path()).says("of one recording"), 1U);
  folder.write("metadata.yaml", "relative_file_paths:\n- monday.db3\n- tuesday_0.db3\n");
  EXPECT_EQ(read_bag(folder.path()).messages.size(), 8U);
}

TEST(Rosbag2Folder, OfNumberedTrialsIsNoneUnlessARecorderCallsThemSo) {
  const TemporaryFolder folder;
  const fs::path runs = folder.path() / "runs";
  const fs::path run = folder.path() / "run";
  fs::create_directory(runs);
  fs::create_directory(run);
  for (const char* const name :
       {"runs/run_1.db3", "runs/run_2.db3", "run/run_1.db3", "run/run_2.db3"}) {
    database(folder, name, 2);
  }
  EXPECT_EQ(bag_kind(runs), BagKind::none);
  EXPECT_EQ(bag_kind(run), BagKind::folder);
}

TEST(Rosbag2Folder, WithoutRecordingsIsNone) {
  const TemporaryFolder folder;
  folder.write("metadata.yaml", "nothing: 1\n");
  EXPECT_EQ(bag_kind(folder.path()), BagKind::none);
  EXPECT_FALSE(read_bag(folder.path()).is_open);
}

TEST(BagMetadata, NamesAreCountedAsPeopleDo) {
  EXPECT_TRUE(counts_before("a_2", "a_10"));
  EXPECT_FALSE(counts_before("a_10", "a_2"));
  EXPECT_TRUE(counts_before("a_9", "b_1"));
  EXPECT_TRUE(counts_before("a", "a_0"));
  EXPECT_NE(counts_before("a_01", "a_1"), counts_before("a_1", "a_01"));
  EXPECT_FALSE(counts_before("a_1", "a_1"));
}

TEST(RealDatabases, HaveTheMessagesThatAreKnownOfThem) {
  const fs::path logs = test_support::shared_data() / "logs";
  if (!fs::exists(logs / "evo/tf_example.db3")) {
    GTEST_SKIP() << logs << " is not there";
  }
  const ReadBag tf = read_bag(logs / "evo/tf_example.db3");
  EXPECT_EQ(tf.messages.size(), 518U);
  EXPECT_TRUE(tf.said.empty());
  const ReadBag old = read_bag(logs / "plotjuggler/rosbag2_test_0.db3");
  EXPECT_EQ(old.messages.size(), 3U * 1565U);
  EXPECT_TRUE(old.said.empty());
  EXPECT_EQ(read_bag(logs / "plotjuggler").messages, old.messages)
      << "its folder, with metadata.yaml";
}

}  // namespace
}  // namespace tcert::recording
