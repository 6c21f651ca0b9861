#include "datasets/tick_line.hpp"

#include <algorithm>
#include <cmath>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/decimal.hpp>
#include <table/flat_json.hpp>
#include <table/nearest_name.hpp>
#include <utility>

namespace tcert {

namespace {

std::string_view without_spaces_before(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

}  // namespace

TickLineParser::TickLineParser(const Robot& robot,
                               std::string_view first_line,
                               TickLineOptions options,
                               table::DiagnosticGroups& problems)
    : options_(std::move(options)),
      columns_(tick_columns(robot)),
      row_(columns_.columns.size(), kMissing),
      rules_(robot, options_.range_keys),
      readings_(robot.rays.size()),
      counts_(robot.rays.size()) {
  restart(first_line, problems);
}

void TickLineParser::restart(std::string_view first_line, table::DiagnosticGroups& problems) {
  restarted_ = last_ns_.has_value();
  names_.clear();
  if (without_spaces_before(first_line).starts_with('{')) {
    format_ = TickLineFormat::json_lines;
    has_footing_ = true;  // any line may have it
    ready_ = true;
    names_.push_back(columns_.time_column);
    for (const table::NumberColumn& column : columns_.columns) {
      names_.push_back(column.name);
    }
    return;
  }
  format_ = TickLineFormat::csv;
  for (const std::string_view name : {"pitch_rad", "roll_rad", "step_m", "slip"}) {
    has_footing_ = has_footing_ || first_line.find(name) != std::string_view::npos;
  }
  table::CsvOptions csv;
  csv.file = options_.file;
  csv.rename = options_.rename;
  csv.preamble_records = 0;
  csv.fold_names = true;
  csv.decimal_comma = options_.decimal_comma;
  const table::Bytes header_bytes = table::Bytes::copy_of(first_line);
  const auto header =
      table::find_header(header_bytes.view(), csv, table::required_names(columns_), problems);
  ready_ = header.has_value();
  if (header) {
    names_ = header->names;
    plan_ = table::plan_row(*header, columns_);
  }
}

void TickLineParser::reject(std::string column, std::string_view value, std::string expectation) {
  problems_.push_back({table::Severity::error,
                       options_.file,
                       line_,
                       std::move(column),
                       table::shortened(value),
                       std::move(expectation),
                       1});
}

bool TickLineParser::parse_csv(std::string_view text) {
  padded_.assign(text);
  table::CsvCursor cursor{padded_.view().data(), padded_.view().data() + text.size(), line_};
  row_problems_.cells.clear();
  row_problems_.fields = 0;
  row_problems_.open_quote = false;
  if (table::scan_row(plan_, cursor, &time_ns_, row_.data(), row_problems_)) {
    return true;
  }
  if (row_problems_.open_quote) {
    reject("", "a quote that is never closed", "a closing quote");
  } else if (row_problems_.fields != 0) {
    reject("",
           std::to_string(row_problems_.fields) + " fields",
           std::to_string(names_.size()) + " fields");
  }
  for (const table::CellProblem& cell : row_problems_.cells) {
    const bool is_time = plan_.cells[cell.cell].kind == table::CellKind::seconds;
    reject(names_[cell.cell], cell.value, is_time ? "a time in seconds" : "a finite number");
  }
  return false;
}

bool TickLineParser::parse_json(std::string_view text) {
  const std::optional<std::vector<table::FlatMember>> members = table::parse_flat_json(text);
  if (!members) {
    reject("", text, "one JSON object without nesting, each key once");
    return false;
  }
  const std::size_t most = 2 * names_.size() + 16;
  if (members->size() > most) {
    reject("",
           std::to_string(members->size()) + " keys",
           "the keys of a tick, at most " + std::to_string(names_.size()));
    return false;
  }
  std::ranges::fill(row_, kMissing);
  std::vector<bool> given(names_.size(), false);
  for (const table::FlatMember& member : *members) {
    const auto name = std::ranges::find(names_, member.key);
    if (name == names_.end()) {
      const auto nearest = table::nearest_name(member.key, names_);
      reject(table::shortened(member.key),
             "",
             nearest ? "a known key; did you mean '" + *nearest + "'?" : "a known key");
    } else if (member.kind != table::FlatMember::Kind::null) {
      const auto position = static_cast<std::size_t>(name - names_.begin());
      given[position] = true;
      take_json_value(position, member);
    }
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!given[i] && (i == 0 || !columns_.columns[i - 1].may_be_empty)) {
      reject(names_[i], "", i == 0 ? "a time in seconds" : "a finite number");
    }
  }
  return problems_.empty();
}

// The names of JSON keys are the time and then the columns.
void TickLineParser::take_json_value(std::size_t position, const table::FlatMember& member) {
  const bool is_number = member.kind != table::FlatMember::Kind::other;
  if (!is_number && position > 0 && columns_.columns[position - 1].may_be_infinite) {
    const double value = table::read_cell(member.text).value;
    if (std::isinf(value)) {
      row_[position - 1] = value;
      return;
    }
  }
  padded_.assign(member.text);
  const char* const begin = padded_.view().data();
  const char* const end = begin + member.text.size();
  if (position == 0) {
    if (!is_number || table::scan_seconds(begin, '.', time_ns_) != end) {
      reject(names_[0], member.text, "a time in seconds");
    }
  } else if (!is_number || table::scan_number(begin, '.', row_[position - 1]) != end) {
    reject(names_[position], member.text, "a finite number");
  }
}

bool TickLineParser::is_too_late(std::int64_t time_ns) const noexcept {
  return options_.trial_limit_s && first_ns_ &&
         static_cast<double>(time_ns - *first_ns_) > 1e10 * *options_.trial_limit_s;
}

void TickLineParser::go_back_to(std::int64_t time_ns) noexcept {
  last_ns_ = time_ns;
  ran_too_long_ = ran_too_long_ && is_too_late(time_ns);
}

std::optional<TickLine> TickLineParser::to_tick() {
  TickRow row;
  if (const char* bad_flag = interpret_tick(row_, rules_, readings_, counts_, row);
      bad_flag != nullptr) {
    reject(bad_flag, "", "0 or 1");
    return std::nullopt;
  }
  if (last_ns_ && time_ns_ <= *last_ns_) {
    std::string found;
    table::append_seconds(found, time_ns_);
    found += " after ";
    table::append_seconds(found, *last_ns_);
    reject(columns_.time_column,
           found,
           restarted_ ? "a time after the last of the producer before: times go on"
                      : "a time after that of the row before");
    return std::nullopt;
  }
  const bool gap = last_ns_ && static_cast<double>(time_ns_ - *last_ns_) > options_.max_gap_s * 1e9;
  first_ns_ = first_ns_.value_or(time_ns_);
  const bool too_long = !ran_too_long_ && is_too_late(time_ns_);
  ran_too_long_ = ran_too_long_ || too_long;
  last_ns_ = time_ns_;
  const bool starts_anyway = row.segment_start || restarted_;
  restarted_ = false;
  return TickLine{
      {time_ns_, row.pose, readings_, row.stale, starts_anyway || gap || too_long, row.footing},
      row.speed_cmd_mps,
      row.yaw_rate_cmd_rps,
      gap,
      starts_anyway,
      has_footing_,
      too_long};
}

std::optional<TickLine> TickLineParser::parse(std::string_view text, std::size_t line) {
  problems_.clear();
  line_ = line;
  while (text.ends_with('\n') || text.ends_with('\r')) {
    text.remove_suffix(1);
  }
  const std::string_view content = without_spaces_before(text);
  if (content.empty() || text.starts_with('#')) {
    return std::nullopt;
  }
  const bool good = format_ == TickLineFormat::csv ? parse_csv(text) : parse_json(content);
  return good ? to_tick() : std::nullopt;
}

}  // namespace tcert
