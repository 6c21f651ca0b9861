#pragma once
/// \file
/// What the provenance of an imported bundle says. Internal to import_log.cpp.

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/import/judge_trial.hpp"

namespace tcert::recording {

/// How much of the streams of all trials was used: "; pose: 201 of 201 rows used, ...".
[[nodiscard]] std::string use_in_words(const LogMap& map, const std::vector<ImportedTrial>& trials);

/// The names of the sources, of many the first ones.
[[nodiscard]] std::string places_in_words(const std::vector<std::filesystem::path>& sources);

}  // namespace tcert::recording
