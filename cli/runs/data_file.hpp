#pragma once
/// \file
/// A table that a command is given: read, its problems said, its label and digest kept.

#include <optional>
#include <string>
#include <string_view>
#include <table/data_table.hpp>
#include <vector>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"
#include "cli/runs/written_options.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/manifest.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

struct DataFile {
  std::string path;
  table::DataTable table;
  std::optional<SyntheticLabel> synthetic;  ///< By the column synthetic_seed.
};

/// Reads the columns called `wanted`, all if it is empty. \throws NoInput if there is no file,
/// BadData if it is not a table.
[[nodiscard]] DataFile read_data_file(const std::string& path,
                                      std::vector<std::string> wanted,
                                      bool decimal_comma,
                                      Progress& progress);

/// The label of a table that holds a column synthetic_seed, as every table made from synthetic data
/// does.
[[nodiscard]] std::optional<SyntheticLabel> label_of(const table::DataTable& table);

/// The manifest of a command that read one table.
[[nodiscard]] Manifest manifest_of(std::string command,
                                   const DataFile& file,
                                   WrittenOptions written);

/// \throws UsageError that lists the tables unless `table` is empty or one of them.
void require_table(const FitReport& report, const std::string& table);

/// "1,2.5,3" as numbers. \throws UsageError that names the option.
[[nodiscard]] std::vector<double> numbers_of(const std::string& option, const std::string& list);

/// "a,b" as words; empty ones are left out.
[[nodiscard]] std::vector<std::string> words_of(const std::string& list);

}  // namespace tcert::cli
