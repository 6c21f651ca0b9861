#pragma once
/// \file
/// Why a whole column cannot be read, where its cells show it.

#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>

namespace tcert {

/// Of a file that was rejected: adds an error that names the way out for wanted columns whose cells
/// all show it, judged by the first thousand rows.
///
/// - 0,5: a decimal comma, if the option for it takes effect with the file's separator.
/// - Times as dates (2021-01-31...), or too large for seconds: milliseconds, microseconds or
///   nanoseconds since 1970.
void add_column_hints(const table::Bytes& bytes,
                      const table::CsvOptions& csv,
                      const table::NumberOptions& wanted,
                      table::DiagnosticGroups& problems);

}  // namespace tcert
