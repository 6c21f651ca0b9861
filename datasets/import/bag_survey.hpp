#pragma once
/// \file
/// What a bag holds, before anything is read from it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/message_role.hpp"

namespace tcert::recording {

struct TopicSurvey {
  std::string name;
  std::string type;
  StreamRole role = StreamRole::none;
  std::size_t messages = 0;
  std::optional<std::int64_t> first_ns;  ///< When the first and the last were recorded.
  std::optional<std::int64_t> last_ns;
  std::optional<double> rate_hz;         ///< Messages over the time between these.
  std::size_t set_back = 0;              ///< Recorded before the message before them.
  std::optional<double> header_apart_s;  ///< Of the first: its stamp less when it was recorded.
  std::vector<std::string> fields;       ///< Paths of numbers: "pose.pose.position.x".
  std::string problem;                   ///< Why its messages cannot be decoded; or empty.
};

/// One pass over all messages, of each topic the first decoded. In the order of the bag.
[[nodiscard]] std::vector<TopicSurvey> survey_bag(Bag& bag, table::DiagnosticGroups& problems);

/// "pose", "scan", ...; empty of none.
[[nodiscard]] std::string_view to_string(StreamRole role) noexcept;

}  // namespace tcert::recording
