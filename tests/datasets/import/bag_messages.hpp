#pragma once
/// \file
/// All messages of a bag, and what was said of it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/bag.hpp"

namespace tcert::recording {

struct ReadMessage {
  std::string topic;
  std::int64_t log_ns = 0;
  std::string data;
  [[nodiscard]] bool operator==(const ReadMessage&) const = default;
};

struct ReadBag {
  bool is_open = false;
  std::vector<Topic> topics;
  std::vector<ReadMessage> messages;
  std::vector<std::string> said;  ///< At opening, then in the first pass.
  std::vector<std::string> said_again;

  /// How many lines hold `text`.
  [[nodiscard]] std::size_t says(const std::string& text) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        said, [&](const std::string& line) { return line.find(text) != std::string::npos; }));
  }
};

inline std::vector<std::string> lines_of(table::DiagnosticGroups& problems) {
  std::vector<std::string> lines;
  for (const table::Diagnostic& problem : problems.take()) {
    lines.push_back(table::to_string(problem));
  }
  return lines;
}

inline std::vector<ReadMessage> messages_of(Bag& bag, table::DiagnosticGroups& problems) {
  std::vector<std::size_t> all(bag.topics().size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<ReadMessage> messages;
  bag.for_each(
      all,
      [&](const RawMessage& message) {
        messages.push_back(
            {bag.topics()[message.topic].name,
             message.log_ns,
             {reinterpret_cast<const char*>(message.data.data()), message.data.size()}});
        return true;
      },
      problems);
  return messages;
}

/// Two passes, of which the second must show the same.
inline ReadBag read_bag(std::unique_ptr<Bag> bag, table::DiagnosticGroups& problems) {
  ReadBag read;
  read.is_open = bag != nullptr;
  if (bag) {
    read.messages = messages_of(*bag, problems);
    read.said = lines_of(problems);
    if (messages_of(*bag, problems) != read.messages) {
      read.said.emplace_back("a second pass shows other messages");
    }
    read.said_again = lines_of(problems);
    read.topics = bag->topics();
  } else {
    read.said = lines_of(problems);
  }
  return read;
}

inline ReadBag read_bag(const std::filesystem::path& path) {
  table::DiagnosticGroups problems;
  auto bag = open_bag(path, problems);
  return read_bag(std::move(bag), problems);
}

}  // namespace tcert::recording
