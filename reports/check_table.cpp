#include "reports/check_table.hpp"

#include <fmt/format.h>

namespace tcert {
namespace {

TableCell count(std::size_t value) { return static_cast<std::int64_t>(value); }

TableCell number_or_missing(const std::optional<double>& value) {
  return value ? TableCell{Number{*value}} : TableCell{};
}

TableCell yes_or_no(const std::optional<bool>& value) {
  return value ? TableCell{std::string(*value ? "yes" : "no")} : TableCell{};
}

TableCell rate(const StreamCheck& stream) {
  return stream.median_rate_hz ? TableCell{Number{*stream.median_rate_hz, 1}} : TableCell{};
}

}  // namespace

Table csv_check_table(const table::CsvCheck& check, const std::string& file) {
  Table table;
  table.name = "columns";
  table.title = "Columns of " + file;
  table.columns = {{"column", "column", "", ColumnKind::text},
                   {"numbers", "numbers", "", ColumnKind::integer},
                   {"truths", "truth values", "", ColumnKind::integer},
                   {"missing", "missing", "", ColumnKind::integer},
                   {"texts", "texts", "", ColumnKind::integer},
                   {"least", "least", "", ColumnKind::number, 6},
                   {"largest", "largest", "", ColumnKind::number, 6}};
  for (const table::ColumnCheck& column : check.columns) {
    table.add_row({column.name,
                   count(column.numbers),
                   count(column.truths),
                   count(column.missing),
                   count(column.texts),
                   number_or_missing(column.least),
                   number_or_missing(column.largest)});
  }
  table.footnotes.push_back(fmt::format(
      "{} rows, separator {}, {}, {} lines before it.",
      check.rows,
      table::separator_name(check.dialect.separator),
      check.header_line == 0 ? "no header" : fmt::format("header on line {}", check.header_line),
      check.preamble_records));
  if (check.clock) {
    table.footnotes.push_back(
        fmt::format("Clock {}: from {:.6g} to {:.6g} s, median {:.4g} Hz (5th to 95th percentile "
                    "{:.4g} to {:.4g}), longest gap {:.4g} s.",
                    check.clock->column,
                    check.clock->first_s,
                    check.clock->last_s,
                    check.clock->median_rate_hz,
                    check.clock->least_rate_hz,
                    check.clock->largest_rate_hz,
                    check.clock->longest_gap_s));
  }
  return table;
}

Table trial_check_table(const std::optional<SyntheticLabel>& synthetic) {
  Table table;
  table.name = "trials";
  table.title = "Logs by trial";
  table.synthetic = synthetic;
  table.columns = {{"trial_id", "trial", "", ColumnKind::text},
                   {"rejected", "rejected", "", ColumnKind::text},
                   {"pose_rows", "pose rows", "", ColumnKind::integer},
                   {"pose_rate_hz", "pose", "Hz", ColumnKind::number, 1},
                   {"tactile_rows", "tactile rows", "", ColumnKind::integer},
                   {"tactile_rate_hz", "tactile", "Hz", ColumnKind::number, 1},
                   {"control_rows", "control rows", "", ColumnKind::integer},
                   {"control_rate_hz", "control", "Hz", ColumnKind::number, 1},
                   {"ticks", "ticks", "", ColumnKind::integer},
                   {"stale_ticks", "stale", "", ColumnKind::integer},
                   {"breaks", "breaks", "", ColumnKind::integer},
                   {"duration_s", "duration", "s", ColumnKind::number, 1},
                   {"distance_m", "distance", "m", ColumnKind::number, 2},
                   {"starts_in_start", "starts in S", "", ColumnKind::text},
                   {"ends_in_goal", "ends in G", "", ColumnKind::text}};
  return table;
}

std::vector<TableCell> trial_check_row(const std::string& trial_id, const TrialCheck& check) {
  if (check.rejected) {
    std::vector<TableCell> row(15);
    row[0] = trial_id;
    row[1] = std::string("yes");
    return row;
  }
  const auto rows = [&check](const StreamCheck& stream) {
    return check.merged ? TableCell{} : count(stream.rows);
  };
  return {trial_id,
          std::string("no"),
          count(check.pose.rows),
          rate(check.pose),
          rows(check.tactile),
          rate(check.tactile),
          rows(check.control),
          rate(check.control),
          count(check.ticks),
          count(check.stale_ticks),
          count(check.breaks),
          number_or_missing(check.duration_s),
          number_or_missing(check.distance_m),
          yes_or_no(check.starts_in_start),
          yes_or_no(check.ends_in_goal)};
}

}  // namespace tcert
