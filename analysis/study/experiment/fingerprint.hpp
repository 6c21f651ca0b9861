#pragma once
/// \file
/// What of a parameter set a step of the way depends on: equal fingerprints, equal results.

#include <string>

#include "analysis/study/trials/parameters.hpp"

namespace tcert::study {

/// Lines "key=value" of every parameter that `stage` or a step before it depends on, in the order
/// of the parameter table. Overrides of the robot count as given, so the robot's own values are to
/// be kept beside it.
[[nodiscard]] std::string fingerprint(const ParameterSet& parameters, Stage stage);

}  // namespace tcert::study
