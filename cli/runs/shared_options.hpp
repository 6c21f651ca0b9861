#pragma once
/// \file
/// Options that requests share: how logs are read, where results go.

#include <string>

#include "cli/runs/option_table.hpp"
#include "cli/runs/progress.hpp"
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

struct OutputPath {
  std::string path;  ///< Empty: what is found is shown instead, if the run can.
};

struct OutputFormat {
  std::string format = "text";  ///< Of what is shown, or of one file.
  bool wide = false;            ///< Whole tables, however wide what they are shown on is.

  /// \throws UsageError for a word that is no format.
  [[nodiscard]] TableFormat table_format() const;
};

struct OutputOptions : OutputPath, OutputFormat {};

/// The table in the format, laid out for where it is shown.
[[nodiscard]] std::string shown(const Table& table,
                                const OutputFormat& output,
                                const Progress& progress);
/// Characters in a line of that, 0 for no end.
[[nodiscard]] std::size_t width_of(const OutputFormat& output, const Progress& progress);

void add_output_path(OptionTable& table, OutputPath& output);
void add_format(OptionTable& table, OutputFormat& output);
void add_seed(OptionTable& table, std::int64_t& seed);
void add_threads(OptionTable& table, std::int64_t& threads);
void add_logs(OptionTable& table, LogOptions& logs);
void add_decimal_comma(OptionTable& table, bool& decimal_comma);

/// The options of the members that a request shares with others by their names, in the order of the
/// help and of manifests: output, seed, threads, logs, decimal_comma.
template <class Request>
void add_common(OptionTable& table, Request& request) {
  table.common();
  if constexpr (requires { request.output.path; }) {
    add_output_path(table, request.output);
  }
  if constexpr (requires { request.output.format; }) {
    add_format(table, request.output);
  }
  if constexpr (requires { request.seed; }) {
    add_seed(table, request.seed);
  }
  if constexpr (requires { request.threads; }) {
    add_threads(table, request.threads);
  }
  if constexpr (requires { request.logs; }) {
    add_logs(table, request.logs);
  }
  if constexpr (requires { request.decimal_comma; }) {
    add_decimal_comma(table, request.decimal_comma);
  }
}

/// \throws UsageError for a number out of the range of its option, or a format that is none.
void require_values(const OptionTable& table);

/// "; did you mean 'x'?" or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace tcert::cli
