#pragma once
/// \file
/// The rows of a foreign CSV file as samples of a stream, by the map.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <table/csv_header.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// A row: where a value has no number, NaN; infinite ones as they are.
struct CsvSample {
  std::optional<std::int64_t> time_ns;  ///< Empty if its cell is no time.
  std::span<const double> values;  ///< Of the sources, in their order; none of a row of another
                                   ///< length than the header. Valid during the call.
  std::size_t line = 0;
  std::string_view trial;  ///< The cell of the map's column of trials; valid during the call.
};

using CsvSampleSink = std::function<void(const CsvSample&)>;

/// Sources of a stream that are columns: those of `stream`, or of a scan one for each i of
/// "ranges{i}" that `header` has from 0 on, every so many of them.
[[nodiscard]] std::vector<ValueSource> sources_of(const StreamSource& stream,
                                                  const table::CsvHeader& header);

/// Shows every row of a file. Columns that are not there, a clock that is not found, and a row of
/// another length than the header are errors or counted warnings with their line; cells that are
/// no numbers are NaN, counted as a warning per column. `header` points into the file's bytes.
/// \returns false if a column or the clock is missing: then nothing was shown.
[[nodiscard]] bool read_csv_stream(const std::string& file,
                                   const table::CsvHeader& header,
                                   const StreamSource& stream,
                                   const std::vector<ValueSource>& sources,
                                   const std::string& trial_column,
                                   const CsvSampleSink& sink,
                                   table::DiagnosticGroups& problems);

}  // namespace tcert::recording
