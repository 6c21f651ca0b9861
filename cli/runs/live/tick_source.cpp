#include "cli/runs/live/tick_source.hpp"

#include <table/csv_write.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "datasets/range_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kSaidInFull = 100;

}  // namespace

TickSource::TickSource(const Robot& robot,
                       const BundleInfo& info,
                       Options options,
                       StatusLines& status)
    : robot_(robot),
      options_(std::move(options)),
      status_(status),
      jumps_(robot.rays.size(), info.max_gap_s) {
  lines_.file = options_.name;
  lines_.max_gap_s = info.max_gap_s;
  lines_.trial_limit_s = info.trial_limit_s;
  lines_.decimal_comma = options_.decimal_comma;
  lines_.range_keys = info.range_keys;
  if (const auto renames = info.columns.find("ticks.csv"); renames != info.columns.end()) {
    lines_.rename = renames->second;
  }
}

void TickSource::say(const std::vector<table::Diagnostic>& problems) {
  if (bad_ > kSaidInFull) {
    return;
  }
  for (const table::Diagnostic& problem : problems) {
    status_.say(table::to_string(problem));
  }
  if (bad_ == kSaidInFull) {
    status_.say("tcert live: " + std::to_string(bad_) +
                " bad lines; further ones are only counted");
  }
}

void TickSource::reject(const std::string& problem) {
  ++bad_;
  say({{table::Severity::error, options_.name, number_, "", problem, "a tick", 1}});
}

// True if the line, which is the first of its kind, is a tick already.
bool TickSource::begin(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos || line[first] == '#') {
    return false;
  }
  table::DiagnosticGroups problems;
  if (parser_) {
    parser_->restart(line, problems);
  } else {
    parser_.emplace(robot_, line, lines_, problems);
  }
  const bool is_json = parser_->format() == TickLineFormat::json_lines;
  const bool unlike =
      (options_.format == "csv" && is_json) || (options_.format == "jsonl" && !is_json);
  const std::string expected =
      options_.format == "jsonl" ? "a JSON object" : "a header of ticks.csv";
  began_ = parser_->ready() && !unlike;
  if (began_) {
    say(problems.take());
    return is_json;
  }
  if (options_.must_begin_well) {
    say(problems.take());
    throw BadData(options_.name + ": the first line is not " + expected);
  }
  ++bad_;
  say({{table::Severity::error, options_.name, number_, "", "its first line", expected, 1}});
  return false;
}

std::span<const TickLine> TickSource::take(std::string_view line) {
  ++number_;
  if (!began_ && !begin(line)) {
    return {};
  }
  const auto read = parser_->parse(line, number_);
  if (!parser_->problems().empty()) {
    ++bad_;
    say(parser_->problems());
  }
  if (!read) {
    return {};
  }
  const JumpWatch::Verdict verdict = jumps_.take(*read);
  if (verdict.go_back_to_ns) {
    parser_->go_back_to(*verdict.go_back_to_ns);
  }
  if (verdict.refused_ns) {
    std::string seconds;
    table::append_seconds(seconds, *verdict.refused_ns);
    reject("a time of " + seconds + " s far ahead, which the next tick does not confirm");
  }
  return verdict.usable;
}

void TickSource::report_ranges() {
  if (parser_) {
    for (const table::Diagnostic& one :
         range_report(robot_, parser_->range_counts(), options_.name)) {
      status_.say(table::to_string(one));
    }
  }
}

}  // namespace tcert::cli
