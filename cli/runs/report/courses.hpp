#pragma once
/// \file
/// The courses of the trials of a result: worlds of the bundle that it was made from.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/bundle.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {

class Courses {
 public:
  /// The bundle at `path`, or the corpus of the tree if `path` is empty. A bundle whose trials.csv
  /// is not the one that `certified` was made from is left out if it is the tree's, and refused if
  /// it was named. \throws BadData, NoInput.
  Courses(const Results& results, const Result& certified, const std::string& path);

  /// Why no course is known at all; empty if some may be.
  [[nodiscard]] const std::string& missing() const noexcept { return missing_; }

  /// True if the bundle has a world file of the trial.
  [[nodiscard]] bool has_walls(std::string_view trial_id) const;

  /// world_block() of the trial's world; without a world file S and G alone. Empty without a
  /// bundle. From any thread. \throws BadData if the file is not a world.
  [[nodiscard]] std::optional<std::string> block(std::string_view trial_id) const;

 private:
  [[nodiscard]] std::string file_of(std::string_view trial_id) const;

  std::optional<Bundle> bundle_;
  std::map<std::string, std::string, std::less<>> world_of_;  ///< By trial.
  std::string missing_;
};

}  // namespace tcert::cli
