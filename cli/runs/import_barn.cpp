#include "datasets/import_barn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/errors.hpp"
#include "cli/import.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a feature table from public outcomes of the BARN challenge.

One row a trial: planner (or the date of the first commit that holds it), world, success, collided,
timeout, time_s, and the difficulty metrics of the world: m1 distance to the closest obstacle, m2
average visibility, m3 dispersion, m4 characteristic dimension, m5 tortuosity, as published and, where
the file has them, normalised. Worlds from 300 on have moving obstacles and are left out, as are worlds
without metrics; all that is left out is counted. A failure is censored at its time_s. The planners
ros2_maity and mppi_ros2 ran on another port with other limits; --same-port leaves them out.

Usage: tcert import barn --trials FILE --metrics FILE --output FILE [options]

Example:
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --output barn.csv
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --planners dwa,lics_ki \
      --output two.csv

Cost: one pass over the files.
)";

struct ImportOptions {
  std::string format;
  std::string trials;
  std::string metrics;
  std::string planners;
  bool same_port = false;
};

CommandLine command_line(ImportOptions& o) {
  CommandLine line{"import barn",
                   kText,
                   uses_output | uses_config,
                   po::options_description("Options"),
                   {{"FORMAT", &o.format}}};
  line.own.add_options()(
      "trials", input(o.trials, "FILE"), "outcomes: trials.csv or mlda_dated.csv")(
      "metrics", input(o.metrics, "FILE"), "difficulty_metrics.csv")(
      "planners",
      po::value(&o.planners)->value_name("NAMES"),
      "keep these, comma between; all if it is not given")(
      "same-port", po::bool_switch(&o.same_port), "leave out ros2_maity and mppi_ros2");
  return line;
}

table::TextTable table_of(const std::string& option, const std::string& file) {
  if (file.empty()) {
    throw UsageError("needs --" + option + " FILE");
  }
  if (!std::filesystem::exists(file)) {
    throw NoInput("no table at '" + file + "'");
  }
  table::TextTableResult result = table::read_text_table(std::filesystem::path(file), {"world"});
  for (table::Diagnostic& diagnostic : result.diagnostics) {
    // There is no bundle.json to rename columns in.
    const auto advice = diagnostic.expectation.find("; rename");
    diagnostic.expectation.resize(std::min(advice, diagnostic.expectation.size()));
  }
  say(result.diagnostics);
  if (!result.table) {
    throw BadData("'" + file + "' cannot be read");
  }
  return std::move(*result.table);
}

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  while (begin <= names.size() && !names.empty()) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    result.push_back(names.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

void require_known(const std::vector<std::string>& wanted, const std::vector<std::string>& known) {
  if (!wanted.empty() && known.empty()) {
    throw UsageError("--planners: the trials have no column planner");
  }
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError("--planners: no trial of '" + name + "'" + did_you_mean(name, known));
    }
  }
}

void report(const BarnSummary& s) {
  std::string groups;
  for (const auto& [name, rows] : s.groups) {
    groups += fmt::format("{}{} {}", groups.empty() ? "" : ", ", name, rows);
  }
  say(fmt::format("{} of {} trials written: {} successes, {} worlds, {} {}s ({})",
                  s.written,
                  s.read,
                  s.successes,
                  s.worlds,
                  s.groups.size(),
                  s.group,
                  groups));
  say(fmt::format(
      "left out: {} with errors, {} of planners not asked for, {} of another port, {} in "
      "worlds with moving obstacles, {} in worlds without metrics",
      s.bad,
      s.not_asked_for,
      s.other_ports,
      s.moving,
      s.unmeasured));
}

}  // namespace

int import_barn_command(Arguments arguments) {
  ImportOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (common.output.empty()) {
    throw UsageError("needs --output FILE");
  }
  require_own_file(common.output);
  const table::TextTable trials = table_of("trials", options.trials);
  const table::TextTable metrics = table_of("metrics", options.metrics);
  BarnImportOptions barn;
  barn.planners = split(options.planners);
  barn.other_ports = !options.same_port;
  require_known(barn.planners, planners_of(trials));
  if (options.same_port && planners_of(trials).empty()) {
    throw UsageError("--same-port: the trials have no column planner");
  }
  const BarnImportResult result =
      import_barn(trials, options.trials, metrics, options.metrics, barn);
  say(result.diagnostics);
  if (!common.quiet) {
    report(result.summary);
  }
  if (!result.csv) {
    const bool measured = result.summary.unmeasured == 0;
    throw BadData(measured ? "'" + options.trials + "' holds no trial that can be used"
                           : "'" + options.metrics + "' has no metrics for the worlds of '" +
                                 options.trials + "'");
  }
  Manifest manifest;
  manifest.command = "import barn";
  record(common, manifest);
  for (auto& [name, value] : manifest.options) {
    if (name == "trials" || name == "metrics") {
      value = name_of(value);  // without the machine's part of the path
    }
  }
  manifest.inputs = {{name_of(options.trials), digest_file(options.trials)},
                     {name_of(options.metrics), digest_file(options.metrics)}};
  write_with_manifest(common.output, *result.csv, std::move(manifest));
  return table::has_error(result.diagnostics) ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
