#pragma once
/// \file
/// Options that requests share: how logs are read, where results go.

#include <string>

#include "cli/runs/option_table.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

/// Which logs are read, how, and under which parameters.
struct LogOptions {
  std::string trials;  ///< Ids or patterns, comma between; empty: all.
  bool strict = false;
  bool repair = false;
  bool decimal_comma = false;
  ParameterChanges parameters;
};

struct OutputOptions {
  std::string path;             ///< Empty: there is text to print instead.
  std::string format = "text";  ///< Of that text, or of one file.

  /// \throws UsageError for a word that is no format.
  [[nodiscard]] TableFormat table_format() const;
};

// The order of these calls is that of the help and of manifests: output, format, seed, threads,
// logs. `OptionTable::common()` comes before them.
void add_output_path(OptionTable& table, OutputOptions& output);
void add_format(OptionTable& table, OutputOptions& output);
void add_seed(OptionTable& table, std::int64_t& seed);
void add_threads(OptionTable& table, std::int64_t& threads);
void add_logs(OptionTable& table, LogOptions& logs);
void add_decimal_comma(OptionTable& table, bool& decimal_comma);

/// \throws UsageError for a number out of the range of its option, or a format that is none.
void require_values(const OptionTable& table);

/// "; did you mean 'x'?" or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace tcert::cli
