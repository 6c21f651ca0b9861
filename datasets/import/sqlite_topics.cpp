#include "datasets/import/sqlite_topics.hpp"

#include <array>
#include <utility>

#include "datasets/import/message_type.hpp"

namespace tcert::recording {
namespace {

/// Of newer recorders; where they are not, the built-in types have to do.
void read_definitions(Database& database, std::vector<Topic>& topics) {
  constexpr std::array<std::string_view, 3> kColumns{
      "topic_type", "encoding", "encoded_message_definition"};
  if (!database.has_table("message_definitions", kColumns)) {
    return;
  }
  // One byte more than a definition may have, so that its reader says why it is refused.
  Query rows = database.query(
      "SELECT topic_type, encoding, substr(encoded_message_definition, 1, 1048577) "
      "FROM message_definitions LIMIT 65536");
  while (rows.next()) {
    const std::string type = canonical_type(rows.text(0));
    for (Topic& topic : topics) {
      if (topic.type == type && topic.definition_encoding.empty() && rows.text(1) != "unknown") {
        topic.definition_encoding = rows.text(1);
        topic.definition = rows.text(2);
      }
    }
  }
}

}  // namespace

std::optional<SqliteTopics> sqlite_topics(Database& database) {
  constexpr std::array<std::string_view, 4> kOfTopics{"id", "name", "type", "serialization_format"};
  constexpr std::array<std::string_view, 3> kOfMessages{"topic_id", "timestamp", "data"};
  if (!database.has_table("topics", kOfTopics) || !database.has_table("messages", kOfMessages)) {
    return std::nullopt;
  }
  SqliteTopics found;
  Query rows = database.query(
      "SELECT id, name, type, serialization_format FROM topics ORDER BY id LIMIT 65536");
  std::map<std::array<std::string, 3>, std::size_t> index;
  while (rows.next()) {
    Topic topic;
    topic.name = rows.text(1);
    topic.type = canonical_type(rows.text(2));
    topic.encoding = rows.text(3);
    const auto [place, is_new] =
        index.try_emplace({topic.name, topic.type, topic.encoding}, found.topics.size());
    if (is_new) {
      found.topics.push_back(std::move(topic));
    }
    found.of_id.try_emplace(rows.integer(0), place->second);
  }
  found.problem = rows.problem();
  read_definitions(database, found.topics);
  return found;
}

}  // namespace tcert::recording
