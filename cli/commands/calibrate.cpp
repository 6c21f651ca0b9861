#include "cli/commands/calibrate.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCalibrateText =
    R"(Calibrate what a robot feels with, and how well it keeps its path.

rays: bends beside measured clearances become the calibrations of a bundle's rays, with a lower bound
that holds on a new day.
tracking: runs beside their nominal paths become the buffers of a robot; a model of it, a table of bounds.
guards: driven trials become a speed law with thresholds, judged on other days.

Usage: tcert calibrate rays PAIRS [options]
       tcert calibrate tracking (RUNS | --model WORD) [options]
       tcert calibrate guards BUNDLE [options]

'tcert calibrate rays --help' and so on list the options.

Example:
  tcert calibrate rays pairs.csv --bundle logs --output calibration/
  tcert calibrate tracking runs.csv --output buffers/
  tcert calibrate guards driven --output guards/

Cost: a second for a million pairs.
)";

/// Of a calibration without a kind that is known.
struct CalibrateRequest {
  std::string kind;
  std::vector<std::string> given;
};

struct CalibrateKind {
  std::string_view name;
  int (*run)(Arguments);
  CommandForm (*form)();
};

constexpr std::array kCalibrateKinds{
    CalibrateKind{"rays", calibrate_rays_command, calibrate_rays_form},
    CalibrateKind{"tracking", calibrate_tracking_command, calibrate_tracking_form},
    CalibrateKind{"guards", calibrate_guards_command, calibrate_guards_form}};

std::vector<std::string> calibrate_words() {
  std::vector<std::string> words;
  for (const CalibrateKind& kind : kCalibrateKinds) {
    words.emplace_back(kind.name);
  }
  return words;
}

OptionTable options_of(CalibrateRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, calibrate_words()});
  return table;
}

int run_calibrate(Arguments arguments) {
  for (const std::string& argument : arguments) {
    const auto* const kind = std::ranges::find(kCalibrateKinds, argument, &CalibrateKind::name);
    if (kind != kCalibrateKinds.end()) {
      return kind->run(arguments);
    }
  }
  CalibrateRequest request;
  Manner manner;
  if (parse(kCalibrateText, options_of(request), manner, arguments)) {
    throw UsageError("unknown kind '" + request.kind + "', expected rays, tracking or guards" +
                     did_you_mean(request.kind, calibrate_words()));
  }
  return exit_done;
}

std::vector<CommandForm> calibrate_forms() {
  std::vector<CommandForm> forms{form_for<CalibrateRequest>(kCalibrateText)};
  for (const CalibrateKind& kind : kCalibrateKinds) {
    forms.push_back(kind.form());
  }
  return forms;
}

}  // namespace

const Command kCalibrate = {
    "calibrate",
    "calibrate rays, tracking buffers and guards from data, each with what it bounds",
    run_calibrate,
    calibrate_forms};

}  // namespace tcert::cli
