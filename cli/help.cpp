#include <array>
#include <cstddef>

#include "analysis/trials/parameters.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "reports/table.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText = R"(Print help: of the tool, of one command, or of the parameters.

Usage: tcert help [COMMAND | parameters]

Example:
  tcert help certify
  tcert help parameters --format md > parameters.md

Cost: none.
)";

constexpr std::string_view kVersionText = R"(Print the version and the commit of this build.

Usage: tcert version

Example:
  tcert version

Cost: none.
)";

constexpr std::array kCommands = {&kSimulate,
                                  &kImport,
                                  &kCheck,
                                  &kCertify,
                                  &kFit,
                                  &kHypotheses,
                                  &kAblate,
                                  &kSweep,
                                  &kReproduce,
                                  &kLive,
                                  &kHelp,
                                  &kVersion};

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
         "\n'tcert COMMAND --help' describes one command, 'tcert help parameters' every "
         "parameter.\n";
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
  const ParameterSet defaults;
  for (const ParameterInfo& parameter : parameter_table()) {
    table.add_row({std::string(parameter.key),
                   parameter.get(defaults),
                   std::string(parameter.unit),
                   std::string(to_string(parameter.stage)),
                   parameter.accepts,
                   std::string(parameter.doc)});
  }
  table.footnotes = {
      "Precedence: these defaults, then the bundle's own parameters, then --config, then flags."};
  return table;
}

int run_help(Arguments arguments) {
  CommonOptions common;
  std::string topic;
  CommandLine line{
      "help", kText, uses_format, po::options_description{}, {{"COMMAND", &topic, false}}};
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  if (topic.empty()) {
    print(overview());
    return exit_done;
  }
  if (topic == "parameters") {
    print(render(parameter_listing(), common.table_format()));
    return exit_done;
  }
  std::vector<std::string> known = {"parameters"};
  for (const Command* command : commands()) {
    if (command->name == topic) {
      const std::array<std::string, 1> help = {"--help"};
      return command->run(help);
    }
    known.emplace_back(command->name);
  }
  throw UsageError("no help on '" + topic + "'" + did_you_mean(topic, known));
}

int run_version(Arguments arguments) {
  CommonOptions common;
  if (parse({"version", kVersionText, 0, po::options_description{}, {}}, common, arguments)) {
    print("tcert " + std::string(tool_version()) + " (" + std::string(tool_commit()) + ")\n");
  }
  return exit_done;
}

}  // namespace

const Command kHelp = {"help", "explain a command or the parameters", run_help};
const Command kVersion = {"version", "print the version of this build", run_version};

std::span<const Command* const> commands() { return kCommands; }

}  // namespace tcert::cli
