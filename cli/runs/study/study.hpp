#pragma once
/// \file
/// `study`: how often the tool itself is right, on data whose truth is known.

#include "cli/runs/errors.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct StudyRequest {
  std::string study;    ///< "soundness" or another of those that options_of() has.
  std::string terrain;  ///< A file, for the scenarios of `terrain`; without it random terrains.
  std::int64_t worlds = 100000;
  std::int64_t hard = 10000;
  std::int64_t u_turns = 10000;
  std::int64_t driven = 0;
  bool witness = false;
  std::string methods;                    ///< Comma between; empty: all.
  double reading_bound_m = 0.01;          ///< Taken off readings in the methods that take some off.
  std::string readings = "both";          ///< "exact", "noisy" or "both".
  std::optional<std::int64_t> data_sets;  ///< None: as many as the study usually has.
  std::optional<std::int64_t> replicates;
  std::int64_t terrains = 1000;
  std::int64_t seeds = 20;
  std::string table;
  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] std::vector<std::string> study_names();

[[nodiscard]] OptionTable options_of(StudyRequest& request);

/// The same bytes for any number of threads. \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode study(const StudyRequest& request, Progress& progress);
/// The same of items that were made elsewhere.
[[nodiscard]] ExitCode study(const StudyRequest& request,
                             Progress& progress,
                             const ItemSource& source);

/// None of a study that cannot be made in pieces. \throws UsageError.
[[nodiscard]] std::vector<ItemSet> items_of(const StudyRequest& request, Progress& progress);

}  // namespace tcert::cli
