#include "cli/runs/check.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <table/atomic_file.hpp>
#include <table/check_csv.hpp>
#include <table/text_file.hpp>

#include "cli/runs/inputs.hpp"
#include "datasets/check_trial.hpp"
#include "datasets/import/carmen_log.hpp"
#include "datasets/import/draft_map.hpp"
#include "datasets/import/source_kind.hpp"
#include "datasets/values/check_course.hpp"
#include "datasets/values/check_sides.hpp"
#include "reports/check_table.hpp"
#include "reports/diagnostics_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

/// Trials that are read before their rows are added, in order.
constexpr std::size_t kBatch = 64;

/// Nothing that is there already is replaced.
void write_map(const CheckRequest& request, const recording::DraftedMap& map, Progress& progress) {
  if (std::filesystem::exists(request.write_map)) {
    throw table::WriteError(request.write_map + " is there already; name another file");
  }
  table::write_file_atomically(request.write_map, map.text);
  std::string text = "A map is drafted in " + request.write_map + ". Still to do:";
  for (const std::string& remark : map.remarks) {
    text += "\n- " + remark;
  }
  progress.sum_up(text + "\nThen: tcert import log " + request.path + " --map " +
                  request.write_map + " --output bundle");
}

/// The tables one after another, a blank line between them; where people read them, without one
/// that is empty. In JSON a list of both.
std::string text_of(const Table& found,
                    const Table& problems,
                    const OutputFormat& output,
                    const Progress& progress) {
  std::string first = shown(found, output, progress);
  std::string second = shown(problems, output, progress);
  switch (output.table_format()) {
    case TableFormat::json:
      for (std::string* const one : {&first, &second}) {
        one->erase(one->find_last_not_of('\n') + 1);
      }
      return "[" + first + ",\n" + second + "]\n";
    case TableFormat::csv:
    case TableFormat::jsonl:
      return first + '\n' + second;
    default:
      return problems.rows.empty() ? first : first + '\n' + second;
  }
}

/// `what` was checked: "trial".
ExitCode show(const Table& found,
              const Table& problems,
              const char* what,
              const OutputFormat& output,
              Progress& progress) {
  progress.show(text_of(found, problems, output, progress));
  std::map<std::string_view, std::size_t> count;
  for (const std::vector<TableCell>& row : problems.rows) {
    ++count[std::get<std::string>(row[1])];
  }
  const auto counted = [&](const char* word) {
    const std::size_t number = count[word];
    return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
  };
  progress.sum_up(fmt::format("{} {}{} checked: {}, {}, {}.",
                              found.rows.size(),
                              what,
                              found.rows.size() == 1 ? "" : "s",
                              counted("error"),
                              counted("warning"),
                              counted("note")));
  return count["error"] + count["warning"] > 0 ? exit_differences : exit_done;
}

Table problems_of(const std::vector<table::Diagnostic>& diagnostics) {
  Table problems = diagnostics_table(std::nullopt);
  for (const table::Diagnostic& diagnostic : diagnostics) {
    problems.add_row(diagnostics_row("", diagnostic));
  }
  return problems;
}

ExitCode check_file(const CheckRequest& request, Progress& progress) {
  table::CsvOptions csv;
  csv.decimal_comma = request.logs.decimal_comma;
  const table::CsvCheckResult result = table::check_csv_file(request.path, 1.0, csv, request.clock);
  if (!result.check) {
    progress.say(result.diagnostics);
    throw BadData(request.path + " cannot be read as CSV");
  }
  const ExitCode code = show(csv_check_table(*result.check, request.path),
                             problems_of(result.diagnostics),
                             "column",
                             request.output,
                             progress);
  if (!request.write_map.empty()) {
    recording::CsvGroup group;
    group.files = {request.path};
    group.check = *result.check;
    recording::DraftedMap map = recording::draft_map(std::span(&group, 1));
    write_map(request, map, progress);
  }
  return code;
}

ExitCode check_folder(const CheckRequest& request, Progress& progress) {
  table::DiagnosticGroups problems;
  const auto groups =
      recording::survey_csv(request.path, request.logs.decimal_comma, request.clock, problems);
  const auto has_clock = [&](const recording::CsvGroup& group) {
    return group.check.clock && group.check.clock->column == request.clock;
  };
  if (!request.clock.empty() && std::ranges::none_of(groups, has_clock)) {
    throw UsageError("--clock: found '" + request.clock + "', which is the clock of no file in " +
                     request.path);
  }
  const ExitCode code = show(csv_groups_table(groups, request.path),
                             problems_of(problems.take()),
                             "file kind",
                             request.output,
                             progress);
  if (!request.write_map.empty()) {
    write_map(request, recording::draft_map(groups), progress);
  }
  return code;
}

