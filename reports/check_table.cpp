#include "reports/check_table.hpp"

#include <fmt/format.h>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

ColumnsOf<StreamCheck> rate_columns(const std::string& name) {
  return ColumnsOf<StreamCheck>().add(
      fixed_column(name + "_rate_hz", name, "Hz", 1), [](auto& stream) {
        return stream.median_rate_hz ? TableCell{Number{*stream.median_rate_hz, 1}} : TableCell{};
      });
}

/// What a trial that is not rejected has; of a merged log the rows of single streams are unknown.
ColumnsOf<TrialCheck> accepted_columns() {
  return ColumnsOf<TrialCheck>()
      .yes_or_no("starts_in_start", "starts in S", &TrialCheck::starts_in_start)
      .yes_or_no("ends_in_goal", "ends in G", &TrialCheck::ends_in_goal)
      .integer("pose_rows", "pose rows", [](auto& r) { return r.pose.rows; })
      .part(rate_columns("pose"), [](auto& r) { return &r.pose; })
      .integer(
          "tactile_rows", "tactile rows", [](auto& r) { return when(!r.merged, r.tactile.rows); })
      .part(rate_columns("tactile"), [](auto& r) { return &r.tactile; })
      .integer(
          "control_rows", "control rows", [](auto& r) { return when(!r.merged, r.control.rows); })
      .part(rate_columns("control"), [](auto& r) { return &r.control; })
      .integer("ticks", "ticks", &TrialCheck::ticks)
      .integer("stale_ticks", "stale", &TrialCheck::stale_ticks)
      .integer("breaks", "breaks", &TrialCheck::breaks)
      .fixed("duration_s", "duration", "s", 1, &TrialCheck::duration_s)
      .fixed("distance_m", "distance", "m", 2, &TrialCheck::distance_m);
}

struct NamedCheck {
  const std::string& trial_id;
  const TrialCheck& check;
};

ColumnsOf<NamedCheck> check_columns() {
  return ColumnsOf<NamedCheck>()
      .text("trial_id", "trial", [](auto& r) { return r.trial_id; })
      .yes_or_no("rejected", "rejected", [](auto& r) { return r.check.rejected; })
      .part(accepted_columns(), [](auto& r) { return r.check.rejected ? nullptr : &r.check; });
}

}  // namespace

Table csv_check_table(const table::CsvCheck& check, const std::string& file) {
  using Found = table::ColumnCheck;
  const auto columns = ColumnsOf<Found>()
                           .text("column", "column", &Found::name)
                           .integer("numbers", "numbers", &Found::numbers)
                           .integer("truths", "truth values", &Found::truths)
                           .integer("missing", "missing", &Found::missing)
                           .integer("texts", "texts", &Found::texts)
                           .fixed("least", "least", "", 6, &Found::least)
                           .fixed("largest", "largest", "", 6, &Found::largest);
  Table table = columns.table("columns", "Columns of " + file, check.columns);
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
  Table table = check_columns().table("trials", "Logs by trial");
  table.synthetic = synthetic;
  return table;
}

std::vector<TableCell> trial_check_row(const std::string& trial_id, const TrialCheck& check) {
  static const ColumnsOf<NamedCheck> columns = check_columns();
  return columns.row({trial_id, check});
}

}  // namespace tcert
