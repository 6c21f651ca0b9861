#pragma once
/// \file
/// The models of H2: effects within each group, and whether they differ.

#include "analysis/study/h1/panel_data.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"

namespace tcert::study {

/// Fills odds and hazard ratios of every level. \pre `data` has groups, and the panel its levels.
void add_group_effects(const H1Data& data, double level, H2Panel& panel);

/// Fills `interactions`: predictor, groups and their products; Cox if there are times.
/// Also `mixed_interaction`, where clusters hold several trials.
void add_interactions(const H1Data& data, const std::string& cluster, H2Panel& panel);

}  // namespace tcert::study