ExitCode check_bag(const CheckRequest& request, Progress& progress) {
  table::DiagnosticGroups problems;
  const auto bag = recording::open_bag(request.path, problems);
  if (!bag) {
    progress.say(problems.take());
    throw BadData(request.path + " cannot be read as a bag");
  }
  const auto topics = recording::survey_bag(*bag, problems);
  const ExitCode code = show(topics_table(topics, request.path),
                             problems_of(problems.take()),
                             "topic",
                             request.output,
                             progress);
  if (!request.write_map.empty()) {
    write_map(request, recording::draft_map(topics), progress);
  }
  return code;
}

ExitCode check_bundle(const CheckRequest& request, Progress& progress) {
  const OpenedBundle opened = open_for(request.path, request.logs, progress, SayDiagnostics::no);
  const auto label = synthetic_label(opened.bundle.info);
  Table trials = trial_check_table(label);
  Table problems = diagnostics_table(label);
  for (const table::Diagnostic& diagnostic : opened.diagnostics) {
    problems.add_row(diagnostics_row("", diagnostic));
  }
  for (const std::optional<table::Diagnostic>& one :
       {check_goal_is_known(opened.bundle.info.course), check_sides(opened.bundle.info.robot)}) {
    if (one) {
      problems.add_row(diagnostics_row("", *one));
    }
  }
  Stage stage(progress, "trials checked", opened.trials.size());
  for (std::size_t begin = 0; begin < opened.trials.size(); begin += kBatch) {
    std::vector<TrialCheckResult> batch(std::min(kBatch, opened.trials.size() - begin));
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
      batch[i] = check_trial(opened.bundle,
                             opened.bundle.trials[opened.trials[begin + i]],
                             {request.logs.repair},
                             opened.parameters.resample,
                             opened.parameters.certificate);
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const std::string& trial_id = opened.bundle.trials[opened.trials[begin + i]].trial_id;
      trials.add_row(trial_check_row(trial_id, batch[i].check));
      for (const table::Diagnostic& diagnostic : batch[i].diagnostics) {
        problems.add_row(diagnostics_row(trial_id, diagnostic));
      }
      stage.advance();
    }
  }
  trials.n = static_cast<std::int64_t>(opened.trials.size());
  return show(trials, problems, "trial", request.output, progress);
}

ExitCode check_carmen(const CheckRequest& request, Progress& progress) {
  const table::BytesResult file = table::read_text_file(request.path);
  if (!file.bytes) {
    throw BadData(request.path + ": " + file.problem);
  }
  table::DiagnosticGroups found;
  const CarmenLog log = read_carmen_log(*file.bytes, request.path, {}, found);
  const std::vector<table::Diagnostic> problems = found.take();
  progress.say(problems);
  progress.sum_up(fmt::format(
      "{} is a CARMEN log: {} of {} {} records can be used, {} ODOM and {} other records. 'tcert "
      "import carmen {} --output DIR' makes a bundle of it.",
      request.path,
      log.scans(),
      log.records,
      log.kind,
      log.odometry_records,
      log.other_records,
      request.path));
  const bool is_clean = std::ranges::all_of(problems, [](const table::Diagnostic& problem) {
    return problem.severity == table::Severity::note;
  });
  return is_clean ? exit_done : exit_differences;
}

}  // namespace

OptionTable options_of(CheckRequest& request) {
  OptionTable table(request.given);
  table.argument({"SOURCE", &request.path, true, OptionRole::input});
  table.add("clock", request.clock, "COLUMN", "of a CSV file: its clock, if the name does not say");
  table.add_output("write-map",
                   request.write_map,
                   "FILE",
                   "draft the map that 'import log' takes, to be looked through");
  add_common(table, request);
  return table;
}

ExitCode check(const CheckRequest& request, Progress& progress) {
  if (!std::filesystem::exists(request.path)) {
    throw NoInput("there is nothing at " + request.path);
  }
  using recording::SourceKind;
  const SourceKind kind = recording::source_kind(request.path);
  const bool takes_map =
      kind == SourceKind::bag || kind == SourceKind::csv || kind == SourceKind::csv_folder;
  if (!takes_map && !request.write_map.empty()) {
    throw UsageError("--write-map: " + request.path + " is no bag and no CSV file");
  }
  switch (kind) {
    case SourceKind::bundle:
      return check_bundle(request, progress);
    case SourceKind::bag:
      return check_bag(request, progress);
    case SourceKind::csv_folder:
      return check_folder(request, progress);
    case SourceKind::carmen:
      return check_carmen(request, progress);
    case SourceKind::barn:
      progress.sum_up(request.path +
                      " is result text of the BARN challenge: 'tcert import barn "
                      "--trials " +
                      request.path + " --metrics FILE --output FILE' reads it.");
      return exit_done;
    case SourceKind::json:
      throw BadData(request.path +
                    " is JSON, not a log: of a bundle name its folder; a map is checked by 'tcert "
                    "import log', a world by 'tcert world'");
    case SourceKind::csv:
    case SourceKind::binary:
    case SourceKind::unreadable:
      break;
  }
  return check_file(request, progress);
}

}  // namespace tcert::cli
