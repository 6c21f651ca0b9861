#pragma once
/// \file
/// What the commands that act on a certificate have in common: the tracking-error table, the risk
/// field, the rules that are monitored.

#include <optional>
#include <string>
#include <tcert/rule_formula.hpp>
#include <tcert/tracking_error.hpp>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/option_table.hpp"
#include "cli/runs/progress.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// Adds --tracking-error.
void add_tracking_error_option(OptionTable& table, std::string& path);

/// What else acts on ticks.
struct MonitorOptions {
  bool watch = false;  ///< The default rules, unless `rules` names a file.
  std::string rules;   ///< A file of them; watches them.
  bool risk = false;
};

/// Adds --monitor, --rules and --risk.
void add_monitor_options(OptionTable& table, MonitorOptions& options);

/// The rules of a file, or the default ones; none if none are asked for. \throws NoInput, BadData.
[[nodiscard]] std::vector<Rule> rules_of(const MonitorOptions& options);

/// The table of the file, or the declared one if `path` is empty. \throws NoInput, BadData.
[[nodiscard]] TrackingErrorTable tracking_error_table(const std::string& path,
                                                      bool decimal_comma,
                                                      Progress& progress);

/// A file as an input of the manifest; empty without one.
[[nodiscard]] std::optional<ManifestFile> tracking_error_input(const std::string& path);
[[nodiscard]] std::optional<ManifestFile> rules_input(const MonitorOptions& options);

/// \throws UsageError if the output would write over the file of rules.
void require_apart(const MonitorOptions& options, const std::string& output);

}  // namespace tcert::cli
