#include "datasets/import/sqlite_bag.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "datasets/import/chunk_contents.hpp"
#include "datasets/import/sqlite_database.hpp"
#include "datasets/import/sqlite_topics.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

constexpr std::string_view kWayOut =
    "; 'sqlite3 FILE .recover | sqlite3 NEW.db3' saves what can be saved";
constexpr std::string_view kZstdMagic = "\x28\xB5\x2F\xFD";

/// What a pass through the messages met and could not use.
struct Leftovers {
  std::size_t unlisted = 0;
  std::size_t untyped = 0;
  std::size_t packed = 0;
};

class SqliteBag final : public Bag {
 public:
  SqliteBag(Database database, std::string name)
      : database_(std::move(database)), name_(std::move(name)) {}

  /// False, with an error, if no message can be read.
  bool open(table::DiagnosticGroups& problems);

  [[nodiscard]] const std::vector<Topic>& topics() const override { return topics_.topics; }

  void for_each(std::span<const std::size_t> wanted,
                const MessageVisitor& visit,
                table::DiagnosticGroups& problems) override;

 private:
  void say(table::DiagnosticGroups& problems,
           Severity severity,
           std::string found,
           std::string expectation,
           std::size_t count = 1);
  bool count_messages(table::DiagnosticGroups& problems);
  bool show(const Query& rows, std::size_t topic, const MessageVisitor& visit, Leftovers& left);
  std::optional<std::size_t> topic_of(const Query& rows, Leftovers& left) const;
  void say_end(const Query& rows,
               bool in_order,
               std::size_t messages,
               table::DiagnosticGroups& problems);

  Database database_;
  std::string name_;
  SqliteTopics topics_;
  std::set<std::string> said_;  // expectations, each of which is said once
  ChunkExpander expander_;
};

void SqliteBag::say(table::DiagnosticGroups& problems,
                    Severity severity,
                    std::string found,
                    std::string expectation,
                    std::size_t count) {
  if (count > 0 && said_.insert(expectation).second) {
    problems.add({severity, name_, 0, "", std::move(found), std::move(expectation), count});
  }
}

bool SqliteBag::open(table::DiagnosticGroups& problems) {
  auto topics = sqlite_topics(database_);
  if (!topics) {
    say(problems,
        Severity::error,
        "",
        "an undamaged database of rosbag2, with its tables 'topics' and 'messages'");
    return false;
  }
  topics_ = std::move(*topics);
  if (!topics_.problem.empty()) {
    say(problems,
        Severity::warning,
        topics_.problem,
        "a table of topics that can be read to its end" + std::string(kWayOut));
  }
  return count_messages(problems);
}

std::optional<std::size_t> SqliteBag::topic_of(const Query& rows, Leftovers& left) const {
  const auto found = topics_.of_id.find(rows.integer(1));
  if (found == topics_.of_id.end()) {
    ++left.unlisted;
    return std::nullopt;
  }
  return found->second;
}

void SqliteBag::say_end(const Query& rows,
                        bool in_order,
                        std::size_t messages,
                        table::DiagnosticGroups& problems) {
  if (in_order && rows.problem().empty()) {
    return;
  }
  say(problems,
      messages > 0 ? Severity::warning : Severity::error,
      in_order ? rows.problem() : "rows in no order",
      "a table of messages that can be read to its end; the " + std::to_string(messages) +
          " messages before the damage are read" + std::string(kWayOut));
}

bool SqliteBag::count_messages(table::DiagnosticGroups& problems) {
  // In the order of their numbers, which a damaged tree would not keep to: it may lead in circles.
  Query rows = database_.query("SELECT rowid, topic_id FROM messages ORDER BY rowid");
  Leftovers left;
  std::size_t messages = 0;
  std::optional<std::int64_t> last;
  bool in_order = true;
  while (in_order && rows.next()) {
    in_order = !last || rows.integer(0) > *last;
    last = rows.integer(0);
    const auto topic = in_order ? topic_of(rows, left) : std::nullopt;
    if (topic) {
      ++topics_.topics[*topic].messages;
      ++messages;
    }
  }
  say_end(rows, in_order, messages, problems);
  say(problems,
      Severity::warning,
      "",
      "messages of topics in the table 'topics'; a message of another is left out",
      left.unlisted);
  return messages > 0 || (in_order && rows.problem().empty());
}

/// Hands one message on; false if the visitor wants no more.
bool SqliteBag::show(const Query& rows,
                     std::size_t topic,
                     const MessageVisitor& visit,
                     Leftovers& left) {
  if (!rows.is_integer(2) || !rows.is_blob(3)) {
    ++left.untyped;
    return true;
  }
  RawMessage message{topic, rows.integer(2), rows.integer(2), rows.blob(3)};
  const bool is_packed = message.data.size() >= kZstdMagic.size() &&
                         std::ranges::equal(message.data.first(kZstdMagic.size()),
                                            std::as_bytes(std::span(kZstdMagic)));
  if (is_packed) {  // No message begins so: the first bytes of CDR are 0.
    std::string ignored;
    const auto data = expander_.expand_zstd_frame(message.data, ignored);
    if (!data) {
      ++left.packed;
      return true;
    }
    message.data = *data;
  }
  return visit(message);
}

void SqliteBag::for_each(std::span<const std::size_t> wanted,
                         const MessageVisitor& visit,
                         table::DiagnosticGroups& problems) {
  std::vector<char> is_wanted(topics().size(), 0);
  for (const std::size_t topic : wanted) {
    is_wanted.at(topic) = 1;
  }
  Query rows =
      database_.query("SELECT rowid, topic_id, timestamp, data FROM messages ORDER BY rowid");
  Leftovers left;
  std::size_t messages = 0;
  std::optional<std::int64_t> last;
  bool in_order = true;
  bool goes_on = true;
  while (goes_on && in_order && rows.next()) {
    in_order = !last || rows.integer(0) > *last;
    last = rows.integer(0);
    const auto topic = in_order ? topic_of(rows, left) : std::nullopt;
    messages += topic ? 1 : 0;
    if (topic && is_wanted[*topic] != 0) {
      goes_on = show(rows, *topic, visit, left);
    }
  }
  expander_.release();
  say_end(rows, in_order, messages, problems);
  say(problems,
      Severity::warning,
      "",
      "messages with a whole number for their time and bytes for their data; another is left out",
      left.untyped);
  say(problems,
      Severity::warning,
      "",
      "messages whose zstd data can be expanded; another is left out",
      left.packed);
}

}  // namespace

bool begins_as_sqlite(std::string_view bytes) noexcept {
  using namespace std::string_view_literals;
  return bytes.starts_with("SQLite format 3\0"sv);
}

std::unique_ptr<Bag> open_sqlite_bag(const std::filesystem::path& path,
                                     table::DiagnosticGroups& problems) {
  std::string problem;
  auto database = Database::open(path, problem);
  if (!database) {
    problems.add({Severity::error,
                  path.string(),
                  0,
                  "",
                  "",
                  "a database that can be opened: " + problem,
                  1});
    return nullptr;
  }
  auto bag = std::make_unique<SqliteBag>(std::move(*database), path.string());
  return bag->open(problems) ? std::move(bag) : nullptr;
}

}  // namespace tcert::recording
