#pragma once
/// \file
/// What the database of a rosbag2 says of its topics.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/sqlite_database.hpp"

namespace tcert::recording {

struct SqliteTopics {
  std::vector<Topic> topics;  ///< Not counted. Of the same name, type and encoding one.
  std::map<std::int64_t, std::size_t> of_id;  ///< Index into `topics`, by the id in the database.
  std::string problem;                        ///< Why the table could not be read to its end.
};

/// Nothing if the database has not the tables of a recorder.
[[nodiscard]] std::optional<SqliteTopics> sqlite_topics(Database& database);

}  // namespace tcert::recording
