#include <array>
#include <cstddef>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/completion.hpp"
#include "cli/commands/generated_file.hpp"
#include "cli/commands/help_topics.hpp"
#include "cli/commands/manual.hpp"
#include "cli/commands/output.hpp"
#include "cli/commands/overview.hpp"
#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/kind_options.hpp"
#include "cli/runs/shared_options.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kHelpText =
    R"(Print help: of the tool, of one command or kind, or of a topic.

TOPIC is one of
  parameters  every parameter with its unit, default and bounds
  columns     every column of the results of each tick and trial
  bundle      the files of a log bundle: columns, units, what is required, frames
  man         a page of the manual, that of PAGE (certify, import-carmen, parameters); with --output DIR
              all pages, as DIR/man1/tcert.1 and so on
  completion  completion of commands and options for SHELL: bash, zsh or fish; with --output a file

Packages install the manual and the completions. The world file is described by 'tcert help world'.

Usage: tcert help [COMMAND [KIND]]
       tcert help (parameters | columns | bundle) [--format WORD]
       tcert help man [PAGE] [--output DIR]
       tcert help completion SHELL [--output FILE]

Example:
  tcert help certify
  tcert help fit cox
  tcert help parameters --format md > parameters.md
  tcert help man certify | man -l -
  source <(tcert help completion bash)

Cost: none.
)";

constexpr std::string_view kVersionText = R"(Print the version and the commit of this build.

Usage: tcert version

Example:
  tcert version

Cost: none.
)";

constexpr std::array kCommands = {&kSimulate, &kDrive,  &kImport,   &kCalibrate,  &kCheck,
                                  &kCertify,  &kWorld,  &kFit,      &kHypotheses, &kAblate,
                                  &kSweep,    &kReplay, &kFederate, &kExplore,    &kGate,
                                  &kAssure,   &kStudy,  &kBatch,    &kReport,     &kReproduce,
                                  &kFigures,  &kVerify, &kLive,     &kHelp,       &kVersion};

struct HelpRequest {
  std::string topic;
  std::string kind;
  OutputOptions output;
  std::vector<std::string> given;
};

/// What help can be asked for.
std::vector<std::string> topics() {
  std::vector<std::string> all;
  for (const HelpTopic& topic : help_topics()) {
    all.emplace_back(topic.name);
  }
  all.insert(all.end(), {"man", "completion"});
  for (const Command* const command : commands()) {
    all.emplace_back(command->name);
  }
  return all;
}

std::vector<std::string> kinds() {
  std::vector<std::string> all = kind_names();
  for (const CompletionShell& shell : completion_shells()) {
    all.push_back(shell.name);
  }
  return all;
}

OptionTable options_of(HelpRequest& request) {
  OptionTable table(request.given);
  table.argument({"COMMAND", &request.topic, false, OptionRole::shapes, topics()});
  table.argument({"KIND", &request.kind, false, OptionRole::shapes, kinds()});
  add_common(table, request);
  return table;
}

void show_manual(const HelpRequest& request) {
  const std::vector<ManualPage> pages = manual();
  if (!request.output.path.empty()) {
    if (!request.kind.empty()) {
      throw UsageError("--output writes all pages; leave out '" + request.kind + "'");
    }
    for (const ManualPage& page : pages) {
      write_generated(request.output.path + '/' + page.path(), page.text, kManualMark);
    }
    return;
  }
  const std::string wanted = request.kind.empty() ? "tcert" : "tcert-" + request.kind;
  std::vector<std::string> names;
  for (const ManualPage& page : pages) {
    if (page.name == wanted || page.name == request.kind) {
      print(page.text);
      return;
    }
    names.push_back(page.name);
  }
  throw UsageError("no page '" + wanted + "'" + did_you_mean(wanted, names));
}

void show_completion(const HelpRequest& request) {
  for (const CompletionShell& shell : completion_shells()) {
    if (shell.name == request.kind) {
      const std::string script = shell.script(all_forms());
      if (request.output.path.empty()) {
        print(script);
      } else {
        write_generated(request.output.path, script, completion_mark(shell.name));
      }
      return;
    }
  }
  throw UsageError("completion: found '" + request.kind + "', expected bash, zsh or fish");
}

int run_help(Arguments arguments) {
  HelpRequest request;
  Manner manner;
  if (!parse(kHelpText, options_of(request), manner, arguments)) {
    return exit_done;
  }
  const auto& [topic, kind, output, given] = request;
  if (topic == "man") {
    show_manual(request);
    return exit_done;
  }
  if (topic == "completion") {
    show_completion(request);
    return exit_done;
  }
  if (!output.path.empty()) {
    throw UsageError("--output is for 'help man' and 'help completion'");
  }
  if (topic.empty()) {
    print(overview());
    return exit_done;
  }
  for (const HelpTopic& one : help_topics()) {
    if (one.name == topic) {
      print(shown(one.table(), output, TerminalProgress(manner.quiet)));
      return exit_done;
    }
  }
  for (const Command* command : commands()) {
    if (command->name == topic) {
      std::vector<std::string> help;
      if (!kind.empty()) {
        help.push_back(kind);
      }
      help.emplace_back("--help");
      return command->run(help);
    }
  }
  throw UsageError("no help on '" + topic + "'" + did_you_mean(topic, topics()));
}

int run_version(Arguments arguments) {
  std::vector<std::string> given;
  Manner manner;
  if (parse(kVersionText, OptionTable(given).common(), manner, arguments)) {
    print("tcert " + std::string(tool_version()) + " (" + std::string(tool_commit()) + ")\n");
  }
  return exit_done;
}

std::vector<CommandForm> help_forms() { return {form_for<HelpRequest>(kHelpText)}; }

std::vector<CommandForm> version_forms() {
  std::vector<std::string> given;
  return {form_of(kVersionText, OptionTable(given).common())};
}

}  // namespace

const Command kHelp = {"help", "explain a command, the parameters or a file", run_help, help_forms};
const Command kVersion = {"version", "print the version of this build", run_version, version_forms};

std::span<const Command* const> commands() { return kCommands; }

}  // namespace tcert::cli
