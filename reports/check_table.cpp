#include "reports/check_table.hpp"

#include <fmt/format.h>

#include <table/clock_column.hpp>
#include <table/csv_write.hpp>
#include <table/printable.hpp>

#include "datasets/import/column_guess.hpp"
#include "datasets/import/source_kind.hpp"
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

/// "yaw [deg]", "range [mm]"; nothing for a column that is called like nothing of ours.
std::string may_be(const table::ColumnCheck& column) {
  if (table::is_clock_name(column.name)) {
    return "clock";
  }
  const auto guess = recording::guess_column(column.name, column.least, column.largest);
  std::string text(recording::to_string(guess.role));
  return text + (guess.unit.empty() || text.empty() ? "" : " [" + guess.unit + "]");
}

std::string writer_of_check(const table::CsvCheck& check) {
  std::vector<std::string> names;
  for (const table::ColumnCheck& column : check.columns) {
    names.push_back(column.name);
  }
  return std::string(recording::writer_of(names, check.header_line));
}

std::string roles_of(const table::CsvCheck& check) {
  std::string text;
  std::size_t others = 0;
  for (const table::ColumnCheck& column : check.columns) {
    const std::string role = may_be(column);
    if (role.empty()) {
      ++others;
    } else {
      text += (text.empty() ? "" : ", ") + table::printable(column.name) + ": " + role;
    }
  }
  return text + (others > 0 ? fmt::format("{}{} others", text.empty() ? "" : ", ", others) : "");
}

std::string fields_in_words(const recording::TopicSurvey& topic) {
  if (!topic.problem.empty()) {
    return topic.problem;
  }
  if (topic.role != recording::StreamRole::none) {
    return "";
  }
  constexpr std::size_t kMostShown = 12;
  std::string text;
  for (std::size_t i = 0; i < topic.fields.size() && i < kMostShown; ++i) {
    text += (text.empty() ? "" : ", ") + topic.fields[i];
  }
  return text + (topic.fields.size() > kMostShown ? ", ..." : "");
}

}  // namespace

Table csv_check_table(const table::CsvCheck& check, const std::string& file) {
  using Found = table::ColumnCheck;
  const auto columns =
      ColumnsOf<Found>()
          .text("column", "column", [](auto& c) { return table::printable(c.name); })
          .integer("numbers", "numbers", &Found::numbers)
          .integer("truths", "truth values", &Found::truths)
          .integer("missing", "missing", &Found::missing)
          .integer("texts", "texts", &Found::texts)
          .fixed("least", "least", "", 6, &Found::least)
          .fixed("largest", "largest", "", 6, &Found::largest)
          .text("may_be", "may be", may_be);
  Table table = columns.table("columns", "Columns of " + file, check.columns);
  table.footnotes.push_back(fmt::format(
      "{} rows, separator {}, {}, {} lines before it.",
      check.rows,
      table::separator_name(check.dialect.separator),
      check.header_line == 0 ? "no header" : fmt::format("header on line {}", check.header_line),
      check.preamble_records));
  if (const auto writer = writer_of_check(check); !writer.empty()) {
    table.footnotes.push_back("It looks like " + writer + ".");
  }
  if (check.clock) {
    table.footnotes.push_back(fmt::format(
        "Clock {} [{}]: from {:.6g} to {:.6g} s, median {:.4g} Hz (5th to 95th percentile "
        "{:.4g} to {:.4g}), longest gap {:.4g} s.",
        check.clock->column,
        check.clock->unit,
        check.clock->first_s,
        check.clock->last_s,
        check.clock->median_rate_hz,
        check.clock->least_rate_hz,
        check.clock->largest_rate_hz,
        check.clock->longest_gap_s));
  }
  return table;
}

Table topics_table(std::span<const recording::TopicSurvey> topics, const std::string& bag) {
  using Topic = recording::TopicSurvey;
  const auto seconds = [](const std::optional<std::int64_t>& time_ns) {
    std::string text;
    if (time_ns) {
      table::append_seconds(text, *time_ns);
    }
    return text;
  };
  Table table =
      ColumnsOf<Topic>()
          .text("topic", "topic", [](auto& t) { return table::printable(t.name); })
          .text("type", "type", [](auto& t) { return table::printable(t.type); })
          .integer("messages", "messages", &Topic::messages)
          .fixed("rate_hz", "rate", "Hz", 1, &Topic::rate_hz)
          .text("may_be", "may be", [](auto& t) { return std::string(to_string(t.role)); })
          .text("first_s", "first [s]", [&](auto& t) { return seconds(t.first_ns); })
          .text("last_s", "last [s]", [&](auto& t) { return seconds(t.last_ns); })
          .fixed("header_apart_s", "header, apart by", "s", 3, &Topic::header_apart_s)
          .integer("set_back", "set back", &Topic::set_back)
          .text("fields", "fields", fields_in_words)
          .table("topics", "Topics of " + bag, topics);
  table.footnotes = {
      "first, last: when messages were recorded (\"clock\": \"log\" in a map). header: the first "
      "stamp less that (\"clock\": \"header\"); a topic without one is lost by that clock."};
  return table;
}

Table csv_groups_table(std::span<const recording::CsvGroup> groups, const std::string& folder) {
  using Group = recording::CsvGroup;
  return ColumnsOf<Group>()
      .text("files", "files", &Group::pattern)
      .integer("number", "number", [](auto& g) { return g.files.size(); })
      .integer("rows", "rows of the first", [](auto& g) { return g.check.rows; })
      .text("clock",
            "clock",
            [](auto& g) {
              return g.check.clock
                         ? fmt::format("{} [{}]", g.check.clock->column, g.check.clock->unit)
                         : std::string(g.is_of_trials ? "a table of trials" : "");
            })
      .fixed("rate_hz",
             "rate",
             "Hz",
             1,
             [](auto& g) {
               return g.check.clock ? std::optional(g.check.clock->median_rate_hz) : std::nullopt;
             })
      .text("written_by", "written by", [](auto& g) { return writer_of_check(g.check); })
      .text("columns", "columns that may be", [](auto& g) { return roles_of(g.check); })
      .table("files", "CSV files of " + folder, groups);
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
