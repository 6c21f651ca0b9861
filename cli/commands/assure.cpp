#include "cli/commands/assure.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kAssureText =
    R"(Assure that what guards a robot sees the faults that it is to see.

perturb: a bundle once more, with faults of sensors and links in its logs, and a list of them.
monitor: what rules detect of them and of truly unsafe times, how often they cry wolf, what it costs.

Usage: tcert assure perturb BUNDLE --output DIR [options]
       tcert assure monitor BUNDLE [options]

'tcert assure perturb --help' and so on list the options.

Example:
  tcert assure perturb driven --wide-per-hour 20 --output faulty
  tcert assure monitor faulty --output assurance/

Cost: one pass over the logs.
)";

/// Of an assurance without a kind that is known.
struct AssureRequest {
  std::string kind;
  std::vector<std::string> given;
};

struct AssureKind {
  std::string_view name;
  int (*run)(Arguments);
  CommandForm (*form)();
};

constexpr std::array kAssureKinds{
    AssureKind{"perturb", assure_perturb_command, assure_perturb_form},
    AssureKind{"monitor", assure_monitor_command, assure_monitor_form}};

std::vector<std::string> assure_words() {
  std::vector<std::string> words;
  for (const AssureKind& kind : kAssureKinds) {
    words.emplace_back(kind.name);
  }
  return words;
}

OptionTable options_of(AssureRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, assure_words()});
  return table;
}

int run_assure(Arguments arguments) {
  for (const std::string& argument : arguments) {
    const auto* const kind = std::ranges::find(kAssureKinds, argument, &AssureKind::name);
    if (kind != kAssureKinds.end()) {
      return kind->run(arguments);
    }
  }
  AssureRequest request;
  Manner manner;
  if (parse(kAssureText, options_of(request), manner, arguments)) {
    std::string expected;
    for (const std::string& word : assure_words()) {
      expected += (expected.empty() ? "" : " or ") + word;
    }
    throw UsageError("unknown kind '" + request.kind + "', expected " + expected +
                     did_you_mean(request.kind, assure_words()));
  }
  return exit_done;
}

std::vector<CommandForm> assure_forms() {
  std::vector<CommandForm> forms{form_for<AssureRequest>(kAssureText)};
  for (const AssureKind& kind : kAssureKinds) {
    forms.push_back(kind.form());
  }
  return forms;
}

}  // namespace

const Command kAssure = {
    "assure",
    "assure perturb: faults in the logs of a bundle; assure monitor: what rules detect",
    run_assure,
    assure_forms};

}  // namespace tcert::cli
