#pragma once
/// \file
/// All figures that a tree of results allows.

#include <optional>
#include <string>
#include <vector>

#include "reports/figure/figure.hpp"
#include "reports/figure/trial_figures.hpp"
#include "reports/results/results.hpp"

namespace tcert {

/// A figure that the results do not allow, and what is missing.
struct MissingFigure {
  std::string name;
  std::string reason;
};

struct StudyFigures {
  std::vector<Figure> figures;
  std::vector<MissingFigure> missing;
};

/// Every figure of the study, in the order of the paper; not those of single trials.
/// \throws MissingResult if a file is there and cannot be read.
[[nodiscard]] StudyFigures study_figures(const Results& results);

/// What is drawn of a trial; empty if its series was not kept or there is no such trial. Its world
/// is looked for in the corpus of the tree. \throws MissingResult.
[[nodiscard]] std::optional<TrialPicture> trial_picture(const Results& results,
                                                        const std::string& trial_id);

/// A few trials to show: the issued certificate in the middle of all, the tightest one, and the
/// first failure.
[[nodiscard]] std::vector<std::string> typical_trials(const Results& results);

}  // namespace tcert
