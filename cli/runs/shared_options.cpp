#include "cli/runs/shared_options.hpp"

#include <table/nearest_name.hpp>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

std::vector<std::string> format_words() {
  std::vector<std::string> words;
  for (const TableFormat format : {TableFormat::text,
                                   TableFormat::markdown,
                                   TableFormat::csv,
                                   TableFormat::json,
                                   TableFormat::jsonl,
                                   TableFormat::latex}) {
    words.emplace_back(to_string(format));
  }
  return words;
}

}  // namespace

TableFormat OutputFormat::table_format() const {
  if (const auto known = table_format_from(format)) {
    return *known;
  }
  throw UsageError("--format: found '" + format + "', expected text, md, csv, json, jsonl or tex" +
                   did_you_mean(format, format_words()));
}

std::string shown(const Table& table, const OutputFormat& output, const Progress& progress) {
  return render(table, output.table_format(), width_of(output, progress));
}

std::size_t width_of(const OutputFormat& output, const Progress& progress) {
  return output.wide ? 0 : progress.width();
}

void add_output_path(OptionTable& table, OutputPath& output) {
  table.add_output("output", output.path, "PATH", "where to write; appears only when it is whole");
}

void add_format(OptionTable& table, OutputFormat& output) {
  table
      .add("format", output.format, "WORD", "of what is printed: text, md, csv, json, jsonl or tex")
      .one_of(format_words());
  table.add_process("wide", output.wide, "", "whole tables, wider than the terminal if need be");
}

void add_seed(OptionTable& table, std::int64_t& seed) {
  table.add("seed", seed, "N", "of all random draws; another seed is another sample")
      .within(0, 9.3e18);
}

void add_threads(OptionTable& table, std::int64_t& threads) {
  table
      .add_process(
          "threads", threads, "N", "0 takes all cores; the results are the same for any number")
      .within(0, 1024);
}

void add_logs(OptionTable& table, LogOptions& logs) {
  table.add("trials",
            logs.trials,
            "IDS",
            "only these: trial ids or patterns with * and ?, comma between");
  table.add("strict", logs.strict, "stop at the first rejected trial");
  table.add("repair",
            logs.repair,
            "drop, merge or sort bad rows, counted, and go on behind a clock that was set back, "
            "instead of "
            "rejecting their trial");
  add_decimal_comma(table, logs.decimal_comma);
  table.parameters(logs.parameters);
}

void add_decimal_comma(OptionTable& table, bool& decimal_comma) {
  table.add(
      "decimal-comma", decimal_comma, "numbers like 1,5 in files whose separator is the semicolon");
}

void require_values(const OptionTable& table) {
  require_ranges(table);
  if (const Option* const format = table.find("format")) {
    static_cast<void>(OutputFormat{text_of(format->value)}.table_format());
  }
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  const auto nearest = table::nearest_name(name, known);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace tcert::cli
