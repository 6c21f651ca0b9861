#include <array>
#include <cstddef>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/command_line.hpp"
#include "cli/commands/output.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"
#include "reports/edges_table.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"
#include "reports/table.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Print help: of the tool, of one command or kind, of the parameters, or of the results' columns.

Usage: tcert help [COMMAND [KIND] | parameters | columns]

Example:
  tcert help certify
  tcert help fit cox
  tcert help parameters --format md > parameters.md
  tcert help columns

Cost: none.
)";

constexpr std::string_view kVersionText = R"(Print the version and the commit of this build.

Usage: tcert version

Example:
  tcert version

Cost: none.
)";

constexpr std::array kCommands = {&kSimulate, &kImport,     &kCheck,  &kCertify, &kWorld,
                                  &kFit,      &kHypotheses, &kAblate, &kSweep,   &kReplay,
                                  &kExplore,  &kGate,       &kStudy,  &kReport,  &kReproduce,
                                  &kFigures,  &kVerify,     &kLive,   &kHelp,    &kVersion};

std::string overview() {
  std::string text =
      "tcert: traversability certificates from what a robot felt, per tick, and what they "
      "predict.\n\n"
      "Usage: tcert COMMAND [options]\n\n"
      "Example:\n"
      "  tcert reproduce --output results\n\n"
      "Commands:\n";
  for (const Command* command : commands()) {
    const std::string name(command->name);
    text += "  " + name + std::string(12 - name.size(), ' ') + std::string(command->summary) + '\n';
  }
  return text +
         "\nExit codes: 0 done; 1 a check found something; 2 wrong usage; 3 done, but some trials, "
         "cells or\nlines were rejected; 4 to 8 ends of 'explore'; 65 bad data; 66 no such input; "
         "70 a "
         "fault of this tool;\n71 the system has too little of something (memory, descriptors, "
         "threads); 73 cannot write.\n"
         "\n'tcert COMMAND --help' describes one command, 'tcert help parameters' every "
         "parameter, 'tcert help columns' every column of the results.\n";
}

Table parameter_listing() {
  Table table;
  table.name = "parameters";
  table.title = "Parameters: in config files, as flags (--KEY VALUE) and with --set KEY=VALUE";
  table.columns = {{"key", "key", "", ColumnKind::text},
                   {"default", "default", "", ColumnKind::text},
                   {"unit", "unit", "", ColumnKind::text},
                   {"stage", "changes from", "", ColumnKind::text},
                   {"accepts", "accepts", "", ColumnKind::text},
                   {"doc", "what, and when to change it", "", ColumnKind::text}};
  const study::ParameterSet defaults;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    table.add_row({std::string(parameter.key),
                   parameter.get(defaults),
                   std::string(parameter.unit),
                   std::string(study::to_string(parameter.stage)),
                   parameter.accepts,
                   std::string(parameter.doc)});
  }
  table.footnotes = {
      "Precedence: these defaults, then the bundle's own parameters, then --config, then flags."};
  return table;
}

Table column_listing() {
  Table table;
  table.name = "columns";
  table.title = "Columns of the files that 'tcert certify' writes";
  table.columns = {{"file", "file", "", ColumnKind::text},
                   {"column", "column", "", ColumnKind::text},
                   {"unit", "unit", "", ColumnKind::text},
                   {"doc", "what", "", ColumnKind::text}};
  const auto append = [&](const char* file, const std::vector<ColumnDoc>& columns) {
    for (const ColumnDoc& column : columns) {
      table.add_row({std::string(file), column.name, column.unit, column.doc});
    }
  };
  append("series/<trial_id>.csv", series_columns());
  append("edges/<trial_id>.csv", edge_column_docs());
  append("features.csv", feature_column_docs());
  append("certificates.csv", certificate_column_docs());
  table.footnotes = {"An empty cell is a value that is not known."};
  return table;
}

struct HelpRequest {
  std::string topic;
  std::string kind;
  OutputFormat output;
  std::vector<std::string> given;
};

OptionTable options_of(HelpRequest& request) {
  OptionTable table(request.given);
  table.argument({"COMMAND", &request.topic, false});
  table.argument({"KIND", &request.kind, false});
  add_common(table, request);
  return table;
}

int run_help(Arguments arguments) {
  HelpRequest request;
  Manner manner;
  if (!parse(kText, options_of(request), manner, arguments)) {
    return exit_done;
  }
  const auto& [topic, kind, output, given] = request;
  if (topic.empty()) {
    print(overview());
    return exit_done;
  }
  if (topic == "parameters") {
    print(render(parameter_listing(), output.table_format()));
    return exit_done;
  }
  if (topic == "columns") {
    print(render(column_listing(), output.table_format()));
    return exit_done;
  }
  std::vector<std::string> known = {"parameters", "columns"};
  for (const Command* command : commands()) {
    if (command->name == topic) {
      std::vector<std::string> help;
      if (!kind.empty()) {
        help.push_back(kind);
      }
      help.emplace_back("--help");
      return command->run(help);
    }
    known.emplace_back(command->name);
  }
  throw UsageError("no help on '" + topic + "'" + did_you_mean(topic, known));
}

int run_version(Arguments arguments) {
  std::vector<std::string> given;
  Manner manner;
  if (parse(kVersionText, OptionTable(given).common(), manner, arguments)) {
    print("tcert " + std::string(tool_version()) + " (" + std::string(tool_commit()) + ")\n");
  }
  return exit_done;
}

}  // namespace

const Command kHelp = {"help", "explain a command or the parameters", run_help};
const Command kVersion = {"version", "print the version of this build", run_version};

std::span<const Command* const> commands() { return kCommands; }

}  // namespace tcert::cli
