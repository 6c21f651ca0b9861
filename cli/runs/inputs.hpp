#pragma once
/// \file
/// Opening a bundle for a command: its problems said, its trials chosen, its parameters settled.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"
#include "datasets/bundle.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

enum class SayDiagnostics { yes, no };

struct OpenedBundle {
  Bundle bundle;
  std::vector<table::Diagnostic> diagnostics;  ///< Of bundle.json and trials.csv.
  std::vector<std::size_t> trials;             ///< Indices of those chosen with --trials.
  LogOptions logs;                             ///< As it was opened.
  study::ParameterSet parameters;
};

/// Says the problems of bundle.json and trials.csv, unless the caller lists them itself;
/// those of a bundle that cannot be used are always said.
/// \throws NoInput if there is nothing at `path`; BadData if it is not a bundle, or under --strict
/// has a bad row in trials.csv; UsageError if --trials chooses nothing or a parameter is wrong.
[[nodiscard]] OpenedBundle open_for(const std::string& path,
                                    const LogOptions& logs,
                                    Progress& progress,
                                    SayDiagnostics say_diagnostics = SayDiagnostics::yes);

/// Defaults, then those of the bundle, of the config file, of the flags. \throws BadData,
/// UsageError.
[[nodiscard]] study::ParameterSet effective_parameters(
    const std::map<std::string, std::string>& of_bundle, const ParameterChanges& changes);

/// The bundle's robot with the overrides in place. \throws UsageError if that is no robot.
[[nodiscard]] Robot effective_robot(const BundleInfo& info, const study::ParameterSet& parameters);

/// Every parameter with its value, for the manifest: overrides of the robot as they take effect.
[[nodiscard]] Settings as_settings(const study::ParameterSet& parameters, const Robot& robot);

/// True if `name` matches a pattern in which * stands for any text and ? for one character.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view name) noexcept;

}  // namespace tcert::cli
