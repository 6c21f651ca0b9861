#pragma once
/// \file
/// What must hold of a bag, whatever its bytes are.

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/decoder.hpp"
#include "fuzz/check.hpp"

namespace tcert::fuzz {

inline void require_lines(table::DiagnosticGroups& problems) {
  for (const table::Diagnostic& diagnostic : problems.take()) {
    require(table::to_string(diagnostic).find('\n') == std::string::npos, "a message is one line");
  }
}

/// Reads and decodes every message, twice.
inline void read_twice(recording::Bag& bag, table::DiagnosticGroups& problems) {
  std::vector<std::optional<recording::Decoder>> decoders;
  std::vector<std::size_t> wanted;
  for (const recording::Topic& topic : bag.topics()) {
    std::string problem;
    decoders.push_back(recording::Decoder::of(topic, problem));
    require(decoders.back().has_value() != !problem.empty(), "a type that is not read says why");
    wanted.push_back(wanted.size());
  }
  std::size_t counts[2]{};
  recording::Value value;
  for (std::size_t& count : counts) {
    bag.for_each(
        wanted,
        [&](const recording::RawMessage& message) {
          ++count;
          require(message.topic < decoders.size(), "a message is of a topic");
          std::string problem;
          const auto& decoder = decoders[message.topic];
          if (decoder && !(*decoder)(message.data, value, problem)) {
            require(!problem.empty(), "a message that does not fit says why");
          }
          return true;
        },
        problems);
    require_lines(problems);
  }
  require(counts[0] == counts[1], "a second pass shows the same messages");
}

}  // namespace tcert::fuzz
