#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <table/check_csv.hpp>

#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "datasets/check_trial.hpp"
#include "reports/check_table.hpp"
#include "reports/diagnostics_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Look at logs before anything is computed from them: a bundle, or any single CSV file.

Of a bundle: each trial's streams, rates, gaps, and whether it starts in S and ends in G, and what no
working ray does: a contact that never ends though the ray reads free, a reading that never moves,
two rays that are one. Of a CSV file: its dialect, header and columns, and the clock of a stream: a
table of trials has none, but its times are looked at: a stamp among durations, stamps alone. Then
every problem, with file, line, column, what was found and what was expected. Ends with 1 if there is
a warning or an error, with 0 otherwise.

Usage: tcert check BUNDLE|FILE [options]

Example:
  tcert check corpus
  tcert check run.csv.gz --format json

Cost: one pass over the logs.
)";

/// Trials that are read before their rows are added, in order.
constexpr std::size_t kBatch = 64;

CommandLine command_line(std::string& path) {
  return {"check",
          kText,
          uses_parameters | uses_format | uses_threads | uses_trials | uses_logs,
          po::options_description("Options"),
          {{"BUNDLE|FILE", &path}}};
}

/// The tables one after another; a blank line between them where people read them.
int print_tables(const Table& found, const Table& problems, const CommonOptions& common) {
  const TableFormat format = common.table_format();
  if (format == TableFormat::json) {
    std::string first = render(found, format);
    std::string second = render(problems, format);
    for (std::string* text : {&first, &second}) {
      text->erase(text->find_last_not_of('\n') + 1);
    }
    print("[" + first + ",\n" + second + "]\n");
  } else {
    print(render(found, format) + "\n" + render(problems, format));
  }
  const auto is_problem = [](const std::vector<TableCell>& row) {
    return std::get<std::string>(row[1]) != "note";
  };
  return std::ranges::any_of(problems.rows, is_problem) ? exit_differences : exit_done;
}

int check_file(const std::string& path, const CommonOptions& common) {
  table::CsvOptions csv;
  csv.decimal_comma = common.decimal_comma;
  const table::CsvCheckResult result = table::check_csv_file(path, 1.0, csv);
  if (!result.check) {
    say(result.diagnostics);
    throw BadData(path + " cannot be read as CSV");
  }
  Table problems = diagnostics_table(std::nullopt);
  for (const table::Diagnostic& diagnostic : result.diagnostics) {
    problems.add_row(diagnostics_row("", diagnostic));
  }
  return print_tables(csv_check_table(*result.check, path), problems, common);
}

int check_bundle(const std::string& path, const CommonOptions& common) {
  const OpenedBundle opened = open_for(path, common, SayDiagnostics::no);
  const auto label = synthetic_label(opened.bundle.info);
  Table trials = trial_check_table(label);
  Table problems = diagnostics_table(label);
  for (const table::Diagnostic& diagnostic : opened.diagnostics) {
    problems.add_row(diagnostics_row("", diagnostic));
  }
  Progress progress("trials checked", opened.trials.size(), common.quiet);
  for (std::size_t begin = 0; begin < opened.trials.size(); begin += kBatch) {
    std::vector<TrialCheckResult> batch(std::min(kBatch, opened.trials.size() - begin));
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
      batch[i] = check_trial(opened.bundle,
                             opened.bundle.trials[opened.trials[begin + i]],
                             {common.repair},
                             opened.parameters.resample,
                             opened.parameters.certificate);
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const std::string& trial_id = opened.bundle.trials[opened.trials[begin + i]].trial_id;
      trials.add_row(trial_check_row(trial_id, batch[i].check));
      for (const table::Diagnostic& diagnostic : batch[i].diagnostics) {
        problems.add_row(diagnostics_row(trial_id, diagnostic));
      }
      progress.advance();
    }
  }
  trials.n = static_cast<std::int64_t>(opened.trials.size());
  return print_tables(trials, problems, common);
}

int run(Arguments arguments) {
  std::string path;
  CommonOptions common;
  if (!parse(command_line(path), common, arguments)) {
    return exit_done;
  }
  if (!std::filesystem::exists(path)) {
    throw NoInput("there is nothing at " + path);
  }
  const bool is_bundle = std::filesystem::is_directory(path) || path.ends_with(".zip");
  return is_bundle ? check_bundle(path, common) : check_file(path, common);
}

}  // namespace

const Command kCheck = {"check", "look at logs before anything is computed from them", run};

}  // namespace tcert::cli
