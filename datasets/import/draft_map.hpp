#pragma once
/// \file
/// A first map, from what a source holds, for somebody to look through and complete.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "datasets/import/bag_survey.hpp"
#include "datasets/import/csv_survey.hpp"

namespace tcert::recording {

/// A map as text, and what its reader has still to do. Values that nobody can guess (the width of
/// the body, the goal, the place of rays in columns) are null, so that 'import log' asks for them.
struct DraftedMap {
  std::string text;
  std::vector<std::string> remarks;  ///< "no topic is a pose: name one under 'pose'"
};

/// The pose is odometry, or else the first pose; rays are the scans, or else all ranges; control is
/// the first twist that is called a command, or else none.
[[nodiscard]] DraftedMap draft_map(std::span<const TopicSurvey> topics);

/// Streams by the names of columns; the clock and the units by their values.
[[nodiscard]] DraftedMap draft_map(std::span<const CsvGroup> groups);

}  // namespace tcert::recording
