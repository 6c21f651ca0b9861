#pragma once
/// \file
/// The options of `tcert replay` and of H3 on a bundle: which speed laws, which tracking error.

#include <string>

#include "analysis/study/replay/replay_trial.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ReplayLawOptions {
  std::string laws = "squash,clip";
  std::string betas = "5,10,20";
  std::string tracking_error;
};

void add_replay_law_options(OptionTable& table, ReplayLawOptions& options);

/// The laws of a list. \throws UsageError for an unknown one.
[[nodiscard]] std::vector<SpeedLawKind> speed_laws_of(const std::string& list);

/// \throws UsageError for an unknown law or a beta that is not above 0; NoInput, BadData of the
/// tracking-error table.
[[nodiscard]] study::ReplaySetup replay_setup(const ReplayLawOptions& options,
                                              const study::ParameterSet& parameters,
                                              bool decimal_comma,
                                              Progress& progress);

}  // namespace tcert::cli
