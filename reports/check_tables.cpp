#include "reports/check_tables.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tcert {
namespace {

constexpr std::array<std::string_view, 3> kTypes = {"empty", "number", "text"};

TableCell integer(std::size_t value) { return static_cast<std::int64_t>(value); }

TableCell bool_or_missing(const std::optional<bool>& value) {
  return value ? TableCell{std::string(*value ? "yes" : "no")} : TableCell{};
}

TableCell number_or_missing(const std::optional<double>& value) {
  return value ? TableCell{Number{*value}} : TableCell{};
}

/// "pose 20.0 Hz; tactile 83.3 Hz".
std::string rates_of(const TrialSummary& trial) {
  std::string text;
  for (const StreamSummary& stream : trial.streams) {
    text += (text.empty() ? "" : "; ") + stream.name + " ";
    text += stream.rate_hz ? fixed(*stream.rate_hz, 1) + " Hz" : "NA";
  }
  return text;
}

}  // namespace

Table trials_table(std::span<const TrialSummary> trials) {
  Table table;
  table.name = "trials";
  table.title = "Trials";
  table.n = static_cast<std::int64_t>(trials.size());
  table.columns = {{"trial_id", "trial", "", ColumnKind::text},
                   {"rejected", "rejected", "", ColumnKind::text},
                   {"duration_s", "duration", "s", ColumnKind::number, 1},
                   {"distance_m", "distance", "m", ColumnKind::number, 2},
                   {"ticks", "ticks", "", ColumnKind::integer},
                   {"stale_ticks", "stale", "", ColumnKind::integer},
                   {"breaks", "breaks", "", ColumnKind::integer},
                   {"starts_in_start", "starts in S", "", ColumnKind::text},
                   {"ends_in_goal", "ends in G", "", ColumnKind::text},
                   {"streams", "streams", "", ColumnKind::text}};
  for (const TrialSummary& trial : trials) {
    if (trial.rejected) {
      std::vector<TableCell> cells(table.columns.size());
      cells[0] = trial.trial_id;
      cells[1] = std::string("yes");
      table.add_row(std::move(cells));
      continue;
    }
    table.add_row({trial.trial_id,
                   std::string("no"),
                   Number{trial.duration_s},
                   Number{trial.distance_m},
                   integer(trial.ticks),
                   integer(trial.stale_ticks),
                   integer(trial.breaks),
                   bool_or_missing(trial.starts_in_start),
                   bool_or_missing(trial.ends_in_goal),
                   rates_of(trial)});
  }
  return table;
}

Table columns_table(const CsvFileSummary& file) {
  Table table;
  table.name = "columns";
  table.title = "Columns";
  table.n = static_cast<std::int64_t>(file.rows);
  table.columns = {{"column", "column", "", ColumnKind::text},
                   {"type", "type", "", ColumnKind::text},
                   {"missing", "missing", "", ColumnKind::integer},
                   {"not_numbers", "not numbers", "", ColumnKind::integer},
                   {"smallest", "smallest", "", ColumnKind::number, 4},
                   {"largest", "largest", "", ColumnKind::number, 4},
                   {"constant", "constant", "", ColumnKind::text}};
  for (const ColumnSummary& column : file.columns) {
    table.add_row({column.name,
                   std::string(kTypes[static_cast<std::size_t>(column.type)]),
                   integer(column.missing),
                   integer(column.not_numbers),
                   number_or_missing(column.smallest),
                   number_or_missing(column.largest),
                   std::string(column.constant ? "yes" : "no")});
  }
  table.footnotes.push_back(
      "Separator: " + std::string(separator_name(file.dialect.separator)) + "; header in line " +
      (file.header_line == 0 ? "NA" : std::to_string(file.header_line)) + " after " +
      std::to_string(file.preamble_records) +
      " records; time column: " + (file.time_column.empty() ? "NA" : file.time_column) +
      "; gaps: " + std::to_string(file.gaps) +
      "; rows equal to the one before: " + std::to_string(file.repeated_rows) +
      ", but for the time: " + std::to_string(file.frozen_rows) + ".");
  return table;
}

}  // namespace tcert
