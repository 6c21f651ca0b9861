#pragma once
/// \file
/// What the two ways of finding a header share. Internal to csv_header.cpp and guess_header.cpp.

#include <string>
#include <table/csv_header.hpp>
#include <vector>

namespace tcert::table {

/// The decimal comma that was asked for, unless the comma separates.
[[nodiscard]] CsvDialect dialect_of(char separator, const CsvOptions& options);

void apply_renames(std::vector<std::string>& names, const CsvOptions& options);

/// In a bundle names are told apart without case, as SQL readers do; in any other table as R does.
void report_equal_names(const CsvHeader& header,
                        const CsvOptions& options,
                        DiagnosticGroups& problems);

void report_preamble(const CsvHeader& header,
                     const CsvOptions& options,
                     DiagnosticGroups& problems);

void report_no_record(const CsvOptions& options, DiagnosticGroups& problems);

}  // namespace tcert::table
