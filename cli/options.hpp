#pragma once
/// \file
/// Options that commands share, and the one way in which flags and config files are read.

#include <boost/program_options.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/option_role.hpp"
#include "reports/manifest.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

namespace po = boost::program_options;

/// Which of the common options a command takes; or'ed.
enum CommonUse : unsigned {
  uses_config = 1U << 0U,
  uses_parameters = 1U << 7U,  ///< --config, --set and every key of the parameter table.
  uses_output = 1U << 1U,
  uses_format = 1U << 2U,
  uses_seed = 1U << 3U,
  uses_threads = 1U << 4U,
  uses_trials = 1U << 5U,
  uses_logs = 1U << 6U,           ///< --repair, --strict, --decimal-comma.
  uses_decimal_comma = 1U << 9U,  ///< --decimal-comma alone.
};

struct CommonOptions {
  std::string output;
  std::string format = "text";
  std::int64_t seed = 1;
  std::int64_t threads = 0;  ///< 0: as many as there are cores.
  std::string trials;        ///< Ids or patterns, comma between; empty: all.
  bool strict = false;
  bool repair = false;
  bool decimal_comma = false;
  bool quiet = false;
  std::string config;  ///< Of the parameters: what it says is in file_parameters.

  Settings file_parameters;        ///< Parameters of the config file, in its order.
  Settings flag_parameters;        ///< Of --set and of flags, in their order.
  std::vector<std::string> given;  ///< Names of the options that were set, by flag or file.
  Settings effective;              ///< Options that shape the result, with their values.

  std::vector<ManifestArgument> arguments;  ///< A command line that gives the same result.

  /// \pre the format was checked by parse().
  [[nodiscard]] TableFormat table_format() const;
};

struct Positional {
  std::string name;  ///< As the usage line has it: "BUNDLE".
  std::string* value = nullptr;
  bool required = true;
  OptionRole role = OptionRole::shapes;
};

/// How a command is called.
struct CommandLine {
  std::string_view name;
  std::string_view help;  ///< Purpose, usage, example, cost; the options are listed below it.
  unsigned common = 0;    ///< CommonUse.
  po::options_description own{"Options"};
  std::vector<Positional> positional;
  std::vector<std::string>* rest = nullptr;  ///< Takes all arguments after those, if not null.
};

/// Reads flags, then the config file for what the flags leave open. False if help was asked for and
/// has been printed. \throws UsageError with the nearest known name for an unknown one; NoInput if
/// the config file cannot be read; WriteError if nothing can appear at --output
/// (require_output_place).
[[nodiscard]] bool parse(const CommandLine& line, CommonOptions& common, Arguments arguments);

/// Options and arguments, into the manifest.
void record(const CommonOptions& common, Manifest& manifest);

/// \throws UsageError unless low <= value <= high.
void require_range(std::string_view option, double value, double low, double high);

/// "; did you mean 'x'?" or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace tcert::cli
